#include "felt/io/svg/svg_clip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "felt/stroke/outline/outline.h"

namespace felt::svg_clip_test {
namespace {

const SvgFrame kFrame(Rect{0.0, 0.0, 10.0, 10.0});

SvgContour circle(Point center, double r) {
  SvgPathBuilder builder(100);
  builder.move(center + Vec{r, 0.0});
  builder.arc(r, r, 0.0, false, true, center - Vec{r, 0.0});
  builder.arc(r, r, 0.0, false, true, center + Vec{r, 0.0});
  builder.close();
  return builder.take().front();
}

double area_of(const Fill& fill) {
  Outline outline;
  flatten_fill(fill, 0.001, outline);
  double area = 0.0;
  for (std::size_t k = 0; k < outline.contour_count(); ++k) {
    const auto polygon = outline.contour(k);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      area += 0.5 * cross(polygon[i] - Point{}, polygon[(i + 1) % polygon.size()] - Point{});
    }
  }
  return std::fabs(area);
}

TEST(SvgClip, AFillIsCutAtTheFrame) {
  const double pi = std::acos(-1.0);
  const auto clipped = [](Point center) {
    Fill fill;
    fill.loops.push_back({circle(center, 4.0).points, {}});
    clip_fill(fill, kFrame);
    return fill;
  };
  EXPECT_NEAR(area_of(clipped({5.0, 5.0})), 16.0 * pi, 0.05);
  EXPECT_NEAR(area_of(clipped({0.0, 5.0})), 8.0 * pi, 0.05);
  EXPECT_NEAR(area_of(clipped({10.0, 10.0})), 4.0 * pi, 0.05);
  EXPECT_TRUE(check_fill(clipped({10.0, 0.0})).has_value());
  EXPECT_TRUE(clipped({20.0, 5.0}).loops.empty());
}

TEST(SvgClip, ALineKeepsItsPartsInside) {
  EXPECT_TRUE(clip_line(circle({5.0, 5.0}, 4.0), kFrame).front().closed);
  EXPECT_TRUE(clip_line(circle({20.0, 5.0}, 4.0), kFrame).empty());
  // This circle begins inside, leaves and comes back: the part is one line.
  const std::vector<SvgContour> half = clip_line(circle({0.0, 5.0}, 4.0), kFrame);
  ASSERT_EQ(half.size(), 1U);
  EXPECT_FALSE(half[0].closed);
  EXPECT_NEAR(distance(half[0].points.front(), {0.0, 1.0}), 0.0, 1e-3);
  EXPECT_NEAR(distance(half[0].points.back(), {0.0, 9.0}), 0.0, 1e-3);
  // A large circle around the middle is cut at all four sides.
  EXPECT_EQ(clip_line(circle({5.0, 5.0}, 6.0), kFrame).size(), 4U);
}

}  // namespace
}  // namespace felt::svg_clip_test
