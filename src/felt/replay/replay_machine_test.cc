#include "felt/replay/replay_machine.h"

#include <gtest/gtest.h>

#include <string>

#include "felt/io/ndjson/ndjson_lines.h"
#include "felt/replay/script_run.h"

namespace felt::replay_machine_test {
namespace {

// Two lines of 60 mm, drawn in 1.5 s each.
std::string two_lines() {
  std::string text;
  for (const double y : {40.0, 80.0}) {
    text += R"({"points":[)";
    for (int i = 0; i <= 60; ++i) {
      text += (i > 0 ? "," : "") + std::string("[") + std::to_string(40 + i) + "," +
              std::to_string(y) + ",0.5," + std::to_string(25 * i) + "]";
    }
    text += "]}\n";
  }
  return text;
}

ReplayStats draw(std::optional<Person> person, bool force, std::string_view device = "premium") {
  ReplaySettings settings =
      replay_settings(*find_stylus_preset(device), typical_hand(), force, {}, {});
  settings.person = person;
  ReplayMachine machine(settings, Document(), {});
  ScriptRun run(machine, 1.0, 0);
  const std::string text = two_lines();
  EXPECT_TRUE(run.script("lines", "", read_text(text)));
  EXPECT_TRUE(run.play());
  return machine.take_stats();
}

TEST(ReplayMachine, APersonDrawsEveryLineToItsEnd) {
  for (const bool force : {true, false}) {
    const ReplayStats stats = draw(person_of(1), force);
    EXPECT_EQ(stats.strokes_meant, 2);
    EXPECT_EQ(stats.strokes, 2);
    EXPECT_LT(stats.distance.mean_mm(), 1.0);
    EXPECT_LT(stats.distance.max_mm(), 4.0) << "the end of a line is missing";
  }
}

TEST(ReplayMachine, PeopleDifferAndTheSamePersonDoesNot) {
  const double first = draw(person_of(1), true).distance.mean_mm();
  EXPECT_EQ(draw(person_of(1), true).distance.mean_mm(), first);
  EXPECT_NE(draw(person_of(2), true).distance.mean_mm(), first);
  EXPECT_LT(draw(std::nullopt, true).distance.mean_mm(), first) << "the hand without noise";
}

TEST(ReplayMachine, R55_AMouseThatVibratesPlaysCuesAndHasNoForce) {
  const ReplayStats stats = draw(std::nullopt, true, "vibrating-mouse");
  EXPECT_EQ(stats.strokes, 2);
  EXPECT_EQ(stats.max_sent_n, 0.0);
  ASSERT_TRUE(stats.cues);
  EXPECT_GE(*stats.cues, 4) << "two touches, and humming";
  EXPECT_LE(*stats.cues, 50.0 * stats.simulated_s);
  EXPECT_NE(stats_json(stats).find("\"cues\":"), std::string::npos);
  EXPECT_FALSE(draw(std::nullopt, true, "mouse").cues);
  EXPECT_FALSE(draw(std::nullopt, false, "vibrating-mouse").cues) << "forces are off";
}

TEST(ReplayMachine, R55_AJoystickDrawsWithForcesAlongThePageOnly) {
  const ReplayStats stats = draw(std::nullopt, true, "joystick");
  EXPECT_EQ(stats.strokes, 2);
  EXPECT_GT(stats.max_sent_n, 0.0);
  EXPECT_LT(stats.distance.max_mm(), 2.0);
}

}  // namespace
}  // namespace felt::replay_machine_test
