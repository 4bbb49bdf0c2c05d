#include "felt/tools/eraser/eraser_gesture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/tools/testing/tool_fixture.h"

namespace felt::eraser_gesture_test {
namespace {

using testing::Fixture;

/// Returns shading drawn as one zigzag line, with legs of 50 mm that are 0.5 mm apart.
Stroke zigzag(int legs) {
  StrokeData data{.points = {{0, 0}}, .joints = {}, .closed = false, .widths = {}};
  for (int i = 0; i < legs; ++i) {
    const Point from = data.points.back(), to{i % 2 == 0 ? 50.0 : 0.0, 0.5 * (i + 1)};
    for (const double t : {1.0 / 3, 2.0 / 3, 1.0}) data.points.push_back(lerp(from, to, t));
    if (i > 0) data.joints.push_back(JointKind::kCorner);
  }
  data.widths = {{0, 0.4}, {static_cast<double>(legs), 0.4}};
  return Stroke::create(std::move(data)).value();
}

TEST(EraserGesture, R39_RubbingOutOneLongLineCostsNoMoreASampleAsItGoesOn) {
  Fixture fixture;
  const StrokeId line = fixture.add(zigzag(100));
  EraserGesture erasing({}, EraserMode::kTouched);
  std::int64_t now = 0;
  erasing.begin({25, -3}, now, fixture.scene());
  // The eraser moves three times back and forth on each strip of 3 mm, at 250 mm/s.
  int shown = 0;
  std::size_t at_half = 0;
  constexpr int kSamples = 6000;
  for (int i = 1; i <= kSamples; ++i) {
    const double x = 25.0 + 30.0 * std::sin(0.0083 * i), y = -3.0 + 56.0 * i / kSamples;
    shown += erasing.move({x, y}, now += 1'000'000, fixture.scene()) ? 1 : 0;
    if (2 * i == kSamples) at_half = erasing.cut_places();
  }
  const std::size_t places = erasing.cut_places();
  erasing.finish(fixture.scene());
  EXPECT_LE(places, 1e-4 * static_cast<double>(now)) << "a pause for each place";
  EXPECT_LE(places, 3 * at_half) << "the second half costs as the first";
  EXPECT_GT(shown, 20) << "and what is left is seen meanwhile";
  Document after = fixture.document;
  ASSERT_TRUE(after.apply(erasing.edit(fixture.scene())));
  EXPECT_FALSE(after.find(line));
}

TEST(EraserGesture, ALineOfManyKilometresIsCutWithFewPlaces) {
  Fixture fixture;
  const StrokeId line = fixture.add(testing::straight_stroke({0, 0}, {4e6, 0}, 1, 1));
  EraserGesture erasing({}, EraserMode::kTouched);
  erasing.begin({1e6, 0}, 0, fixture.scene());
  erasing.move({1e6, 10}, 1'000'000'000, fixture.scene());
  EXPECT_LE(erasing.cut_places(), 10U) << "a touch";
  erasing.move({2e6, 10}, 2'000'000'000, fixture.scene());
  erasing.move({2e6, 0}, 3'000'000'000, fixture.scene());
  erasing.move({3e6, 0}, 4'000'000'000, fixture.scene());
  EXPECT_LE(erasing.cut_places(), 100'000U) << "a kilometre";
  erasing.finish(fixture.scene());
  Document after = fixture.document;
  ASSERT_TRUE(after.apply(erasing.edit(fixture.scene())));
  EXPECT_FALSE(after.find(line));
  EXPECT_EQ(after.stroke_count(), 3U);
}

TEST(EraserGesture, AShortLineIsCutAsOftenAsItIsShown) {
  Fixture fixture;
  fixture.add(testing::straight_stroke({0, 0}, {60, 0}, 1, 1));
  EraserGesture erasing({}, EraserMode::kTouched);
  erasing.begin({10, 0}, 0, fixture.scene());
  int shown = 0;
  for (int i = 1; i <= 400; ++i) {
    shown += erasing.move({10.0 + 0.1 * i, 0}, 1'000'000 * i, fixture.scene()) ? 1 : 0;
  }
  EXPECT_GE(shown, 35) << "of 50 frames";
}

}  // namespace
}  // namespace felt::eraser_gesture_test
