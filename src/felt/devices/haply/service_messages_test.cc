#include "felt/devices/haply/service_messages.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace felt::haply::service_messages_test {
namespace {

using Json = nlohmann::json;

Json vector(double x, double y, double z) {
  return {{"x", x}, {"y", y}, {"z", z}};
}

Json state_message(double x, double y, double z) {
  return {{"session_id", 7},
          {"inverse3",
           {{{"device_id", "0001"}, {"state", {{"cursor_position", vector(9, 9, 9)}}}},
            {{"status", {{"calibrated", true}, {"ready", true}}},
             {"state",
              {{"cursor_position", vector(x, y, z)},
               {"cursor_velocity", vector(-1, 0.5, 0)},
               {"angular_position", {{"a0", 1}}},
               {"current_cursor_force", vector(0, 0, 1.5)},
               {"transform", Json::object()}}},
             {"device_id", "049D"}}}},
          {"verse_grip",
           {{{"device_id", "61548"},
             {"state", {{"buttons", {{"a", true}, {"b", false}, {"c", true}}}, {"hall", 3}}}}}}};
}

RC_GTEST_PROP(StateMessage, PlacesAreReadToTheBit, (double x, double y, double z)) {
  State state;
  RC_ASSERT(read_state(state_message(x, y, z).dump(), "049D", "61548", state));
  RC_ASSERT(state.has_device);
  RC_ASSERT((state.position_m == Vec3{x, y, z}));
}

TEST(StateMessage, SaysAllThatWeNeed) {
  State state;
  ASSERT_TRUE(read_state(state_message(0.01, -0.02, 0.03).dump(), "049D", "61548", state));
  EXPECT_EQ(state.velocity_m_per_s, (Vec3{-1, 0.5, 0}));
  EXPECT_EQ(state.force_n, (Vec3{0, 0, 1.5}));
  EXPECT_EQ(state.calibrated, true);
  EXPECT_EQ(state.buttons, 5u);
}

TEST(StateMessage, OtherDevicesAndGripsAreNotOurs) {
  State state;
  ASSERT_TRUE(read_state(state_message(1, 2, 3).dump(), "0BAD", "1", state));
  EXPECT_FALSE(state.has_device);
  EXPECT_EQ(state.buttons, 0u);
  ASSERT_TRUE(read_state(state_message(1, 2, 3).dump(), "049D", "", state));
  EXPECT_EQ(state.buttons, 0u);
}

TEST(StateMessage, GripsSpeakInTheirOwnWays) {
  State state;
  const auto buttons = [&](const char* family, const char* said) {
    const std::string text =
        std::string(R"({")") + family + R"(":[{"device_id":"7","state":{)" + said + "}}]}";
    EXPECT_TRUE(read_state(text, "049D", "7", state)) << text;
    return state.buttons;
  };
  EXPECT_EQ(buttons("wireless_verse_grip", R"("buttons":{"a":false,"b":true})"), 2u);
  EXPECT_EQ(buttons("verse_grip", R"("button":true)"), 1u);
  EXPECT_EQ(buttons("custom_verse_grip", R"("buttons":{"button_0":true,"button_3":true})"), 9u);
  EXPECT_EQ(buttons("custom_verse_grip", R"("buttons":{"a":{"pressed":true}})"), 0u);
  EXPECT_EQ(buttons("verse_grip", R"("battery_level":0.5)"), 0u);
}

TEST(StateMessage, AGripSaysHowItIsHeld) {
  State state;
  const auto axis = [&](const char* said) {
    const std::string text = std::string(R"({"verse_grip":[{"device_id":"7","state":{)") + said +
                             R"(,"buttons":{"b":true}}}]})";
    EXPECT_TRUE(read_state(text, "049D", "7", state)) << text;
    EXPECT_EQ(state.buttons, 2u) << text;
    return state.grip_axis;
  };
  EXPECT_EQ(axis(R"("orientation":{"w":1,"x":0,"y":0,"z":0})"), (Vec3{0, 1, 0})) << "its own y";
  const Vec3 up = axis(R"("orientation":{"x":0.70710678118654757,"y":0,"z":0,)"
                       R"("w":0.70710678118654757})")
                      .value();
  EXPECT_NEAR(norm(up - Vec3{0, 0, 1}), 0.0, 1e-12) << "a quarter turn about x lifts y to z";
  const Vec3 left = axis(R"("orientation":{"w":0.5,"x":-0.5,"y":0.5,"z":0.5})").value();
  EXPECT_NEAR(norm(left - Vec3{-1, 0, 0}), 0.0, 1e-12);
  for (const char* none :
       {R"("orientation":null)", R"("orientation":[1,0,0,0])", R"("orientation":{})",
        R"("orientation":{"w":0,"x":0,"y":0,"z":0})", R"("orientation":{"w":1,"x":0,"y":0})",
        R"("orientation":{"w":"1","x":0,"y":0,"z":0})",
        R"("orientation":{"w":[1],"x":0,"y":0,"z":0})",
        R"("orientation":{"w":1e200,"x":0,"y":0,"z":0})", R"("battery_level":1)"}) {
    EXPECT_EQ(axis(none), std::nullopt) << none;
  }
}

TEST(StateMessage, WhatShouldBeANumberAndIsNoneIsBad) {
  for (const char* place :
       {R"({"x":null,"y":0,"z":0})", R"({"x":"0","y":0,"z":0})", R"({"x":NaN,"y":0,"z":0})",
        R"({"x":1e999,"y":0,"z":0})", R"({"x":[0],"y":0,"z":0})", R"({"x":0,"y":0})", R"([0,0,0])",
        R"(null)", R"({"x":0,"y":0,"z":0)"}) {
    State state;
    const std::string text = std::string(R"({"inverse3":[{"device_id":"049D","state":)"
                                         R"({"cursor_position":)") +
                             place + "}}]}";
    EXPECT_FALSE(read_state(text, "049D", "", state)) << text;
  }
}

TEST(Inventory, SaysWhatThereIs) {
  const auto inventory = read_inventory(R"({"ok":true,"data":{"session_id":1,"inverse3":[
    {"device_id":"049D","config":{"type":"minverse","handedness":"left","preset":"defaults",
      "device_info":{"major_version":7,"minor_version":4},
      "gravity_compensation":{"enabled":false,"scaling_factor":1},
      "filters":{"force_gate":{"gain":0.3},"damping":{"scalar":0.5,"vector":null}},
      "mount":{"position":{"x":0}}},
      "status":{"calibrated":false,"power_supply":true,"in_use":"?"}},
    {"device_id":"evil\"}]","config":{}}],
    "wireless_verse_grip":[{"device_id":"99"}],"verse_grip":[{"device_id":"61548"}]}})");
  ASSERT_TRUE(inventory.has_value());
  ASSERT_EQ(inventory->devices.size(), 1u) << "an id that would break out of a command is none";
  const InventoryDevice& device = inventory->devices[0];
  EXPECT_EQ(device.id, "049D");
  EXPECT_EQ(device.type, "minverse");
  EXPECT_EQ(device.firmware, "7.4");
  EXPECT_EQ(device.handedness, "left");
  EXPECT_EQ(device.gravity_compensation, false);
  EXPECT_EQ(device.force_gate, 0.3);
  EXPECT_EQ(device.damping, 0.5);
  EXPECT_EQ(device.calibrated, false);
  EXPECT_EQ(device.has_power, true);
  EXPECT_FALSE(device.in_use.has_value());
  EXPECT_EQ(inventory->grips, (std::vector<std::string>{"61548", "99"})) << "with a cable first";
  EXPECT_FALSE(read_inventory("[]").has_value());
  EXPECT_FALSE(read_inventory("{\"inverse3\":7}").has_value());
}

