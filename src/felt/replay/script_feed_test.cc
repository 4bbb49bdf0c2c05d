#include "felt/replay/script_feed.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace felt::script_feed_test {
namespace {

using ::testing::HasSubstr;

/// The output of a script.
struct Fed {
  Result<void> result;
  std::vector<Event> events;
  std::vector<std::vector<Point>> strokes;
  std::vector<std::size_t> events_at_stroke;  // number of events when the stroke was done
};

Fed feed(const std::vector<std::string>& scripts, FeedOptions options = {}) {
  Fed fed;
  ScriptFeed feed(options, {.event =
                                [&fed](const Event& event) {
                                  fed.events.push_back(event);
                                  return Result<void>();
                                },
                            .stroke_drawn =
                                [&fed](const std::vector<Point>& meant) {
                                  fed.strokes.push_back(meant);
                                  fed.events_at_stroke.push_back(fed.events.size());
                                  return Result<void>();
                                }});
  for (const std::string& script : scripts) {
    fed.result = feed.read("script", read_text(script));
    if (!fed.result) return fed;
  }
  fed.result = feed.rest();
  return fed;
}

constexpr const char* kStroke = R"({"points":[[10,10,0.5,0],[20,10,0.5,100],[20,20,0.5,200]]})"
                                "\n";
constexpr const char* kUndo = "{\"event\":\"undo\",\"t_ms\":5}\n";

TEST(ScriptFeed, AStrokeIsDrawnBetweenTheEventsAroundIt) {
  const Fed fed = feed({std::string(kUndo) + kStroke + kUndo});
  ASSERT_TRUE(fed.result) << fed.result.error().message;
  ASSERT_EQ(fed.strokes.size(), 1u);
  EXPECT_EQ(fed.strokes[0], (std::vector<Point>{{10, 10}, {20, 10}, {20, 20}}));
  EXPECT_TRUE(std::holds_alternative<UndoEvent>(fed.events.front().what));
  // The second undo comes after the stroke. After the undo the hand only rests.
  const Event& second = fed.events[fed.events_at_stroke[0]];
  EXPECT_TRUE(std::holds_alternative<UndoEvent>(second.what));
  EXPECT_EQ(fed.events.size(), fed.events_at_stroke[0] + 2);
}

/// Returns the notices about a script.
std::vector<std::string> notices_of(const std::string& script) {
  ScriptFeed feed({}, {.event = [](const Event&) { return Result<void>(); }});
  const Result<void> read = feed.read("script", read_text(script));
  EXPECT_TRUE(read) << read.error().message;
  std::vector<std::string> notices;
  for (const ImportNotice& notice : feed.report().notices()) {
    notices.push_back(notice_text(notice));
  }
  return notices;
}

TEST(ScriptFeed, RawPressuresAreNamedOnceWithTheirNumber) {
  const std::string raw = R"({"points":[[10,10,512,0],[20,10,700,100],[20,20,0.5,200]]})"
                          "\n";
  const std::vector<std::string> notices = notices_of(kStroke + raw + raw);
  ASSERT_EQ(notices.size(), 1u);
  EXPECT_THAT(notices[0], HasSubstr("stroke '2' (2 of 3 pressures, for example 700) has pressures "
                                    "outside 0 to 1"));
  EXPECT_THAT(notices[0], HasSubstr("1 more"));
  EXPECT_TRUE(notices_of(kStroke).empty());
}

TEST(ScriptFeed, TimesInSecondsAreNamedAndTheStrokeIsDrawnAsWithoutTimes) {
  std::string seconds = R"({"id":"wave","points":[)", without = seconds;
  for (int i = 0; i < 20; ++i) {
    const std::string at = (i > 0 ? ",[" : "[") + std::to_string(i) + ",10,0.5";
    seconds += at + "," + std::to_string(0.01 * i) + "]";
    without += at + "]";
  }
  const std::vector<std::string> notices = notices_of(seconds + "]}\n");
  ASSERT_EQ(notices.size(), 1u);
  EXPECT_THAT(notices[0], HasSubstr("stroke 'wave' has times that are not milliseconds"));
  EXPECT_EQ(feed({seconds + "]}\n"}).events, feed({without + "]}\n"}).events);
}

TEST(ScriptFeed, TheHandPressesAlongTheStrokeAndLifts) {
  const Fed fed = feed({kStroke});
  const auto& first = std::get<HandEvent>(fed.events.front().what);
  const auto& last = std::get<HandEvent>(fed.events.back().what);
  EXPECT_GT(first.target.z, 0.0);
  EXPECT_GT(last.target.z, 0.0);
  double deepest = 0.0;
  for (const Event& event : fed.events) {
    deepest = std::min(deepest, std::get<HandEvent>(event.what).target.z);
  }
  EXPECT_LT(deepest, 0.0);
}

TEST(ScriptFeed, TimesNeverRunBackwardsAndTheHandNeverJumps) {
  const Fed fed = feed({std::string(kUndo) + kStroke + kUndo + kStroke, kStroke, kUndo});
  ASSERT_TRUE(fed.result);
  EXPECT_EQ(fed.strokes.size(), 3u);
  std::optional<Vec3> hand;
  std::int64_t hand_ns = 0, last_ns = 0;
  for (const Event& event : fed.events) {
    EXPECT_GE(event.time_ns, last_ns);
    last_ns = event.time_ns;
    const auto* aim = std::get_if<HandEvent>(&event.what);
    if (!aim) continue;
    if (hand) {
      const double ms = 1e-6 * static_cast<double>(event.time_ns - hand_ns);
      EXPECT_LT(norm(aim->target - *hand), 1.0 * std::max(ms, 1.0)) << "faster than 1 m/s";
    }
    hand = aim->target;
    hand_ns = event.time_ns;
  }
}

TEST(ScriptFeed, UnitsAreScaled) {
  const Fed fed = feed({kStroke}, {.mm_per_unit = 0.1, .hand = {}});
  EXPECT_EQ(fed.strokes[0][1], (Point{2.0, 1.0}));
}

TEST(ScriptFeed, TheSeedShakesTheHandALittleAndAlwaysAlike) {
  const auto targets = [](std::uint64_t seed) {
    const Fed fed = feed({kStroke}, {.hand = {}, .seed = seed});
    std::vector<Vec3> all;
    for (const Event& event : fed.events) all.push_back(std::get<HandEvent>(event.what).target);
    return all;
  };
  const std::vector<Vec3> calm = targets(0), one = targets(1), other = targets(2);
  EXPECT_EQ(one, targets(1));
  EXPECT_NE(one, other);
  ASSERT_EQ(calm.size(), one.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < calm.size(); ++i) {
    largest = std::max(largest, norm(one[i] - calm[i]));
  }
  EXPECT_GT(largest, 0.01);
  EXPECT_LT(largest, 0.2);
}

TEST(ScriptFeed, AStrokeThatWouldTakeAgesIsAnError) {
  const Fed vast = feed({R"({"points":[[0,0],[30000,0]]})"});
  ASSERT_FALSE(vast.result);
  EXPECT_EQ(vast.result.error().message,
            "script:1: points: the stroke is longer than 20 m, see --mm-per-unit");
  std::string slow = R"({"points":[[0,0,0.5,0])";
  for (int i = 1; i < 700; ++i) {
    slow += ",[0," + std::to_string(i) + ",0.5," + std::to_string(5000 * i) + "]";
  }
  const Fed ages = feed({slow + "]}"});
  ASSERT_FALSE(ages.result);
  EXPECT_EQ(ages.result.error().message,
            "script:1: points: the stroke takes longer than 10 minutes");
}

TEST(ScriptFeed, ErrorsNameThePlaceAndEndIt) {
  const Fed fed = feed({std::string(kUndo) + "{\"event\":\"nonsense\",\"t_ms\":5}\n" + kStroke});
  ASSERT_FALSE(fed.result);
  EXPECT_EQ(fed.result.error().message.rfind("script:2:", 0), 0u) << fed.result.error().message;
  EXPECT_EQ(fed.events.size(), 1u);
}

}  // namespace
}  // namespace felt::script_feed_test
