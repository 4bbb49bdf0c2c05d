#include "felt/render/stroke_measures.h"

#include <gtest/gtest.h>

#include "felt/render/segments_in_area.h"
#include "felt/render/tip_travel.h"

namespace felt::stroke_measures_test {
namespace {

/// Returns a zigzag of `lines` segments. `width_mm` is the width of its end.
Stroke zigzag(int lines, double width_mm = 1.0) {
  StrokeData data;
  data.points = {{0, 0}};
  for (int i = 1; i <= lines; ++i) {
    const Point from = data.points.back();
    const Point to{1.0 * i, i % 2 == 0 ? 0.0 : 20.0};
    data.points.insert(data.points.end(), {from + Vec{0.2, 0.0}, to - Vec{0.2, 0.0}, to});
  }
  data.joints.assign(static_cast<std::size_t>(lines) - 1, JointKind::kCorner);
  data.widths = {{0.0, 0.6}, {1.0 * lines, width_mm}};
  return Stroke::create(std::move(data)).value();
}

void expect_measures(StrokeMeasures& measures, const Stroke& stroke, double px_per_mm) {
  const auto count = static_cast<std::size_t>(stroke.segment_count());
  ASSERT_EQ(measures.areas().size(), count);
  const std::span<const double> travels = measures.travels(stroke, px_per_mm);
  ASSERT_EQ(travels.size(), count + 1);
  double travel = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const int k = static_cast<int>(i);
    EXPECT_EQ(measures.areas()[i], segment_area(stroke, k));
    EXPECT_NEAR(travels[i], travel, 1e-9 * travel);
    Cubic px = stroke.segment(k);
    for (Point& p : px.p) p = {px_per_mm * p.x, px_per_mm * p.y};
    travel += segment_travel(px, 0.5 * px_per_mm * stroke.width_mm(k),
                             0.5 * px_per_mm * stroke.width_mm(k + 1));
  }
  EXPECT_NEAR(travels[count], travel, 1e-9 * travel);
}

TEST(StrokeMeasures, ALongStrokeIsMeasuredOnceForAllTiles) {
  StrokeMeasures measures;
  const Stroke first = zigzag(1000), second = zigzag(1000, 2.0), small = zigzag(10);
  for (int tile = 0; tile < 20; ++tile) {
    for (const Stroke* stroke : {&first, &second}) {
      measures.use(*stroke);
      expect_measures(measures, *stroke, 4.0);
    }
  }
  EXPECT_EQ(measures.measured_count(), 2U);
  const Stroke copy = first;
  measures.use(copy);
  expect_measures(measures, copy, 4.0);
  EXPECT_EQ(measures.measured_count(), 2U) << "a copy has the same points";
  expect_measures(measures, copy, 8.0);
  expect_measures(measures, copy, 4.0);
  measures.use(small);
  expect_measures(measures, small, 4.0);
  measures.use(first);
  expect_measures(measures, first, 4.0);
  EXPECT_EQ(measures.measured_count(), 3U);
}

/// A stroke may be at the address of an earlier one.
TEST(StrokeMeasures, AnotherStrokeAtTheSameAddressIsRecognised) {
  StrokeMeasures measures;
  Stroke stroke = zigzag(200);
  for (const double width_mm : {1.0, 2.0, 3.0}) {
    stroke = zigzag(200, width_mm);
    measures.use(stroke);
    expect_measures(measures, stroke, 4.0);
  }
  EXPECT_EQ(measures.measured_count(), 3U);
}

TEST(StrokeMeasures, OnlyTheStrokesThatWereUsedLastAreKept) {
  StrokeMeasures measures;
  const auto use = [&measures](int lines, double width_mm) {
    const std::size_t before = measures.measured_count();
    measures.use(zigzag(lines, width_mm));
    return measures.measured_count() - before;
  };
  for (std::size_t i = 0; i <= StrokeMeasures::kMaxKept; ++i) {
    EXPECT_EQ(use(200, 1.0 + 0.01 * static_cast<double>(i)), 1U);
  }
  EXPECT_EQ(use(200, 1.01), 0U);
  EXPECT_EQ(use(200, 1.0), 1U) << "it was used least recently";
  EXPECT_EQ(use(StrokeMeasures::kMaxKeptSegments - 100, 1.0), 1U);
  EXPECT_EQ(use(200, 1.0), 1U) << "the large one took all of the space";
}

}  // namespace
}  // namespace felt::stroke_measures_test