TEST(Version, IsReadFromWhateverTheServiceSays) {
  EXPECT_EQ(read_version(R"({"project_version":"3.5.0.0","git_tag":"3.5.0"})"), "3.5.0.0");
  EXPECT_EQ(read_version(R"({"ok":true,"data":{"git_tag":"3.4.1"}})"), "3.4.1");
  EXPECT_EQ(read_version("<html>"), "");
  EXPECT_EQ(version_number("3.5.0-2-gce34c39e"), 3005);
  EXPECT_EQ(version_number("v3.10.1"), 3010);
  EXPECT_EQ(version_number("3"), 0);
  EXPECT_EQ(version_number("99999999999.1"), 0);
  EXPECT_EQ(force_key_of(0), ForceKey::kValues);
  EXPECT_EQ(force_key_of(3004), ForceKey::kValues);
  EXPECT_EQ(force_key_of(3005), ForceKey::kVector);
}

TEST(Events, BrakesStallsAndLossesMatter) {
  const auto kind = [](const std::string& name, const std::string& data, const char* level) {
    const auto event = read_event(R"({"name":")" + name + R"(","category":"device","level":")" +
                                      level + R"(","data":)" + data + R"(,"message":"words"})",
                                  "049D");
    return event ? event->kind : EventKind::kNone;
  };
  const auto safety = [&](const std::string& type, const char* level = "warning") {
    return kind("device-safety-triggered", R"({"device_id":"049D","safety_type":")" + type + "\"}",
                level);
  };
  EXPECT_EQ(safety("ebrake_triggered", "error"), EventKind::kBrakeOn);
  EXPECT_EQ(safety("ebrake_released", "notice"), EventKind::kBrakeOff);
  EXPECT_EQ(safety("stall_detected"), EventKind::kForceStopped);
  EXPECT_EQ(safety("stability_ceiling"), EventKind::kForceStopped);
  EXPECT_EQ(safety("fod_stage_changed"), EventKind::kForceStopped);
  EXPECT_EQ(safety("fod_stage_changed", "info"), EventKind::kNotice);
  EXPECT_EQ(safety("something_new", "error"), EventKind::kForceStopped);
  EXPECT_EQ(kind("device-disconnected", R"({"device_id":"049D"})", "warning"), EventKind::kGone);
  EXPECT_EQ(kind("device-disconnected", R"({"device_id":"0001"})", "warning"), EventKind::kNone);
  EXPECT_EQ(kind("device-battery-low", R"({"device_id":"61548"})", "warning"), EventKind::kNotice);
  EXPECT_EQ(kind("system-rate-report", "{}", "info"), EventKind::kNone);
  EXPECT_EQ(kind("control-rate-low", "{}", "warning"), EventKind::kNotice);
  EXPECT_FALSE(read_event("{", "049D").has_value());
  EXPECT_EQ(read_event(R"({"name":7,"data":[]})", "049D")->kind, EventKind::kNone);
}

TEST(Command, IsWhatTheServiceReads) {
  std::array<char, kMaxCommand> room{};
  const std::string id(64, 'A');
  const Json values =
      Json::parse(write_command(id, ForceKey::kValues, {0.5, -1.25, 3e-7}, room.data()));
  const Json& device = values["inverse3"][0];
  EXPECT_EQ(device["device_id"], id);
  EXPECT_EQ(device["commands"]["set_cursor_force"]["values"], vector(0.5, -1.25, 0.0));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Json mad =
      Json::parse(write_command("7", ForceKey::kVector, {nan, 1e300, -1e300}, room.data()));
  EXPECT_EQ(mad["inverse3"][0]["commands"]["set_cursor_force"]["vector"], vector(0, 1e6, -1e6));
  const Json first = Json::parse(first_command("049D"));
  EXPECT_EQ(first["inverse3"][0]["configure"]["preset"]["preset"], "arm_front_centered");
}

}  // namespace
}  // namespace felt::haply::service_messages_test
