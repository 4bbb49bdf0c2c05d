#include "felt/geometry/polyline.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace felt::polygon_test {
namespace {

const std::vector<Point> kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
// A pentagram: its middle has winding number 2.
const std::vector<Point> kStar{{0, -10}, {6, 8}, {-9.5, -3}, {9.5, -3}, {-6, 8}};

std::vector<Point> any_points(std::size_t largest) {
  std::vector<Point> points(*rc::gen::inRange<std::size_t>(0, largest));
  for (Point& p : points) {
    p.x = *rc::gen::inRange(-12, 12);
    p.y = *rc::gen::inRange(-12, 12);
  }
  return points;
}

TEST(Polygon, ContainsItsEdgesAndCorners) {
  for (const FillRule rule : {FillRule::kEvenOdd, FillRule::kNonZero}) {
    EXPECT_TRUE(contains(kSquare, {2, 2}, rule));
    EXPECT_TRUE(contains(kSquare, {0, 0}, rule));
    EXPECT_TRUE(contains(kSquare, {4, 2}, rule));
    EXPECT_TRUE(contains(kSquare, {2, 4}, rule));
    EXPECT_FALSE(contains(kSquare, {4.0000001, 2}, rule));
    EXPECT_FALSE(contains(kSquare, {-1, 0}, rule)) << "level with a corner";
    EXPECT_FALSE(contains(kSquare, {-1, 4}, rule));
    EXPECT_FALSE(contains({}, {0, 0}, rule));
    EXPECT_TRUE(contains(std::vector<Point>{{1, 1}}, {1, 1}, rule));
    EXPECT_FALSE(contains(std::vector<Point>{{1, 1}}, {1, 2}, rule));
  }
}

TEST(Polygon, RulesDifferWhereTheBoundaryGoesRoundTwice) {
  EXPECT_TRUE(contains(kStar, {0, 0}, FillRule::kNonZero));
  EXPECT_FALSE(contains(kStar, {0, 0}, FillRule::kEvenOdd));
  EXPECT_TRUE(contains(kStar, {0, -9}, FillRule::kEvenOdd));
}

RC_GTEST_PROP(Polygon, WindingAgreesWithTheSumOfAngles, ()) {
  const std::vector<Point> polygon = any_points(12);
  const Point p{*rc::gen::inRange(-12, 12) + 0.3718281, *rc::gen::inRange(-12, 12) + 0.4142135};
  double angle = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec a = polygon[i] - p, b = polygon[(i + 1) % polygon.size()] - p;
    angle += std::atan2(cross(a, b), dot(a, b));
  }
  const long turns = std::lround(angle / (2.0 * std::acos(-1.0)));
  RC_ASSERT(contains(polygon, p, FillRule::kNonZero) == (turns != 0));
  RC_ASSERT(contains(polygon, p, FillRule::kEvenOdd) == (turns % 2 != 0));
}

RC_GTEST_PROP(Polygon, PointsComputedOnAnEdgeAreInside, ()) {
  const std::vector<Point> polygon = any_points(8);
  RC_PRE(!polygon.empty());
  const auto i = *rc::gen::inRange<std::size_t>(0, polygon.size());
  const double t = *rc::gen::inRange(0, 1000) / 999.0;
  const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
  RC_ASSERT(contains(polygon, lerp(a, b, t), FillRule::kEvenOdd));
  RC_ASSERT(contains(polygon, lerp(a, b, t), FillRule::kNonZero));
}

TEST(Polygon, AreaHasTheSignOfTheTurn) {
  EXPECT_EQ(area(kSquare), 16.0);
  EXPECT_EQ(area(std::vector<Point>(kSquare.rbegin(), kSquare.rend())), -16.0);
  EXPECT_EQ(area({}), 0.0);
  EXPECT_EQ(area(std::vector<Point>{{1, 1}, {2, 2}}), 0.0);
}

RC_GTEST_PROP(Polygon, SimplifiedLineStaysWithinTheTolerance, ()) {
  const std::vector<Point> line = any_points(60);
  const double tolerance = *rc::gen::inRange(0, 80) * 0.125;
  const std::vector<Point> kept = simplified(line, tolerance);
  RC_ASSERT(kept.size() <= line.size());
  if (line.empty()) return;
  RC_ASSERT(kept.front() == line.front() && kept.back() == line.back());
  for (const Point& p : line) {
    RC_ASSERT(nearest_on_polyline(kept, p).distance_squared <= tolerance * tolerance + 1e-12);
  }
}

TEST(Polygon, SimplifyDropsCollinearPointsAndCountsTheKept) {
  const std::vector<Point> line{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}};
  std::vector<std::uint8_t> keep(line.size());
  EXPECT_EQ(mark_simplified(line, 0.0, keep), 3U);
  EXPECT_EQ(keep, (std::vector<std::uint8_t>{1, 0, 1, 0, 1}));
  EXPECT_EQ(mark_simplified({}, 1.0, {}), 0U);
  EXPECT_EQ(simplified(std::vector<Point>{{7, 7}}, 1.0).size(), 1U);
}

}  // namespace
}  // namespace felt::polygon_test
