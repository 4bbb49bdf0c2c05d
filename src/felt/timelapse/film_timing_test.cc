#include "felt/timelapse/film_timing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace felt::film_timing_test {
namespace {

FilmLength any_length() {
  FilmLength length;
  length.seconds = 0.1 * *rc::gen::inRange(1, 2000);
  length.frames_per_second = *rc::gen::inRange(1, 101);
  length.hold_s = 0.1 * *rc::gen::inRange(0, 50);
  return length;
}

RC_GTEST_PROP(FilmTiming, HasTheExactLengthAndNeverGoesBack, ()) {
  const FilmLength length = any_length();
  const std::int64_t drawing_ns = *rc::gen::inRange<std::int64_t>(0, 900'000'000'000'000);
  const FilmTiming timing(drawing_ns, length);
  const std::int64_t frames =
      std::max<std::int64_t>(1, std::llround(*length.seconds * length.frames_per_second));
  RC_ASSERT(timing.frames() == frames);
  RC_ASSERT(timing.at(frames - 1) == drawing_ns);
  if (frames > 1) RC_ASSERT(timing.at(0) == 0 || drawing_ns == 0);
  for (std::int64_t i = 1; i < frames; ++i) RC_ASSERT(timing.at(i - 1) <= timing.at(i));
}

RC_GTEST_PROP(FilmTiming, FramesAreEvenUntilTheHold, ()) {
  const FilmTiming timing(*rc::gen::inRange<std::int64_t>(1'000'000, 900'000'000'000'000),
                          any_length());
  std::int64_t moving = 0;
  while (timing.at(moving) < timing.at(timing.frames() - 1)) ++moving;
  if (moving < 2) return;
  const double step =
      static_cast<double>(timing.at(timing.frames() - 1)) / static_cast<double>(moving);
  for (std::int64_t i = 0; i < moving; ++i) {
    RC_ASSERT(std::abs(static_cast<double>(timing.at(i)) - step * static_cast<double>(i)) <=
              static_cast<double>(moving) + 1.0);
  }
}

TEST(FilmTiming, TheFirstFrameIsTheStartAndTheHoldTheEnd) {
  const FilmTiming timing(58'000'000'000, {30.0, 24, 1.0});
  EXPECT_EQ(timing.frames(), 720);
  EXPECT_EQ(timing.at(0), 0);
  EXPECT_EQ(timing.at(348), 29'000'000'000);
  EXPECT_LT(timing.at(695), 58'000'000'000);
  EXPECT_EQ(timing.at(696), 58'000'000'000);
  EXPECT_EQ(timing.at(719), 58'000'000'000);
  EXPECT_DOUBLE_EQ(timing.length_s(), 30.0);
  EXPECT_DOUBLE_EQ(timing.film_s(29'000'000'000), 14.5);
}

TEST(FilmTiming, AShortDrawingIsNotSlowedDownUnlessALengthIsGiven) {
  EXPECT_EQ(FilmTiming(4'000'000'000, {}).frames(), 5 * 24);
  EXPECT_EQ(FilmTiming(4'000'000'000, {30.0}).frames(), 720);
  EXPECT_EQ(FilmTiming(400'000'000'000, {}).frames(), 720);
}

TEST(FilmTiming, TheHoldTakesAtMostHalf) {
  const FilmTiming timing(1'000'000'000, {1.0, 10, 60.0});
  EXPECT_EQ(timing.frames(), 10);
  EXPECT_LT(timing.at(4), 1'000'000'000);
  EXPECT_EQ(timing.at(5), 1'000'000'000);
}

TEST(FilmTiming, ADrawingOfOneMomentIsShownAllTheTime) {
  const FilmTiming timing(0, {});
  EXPECT_EQ(timing.frames(), 24);
  EXPECT_EQ(timing.at(0), 0);
  EXPECT_EQ(timing.film_s(0), 0.0);
}

}  // namespace
}  // namespace felt::film_timing_test
