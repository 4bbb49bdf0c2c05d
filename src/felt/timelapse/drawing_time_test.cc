#include "felt/timelapse/drawing_time.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "felt/timelapse/testing/drawn_recording.h"

namespace felt::drawing_time_test {
namespace {

constexpr std::int64_t kMs = 1'000'000;

Event pen(std::int64_t ms, double pressure) {
  return {ms * kMs, PenEvent{{0.0, 0.0, pressure > 0.0 ? 0.0 : 5.0}, pressure}};
}

TEST(DrawingTime, RunsWhileThePenIsDownAndShortensPauses) {
  DrawingTime time;
  EXPECT_FALSE(time.has_begun());
  EXPECT_EQ(time.at({0, SelectTool{"pencil"}}), 0);
  EXPECT_EQ(time.at(pen(5000, 0.0)), 0) << "hovering does not count";
  EXPECT_FALSE(time.has_begun());
  EXPECT_EQ(time.at(pen(9000, 0.5)), 0) << "the first touch";
  EXPECT_TRUE(time.has_begun());
  EXPECT_EQ(time.at(pen(9100, 0.5)), 100 * kMs);
  EXPECT_EQ(time.at(pen(9110, 0.0)), 110 * kMs) << "the lift";
  EXPECT_EQ(time.at(pen(9120, 0.0)), 110 * kMs);
  EXPECT_EQ(time.at({60'000 * kMs, SetOption{"ink.color", std::string("#000000")}}), 110 * kMs);
  EXPECT_EQ(time.at({70'000 * kMs, UndoEvent{}}), 360 * kMs) << "a pause counts 250 ms at most";
  EXPECT_EQ(time.at({70'020 * kMs, RedoEvent{}}), 380 * kMs);
}

TEST(DrawingTime, AStreamThatStopsWhileThePenIsDownIsAPause) {
  DrawingTime time;
  time.at(pen(0, 0.5));
  EXPECT_EQ(time.at(pen(100'000, 0.5)), DrawingTime::kLongestPauseNs);
}

RC_GTEST_PROP(DrawingTime, NeverGoesBackAndIsNeverLongerThanTheRecording, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  DrawingTime time;
  std::int64_t last = 0, end = 0;
  (void)play_recording(testing::random_recording(seed, 12),
                       [&](const Event& event) -> Result<void> {
                         const std::int64_t now = time.at(event);
                         RC_ASSERT(now >= last);
                         last = now;
                         end = event.time_ns;
                         return {};
                       });
  RC_ASSERT(last <= end);
}

}  // namespace
}  // namespace felt::drawing_time_test
