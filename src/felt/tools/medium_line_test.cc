#include "felt/tools/medium_line.h"

#include <gtest/gtest.h>

#include "felt/stroke/fit/width_map.h"

namespace felt::medium_line_test {
namespace {

Medium with_line(const MediumLine& line) {
  Medium medium;
  medium.id = "mine";
  medium.line = line;
  return medium;
}

const InkFitOptions kPencilInk = [] {
  InkFitOptions ink;
  ink.width_map = {};
  return ink;
}();

TEST(MediumLine, TheUsualRangeEvenlyLeavesTheToneToTheWidth) {
  const InkFitOptions ink = drawn_with(with_line({}), kPencilInk);
  EXPECT_EQ(ink.width_map, kPencilInk.width_map);
  EXPECT_EQ(ink.width.max_mm, kPencilInk.width.max_mm);
  EXPECT_EQ(ink.medium, "mine");
  // This is correct, because the medium would have the same tone.
  WidthMapOptions own = ink.width_map;
  own.tone = ToneMapOptions{};
  for (int i = 0; i <= 100; ++i) {
    EXPECT_NEAR(tone_of(ink.width_map, 0.01 * i, 0.0), tone_of(own, 0.01 * i, 0.0), 1e-15);
  }
}

TEST(MediumLine, AnotherRangeOrCurveKeepsTheToneOfThePressure) {
  InkFitOptions thin = kPencilInk;
  thin.width_map.max_mm = 2.0;
  EXPECT_DOUBLE_EQ(tone_of(drawn_with(with_line({}), thin).width_map, 0.5, 0.0), 0.5);
  InkFitOptions bent = kPencilInk;
  bent.width_map.gamma = 2.0;
  EXPECT_DOUBLE_EQ(tone_of(drawn_with(with_line({}), bent).width_map, 0.5, 0.0), 0.5);
}

TEST(MediumLine, TiltAndToneComeFromTheMediumAndTheRangeStays) {
  const Medium charcoal = with_line({.min_mm = 2.0,
                                     .max_mm = 9.0,
                                     .gamma = 3.0,
                                     .tilt_width = 4.0,
                                     .tone_light = 0.1,
                                     .tone_heavy = 0.9,
                                     .tone_gamma = 2.0,
                                     .tilt_tone = 0.5});
  const InkFitOptions ink = drawn_with(charcoal, kPencilInk);
  const WidthMapOptions& widths = ink.width_map;
  EXPECT_EQ(widths.min_mm, 0.3);
  EXPECT_EQ(widths.max_mm, 6.0);
  EXPECT_EQ(widths.gamma, 1.0);
  EXPECT_EQ(widths.tone, (ToneMapOptions{0.1, 0.9, 2.0, 0.5}));
  EXPECT_DOUBLE_EQ(width_of(widths, 1.0, 1.0), 24.0);
  EXPECT_DOUBLE_EQ(ink.width.max_mm, 24.0);  // includes the width added by tilt
}

}  // namespace
}  // namespace felt::medium_line_test
