#include <gtest/gtest.h>

#include "tests/scenarios/scenario.h"

namespace felt::scenarios_test {
namespace {

std::vector<Scenario> scenarios() {
  Result<std::vector<Scenario>> all = read_scenarios();
  EXPECT_TRUE(all) << all.error().message;
  EXPECT_GE(all->size(), 10U);
  return *std::move(all);
}

ScenarioResult play(const Scenario& scenario, ScenarioOptions options = {}) {
  options.device = scenario.device;
  Result<ScenarioResult> result = play_scenario(scenario.events, options);
  EXPECT_TRUE(result) << scenario.name << ": " << result.error().message;
  return result ? *std::move(result) : ScenarioResult{};
}

TEST(Scenarios, GiveWhatTheyMust) {
  for (const Scenario& scenario : scenarios()) {
    const ScenarioResult result = play(scenario);
    EXPECT_FALSE(scenario.expected.empty()) << scenario.name;
    for (const auto& words : scenario.expected) {
      std::string line;
      for (const std::string& word : words) line += word + " ";
      EXPECT_EQ(check_expectation(words, result), "") << scenario.name << ": " << line;
    }
  }
}

TEST(Scenarios, GiveTheSameBytesAgain) {
  for (const Scenario& scenario : scenarios()) {
    const ScenarioResult a = play(scenario);
    const ScenarioResult b = play(scenario);
    EXPECT_EQ(a.sketch_text, b.sketch_text) << scenario.name;
    EXPECT_EQ(a.recording, b.recording) << scenario.name;
    EXPECT_EQ(a.ticks, b.ticks) << scenario.name;
    EXPECT_EQ(a.report, b.report) << scenario.name;
  }
}

TEST(Scenarios, ARecordingThatIsWrittenAndReadGivesTheSameSketch) {
  for (const Scenario& scenario : scenarios()) {
    const ScenarioResult played = play(scenario);
    const Result<std::vector<Event>> events =
        read_events(scenario.name, read_text(played.recording));
    ASSERT_TRUE(events) << events.error().message;
    const Result<Document> reported = report_session(*events, scenario.device);
    ASSERT_TRUE(reported) << reported.error().message;
    EXPECT_EQ(text_of(*reported), played.sketch_text) << scenario.name;
    // Plays the recording through the haptic loop: the recorded poses move the simulated pen.
    const Result<ScenarioResult> replayed = play_scenario(*events, {.device = scenario.device});
    ASSERT_TRUE(replayed) << replayed.error().message;
    EXPECT_EQ(replayed->sketch_text, played.sketch_text) << scenario.name;
  }
}

TEST(Scenarios, PortionsOfTheEditSideDoNotMatterToAPen) {
  for (const Scenario& scenario : scenarios()) {
    if (scenario.has_hand()) continue;  // a longer period delays the forces, which move the hand
    const ScenarioResult usual = play(scenario);
    for (const std::int64_t portion_ms : {1, 7, 100}) {
      EXPECT_EQ(play(scenario, {.edit_period_ns = portion_ms * 1'000'000}).sketch_text,
                usual.sketch_text)
          << scenario.name << ", " << portion_ms << " ms";
    }
  }
}

TEST(Scenarios, R51_ForcesDoNotMatterToAPen) {
  std::size_t felt = 0;
  for (const Scenario& scenario : scenarios()) {
    if (scenario.has_hand()) continue;  // the forces move the hand
    const ScenarioResult with = play(scenario);
    const ScenarioResult without = play(scenario, {.forces = false});
    EXPECT_EQ(with.sketch_text, without.sketch_text) << scenario.name;
    EXPECT_EQ(with.recording, without.recording) << scenario.name;
    EXPECT_EQ(without.report.largest_sent_n, 0.0) << scenario.name;
    felt += with.report.largest_sent_n > 0.1 ? 1 : 0;
  }
  EXPECT_GE(felt, 4U) << "scripts in which there was a force to ignore";
}

}  // namespace
}  // namespace felt::scenarios_test
