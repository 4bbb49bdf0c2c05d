#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/driver/driver.h"
#include "felt/geometry/vec3.h"
#include "felt/haptics/force.h"

/// The messages of the Inverse Service 3.x (maker's pages "WebSocket Protocol", "Control Commands",
/// "JSON Conventions", "Events & Monitoring"), read where they lie. Keys that we do not know are
/// passed over; what should be a number and is none makes the whole message bad.
namespace felt::haply {

/// The newest of our device in a state message. Service's units: m, m/s, N, in its application
/// space.
struct State {
  bool has_device = false;  ///< our device is in the message, with a place
  Vec3 position_m;
  Vec3 velocity_m_per_s;
  std::optional<Vec3> force_n;     ///< that acts, as the service says
  std::optional<bool> calibrated;  ///< where it says so
  std::optional<bool> has_power;   ///< likewise
  std::uint32_t buttons = 0;       ///< of our grip: bit 0 is a (or button_0, or the only one)
  std::optional<Vec3> grip_axis;   ///< along our grip, where it says how it is turned; length 1
};

/// Haptic thread; no allocation. `grip_id` empty: no grip. False: bad, `state` then means nothing.
bool read_state(std::string_view message, std::string_view device_id, std::string_view grip_id,
                State& state) noexcept;

/// A device of the inventory, which the service sends first, and says at GET /devices.
struct InventoryDevice {
  std::string id;          ///< only letters, digits, '-' and '_': others are left out
  std::string type;        ///< "inverse3", "inverse3x", "minverse"
  std::string firmware;    ///< "7.4"; empty: not said
  std::string handedness;  ///< how its arm is built: "right", "left"; empty: not said
  std::string preset;      ///< empty: not said
  std::optional<bool> calibrated, has_power, in_use;
  std::optional<bool> gravity_compensation;
  std::optional<double> force_gate;  ///< gain of the service's own guard against oscillation
  std::optional<double> damping;     ///< that the service adds
};
struct Inventory {
  std::vector<InventoryDevice> devices;
  std::vector<std::string> grips;  ///< ids, those with a cable first
};
/// Edit thread. The whole message, or inside {"ok": true, "data": ...}. Nothing: it is no
/// inventory.
std::optional<Inventory> read_inventory(std::string_view message);

/// The newest "project_version" or "git_tag" in an answer to GET /version; empty: none.
std::string read_version(std::string_view answer);
/// Major and minor as one number for comparisons, 3005 for "3.5.0-2-gce34c39e"; 0: unreadable.
int version_number(std::string_view version) noexcept;

/// What an event means for us.
enum class EventKind : std::uint8_t {
  kNone,     ///< nothing
  kNotice,   ///< to be told
  kBrakeOn,  ///< no force until kBrakeOff
  kBrakeOff,
  kForceStopped,  ///< force must be taken away, and may come back when a person says so
  kGone,          ///< the device is not there any more
};
struct Event {
  EventKind kind = EventKind::kNone;
  ShortText words;  ///< the service's own
};
/// Haptic thread; no allocation. An event of another device is kNone, unless it is a grip's
/// battery. Nothing: bad.
std::optional<Event> read_event(std::string_view message, std::string_view device_id) noexcept;

/// The service's name for the vector of set_cursor_force, which its own pages do not agree about
/// (devices.md 5.1).
enum class ForceKey : std::uint8_t {
  kValues,  ///< all examples up to 3.4, and where the version is not known
  kVector,  ///< reference pages of 3.5
};
constexpr ForceKey force_key_of(int version) noexcept {
  return version >= 3005 ? ForceKey::kVector : ForceKey::kValues;
}
constexpr ForceKey other(ForceKey key) noexcept {
  return key == ForceKey::kValues ? ForceKey::kVector : ForceKey::kValues;
}

/// Writes the command of one tick into `room` (at least kMostCommand bytes); what is returned lies
/// in it. Haptic thread. Forces that are not finite are written as 0.
inline constexpr std::size_t kMostCommand = 512;
std::string_view write_command(std::string_view device_id, ForceKey key, const Force& force,
                               char* room) noexcept;
/// The first message: who we are, and where the origin shall be (the middle of the workspace).
std::string first_command(std::string_view device_id);

}  // namespace felt::haply
