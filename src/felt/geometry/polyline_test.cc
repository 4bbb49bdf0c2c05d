#include "felt/geometry/polyline.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace felt::polyline_test {
namespace {

Point any_point() {
  const double x = *rc::gen::inRange(-1000, 1000) * 0.125;
  return {x, *rc::gen::inRange(-1000, 1000) * 0.125};
}

std::vector<Point> any_line() {
  std::vector<Point> line(*rc::gen::inRange<std::size_t>(1, 20));
  for (Point& p : line) p = any_point();
  return line;
}

RC_GTEST_PROP(Polyline, NearestOnLineIsNoFartherThanSamples, ()) {
  const Point a = any_point(), b = any_point(), p = any_point();
  const LineNearest hit = nearest_on_line(a, b, p);
  RC_ASSERT(hit.t >= 0.0 && hit.t <= 1.0);
  RC_ASSERT(hit.distance_squared == distance_squared(hit.point, p));
  for (int i = 0; i <= 64; ++i) {
    RC_ASSERT(hit.distance_squared <= distance_squared(lerp(a, b, i / 64.0), p) + 1e-9);
  }
}

RC_GTEST_PROP(Polyline, ResampledPointsAreEquallyFarAlong, ()) {
  const std::vector<Point> line = any_line();
  std::vector<Point> out(*rc::gen::inRange<std::size_t>(2, 40));
  resample(line, out);
  RC_ASSERT(out.front() == line.front());
  RC_ASSERT(out.back() == line.back());
  const double step = polyline_length(line) / static_cast<double>(out.size() - 1);
  for (std::size_t k = 0; k < out.size(); ++k) {
    const Point expected = point_at_length(line, static_cast<double>(k) * step);
    RC_ASSERT(distance(out[k], expected) <= 1e-9);
    RC_ASSERT(nearest_on_polyline(line, out[k]).distance_squared <= 1e-18);
  }
}

TEST(Polyline, NearestOnPolylineNamesTheLine) {
  const std::vector<Point> line{{0, 0}, {10, 0}, {10, 10}};
  const PolylineNearest hit = nearest_on_polyline(line, {12, 4});
  EXPECT_EQ(hit.index, 1U);
  EXPECT_DOUBLE_EQ(hit.t, 0.4);
  EXPECT_EQ(hit.point, (Point{10, 4}));
  EXPECT_EQ(nearest_on_polyline(line, {11, -1}).index, 0U) << "of equal distances the first";
}

TEST(Polyline, DegenerateInputHasItsDocumentedAnswer) {
  const std::vector<Point> none, one{{3, 4}}, same{{3, 4}, {3, 4}, {3, 4}};
  EXPECT_EQ(nearest_on_line({3, 4}, {3, 4}, {0, 0}).t, 0.0);
  EXPECT_TRUE(std::isinf(nearest_on_polyline(none, {}).distance_squared));
  EXPECT_EQ(nearest_on_polyline(one, {}).distance_squared, 25.0);
  EXPECT_EQ(nearest_on_polyline(same, {}).distance_squared, 25.0);
  EXPECT_EQ(polyline_length(none), 0.0);
  EXPECT_EQ(polyline_length(same), 0.0);
  EXPECT_EQ(point_at_length(none, 1.0), Point{});
  EXPECT_EQ(point_at_length(one, 1.0), one[0]);
  EXPECT_EQ(point_at_length(same, std::numeric_limits<double>::quiet_NaN()), one[0]);
  std::vector<Point> out(3, Point{9, 9});
  resample(none, out);
  EXPECT_EQ(out, std::vector<Point>(3));
  resample(one, out);
  EXPECT_EQ(out, std::vector<Point>(3, one[0]));
  resample(same, out);
  EXPECT_EQ(out, same);
  resample(one, {});
}

}  // namespace
}  // namespace felt::polyline_test
