#include "felt/io/svg/svg_nonzero.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <vector>

#include "felt/io/svg/svg_fill.h"

namespace felt::svg_nonzero_test {
namespace {

constexpr double kSideMm = 100.0;
constexpr double kNearMm = 0.02;  ///< points closer to the boundary are not compared
constexpr int kSteps = 200;       ///< lines per curve of the reference

using Polygon = std::vector<Point>;

/// Returns a closed contour of random straight lines, or of random curves.
SvgContour random_contour(std::mt19937_64& random, bool curved) {
  std::uniform_real_distribution<double> side(0.0, kSideMm);
  const auto point = [&] { return Point{side(random), side(random)}; };
  SvgContour contour{{point()}, true};
  const std::size_t corners = 2 + random() % (curved ? 4 : 8);
  for (std::size_t i = 0; i <= corners; ++i) {
    const Point from = contour.points.back();
    const Point to = i < corners ? point() : contour.points.front();
    const Point a = curved ? point() : lerp(from, to, 1.0 / 3.0);
    const Point b = curved ? point() : lerp(from, to, 2.0 / 3.0);
    contour.points.insert(contour.points.end(), {a, b, to});
  }
  return contour;
}

/// Returns points on the curves of a loop.
Polygon polygon_of(const std::vector<Point>& points) {
  Polygon polygon;
  for (std::size_t i = 0; i + 3 < points.size(); i += 3) {
    const Cubic c{{points[i], points[i + 1], points[i + 2], points[i + 3]}};
    for (int k = 0; k < kSteps; ++k) polygon.push_back(evaluate(c, double(k) / kSteps));
  }
  return polygon;
}

/// Returns how often the polygon winds around a point: the turns of the direction to its corners.
/// This is another way of counting than that of the code under test.
int turns_around(std::span<const Point> polygon, Point p) {
  double angle = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec a = polygon[i] - p, b = polygon[(i + 1) % polygon.size()] - p;
    angle += std::atan2(cross(a, b), dot(a, b));
  }
  return static_cast<int>(std::lround(angle / (2.0 * std::numbers::pi)));
}

double distance_to(std::span<const Point> polygon, Point p) {
  double nearest = kSideMm;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i];
    const Vec side = polygon[(i + 1) % polygon.size()] - a;
    const double length = dot(side, side);
    const double t = length > 0.0 ? std::clamp(dot(p - a, side) / length, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, distance(p, a + t * side));
  }
  return nearest;
}

/// Compares the winding number of the contours with the even-odd rule of the area at random points.
void check_area(const std::vector<SvgContour>& contours, const SvgArea& area,
                std::mt19937_64& random) {
  std::vector<Polygon> before, after;
  for (const SvgContour& c : contours) before.push_back(polygon_of(c.points));
  for (const FillLoop& loop : area.fill.loops) after.push_back(polygon_of(loop.points));
  std::uniform_real_distribution<double> side(0.0, kSideMm);
  for (int i = 0; i < 60; ++i) {
    const Point p{side(random), side(random)};
    int turns = 0, crossings = 0;
    double nearest = kSideMm;
    for (const Polygon& polygon : before) {
      turns += turns_around(polygon, p);
      nearest = std::min(nearest, distance_to(polygon, p));
    }
    if (nearest < kNearMm) continue;
    for (const Polygon& polygon : after) crossings += turns_around(polygon, p);
    RC_ASSERT((turns != 0) == (crossings % 2 != 0));
  }
}

RC_GTEST_PROP(SvgNonzero, PolygonsCoverTheSameAreaByTheEvenOddRule, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  std::vector<SvgContour> contours;
  for (std::size_t n = 1 + random() % 4; n > 0; --n) {
    contours.push_back(random_contour(random, false));
  }
  const SvgArea area = svg_area(contours, Affine(), false);
  // Polygons that nearly touch may be left as they are, which the reader reports (173678222679).
  RC_PRE(!area.may_lack_parts);
  RC_ASSERT(check_fill(area.fill).has_value());
  check_area(contours, area, random);
}

RC_GTEST_PROP(SvgNonzero, CurvesCoverTheSameAreaByTheEvenOddRule, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  std::vector<SvgContour> contours;
  for (std::size_t n = 1 + random() % 3; n > 0; --n) {
    contours.push_back(random_contour(random, true));
  }
  const SvgArea area = svg_area(contours, Affine(), false);
  // Curves that nearly touch may be left as they are, which the reader reports.
  if (!area.may_lack_parts) check_area(contours, area, random);
}

RC_GTEST_PROP(SvgNonzero, ReversingAllContoursCoversTheSameArea, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  std::vector<SvgContour> contours{random_contour(random, false), random_contour(random, false)};
  std::vector<SvgContour> reversed = contours;
  for (SvgContour& c : reversed) std::reverse(c.points.begin(), c.points.end());
  check_area(contours, svg_area(reversed, Affine(), false), random);
}

TEST(SvgNonzero, ShapesWhoseSidesLieOnEachOtherAreLeftAsTheyAre) {
  const auto line = [](Point a, Point b) {
    return std::vector<Point>{lerp(a, b, 1.0 / 3.0), lerp(a, b, 2.0 / 3.0), b};
  };
  std::vector<FillLoop> loops;
  for (const double height : {20.0, 30.0}) {
    FillLoop loop{{{0, 0}}, {}};
    for (const Point p : {Point{20, 0}, Point{20, height}, Point{0, height}, Point{0, 0}}) {
      const auto side = line(loop.points.back(), p);
      loop.points.insert(loop.points.end(), side.begin(), side.end());
    }
    loops.push_back(loop);
  }
  const std::vector<FillLoop> before = loops;
  EXPECT_FALSE(resolve_crossings(loops));
  EXPECT_EQ(loops, before);
}

}  // namespace
}  // namespace felt::svg_nonzero_test
