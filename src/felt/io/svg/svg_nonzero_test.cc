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
  RC_ASSERT(!area.may_lack_parts);
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
  RC_ASSERT(!area.may_lack_parts);
  check_area(contours, area, random);
}

RC_GTEST_PROP(SvgNonzero, ReversingAllContoursCoversTheSameArea, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  std::vector<SvgContour> contours{random_contour(random, false), random_contour(random, false)};
  std::vector<SvgContour> reversed = contours;
  for (SvgContour& c : reversed) std::reverse(c.points.begin(), c.points.end());
  check_area(contours, svg_area(reversed, Affine(), false), random);
}

/// Returns a closed contour through corners.
SvgContour polygon_contour(const Polygon& corners) {
  SvgContour contour{{corners.front()}, true};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Cubic side = straight(corners[i], corners[(i + 1) % corners.size()]);
    contour.points.insert(contour.points.end(), {side.p[1], side.p[2], side.p[3]});
  }
  return contour;
}

SvgContour circle_contour(Point center, double radius) {
  SvgContour contour{{center + Vec{radius, 0.0}}, true};
  for (int i = 0; i < 4; ++i) {
    constexpr double kHandle = 0.5522847498307936;
    const double angle = i * std::numbers::pi / 2.0;
    const Vec u{radius * std::round(std::cos(angle)), radius * std::round(std::sin(angle))};
    const Vec v{-u.y, u.x};
    contour.points.insert(contour.points.end(),
                          {center + u + kHandle * v, center + v + kHandle * u, center + v});
  }
  contour.points.back() = contour.points.front();
  return contour;
}

/// Returns shapes whose corners and sides often lie on each other: on a coarse grid, repeated,
/// reversed, shifted by little, and with sides that are retraced.
std::vector<SvgContour> shared_edges(std::mt19937_64& random) {
  const auto pick = [&random](int from, int to) {
    return from + static_cast<int>(random() % static_cast<std::uint64_t>(to - from + 1));
  };
  const auto corner = [&] { return Point{10.0 * pick(1, 8), 10.0 * pick(1, 8)}; };
  std::vector<SvgContour> contours;
  for (int n = pick(1, 6); n > 0; --n) {
    const int kind = pick(0, 5);
    if (kind == 0) {
      Polygon corners;
      for (int i = pick(2, 6); i >= 0; --i) corners.push_back(corner());
      contours.push_back(polygon_contour(corners));
    } else if (kind <= 2) {
      const Point a = corner(), b = a + Vec{10.0 * pick(1, 3), 10.0 * pick(1, 3)};
      contours.push_back(polygon_contour({a, {b.x, a.y}, b, {a.x, b.y}}));
    } else if (kind == 3) {
      contours.push_back(circle_contour(corner(), 10.0 * pick(1, 3)));
    } else if (kind == 4) {
      const Point a = corner(), b = corner(), c = corner();
      contours.push_back(polygon_contour({a, b, a, c, b, lerp(b, c, 0.5)}));
    } else if (!contours.empty()) {
      SvgContour again = contours[random() % contours.size()];
      constexpr double kShifts[] = {0.0, 0.0, 1e-6, 1e-4, 3e-4, 0.01, 0.1};
      const double shift = kShifts[random() % std::size(kShifts)];
      for (Point& p : again.points) p = p + Vec{shift, 0.5 * shift};
      if (pick(0, 2) == 0) std::reverse(again.points.begin(), again.points.end());
      contours.push_back(std::move(again));
    }
  }
  if (contours.empty()) contours.push_back(circle_contour({50, 50}, 20.0));
  return contours;
}

/// Returns the winding numbers at points of a horizontal line, by the crossings to their right.
std::vector<int> windings_along(const std::vector<Polygon>& polygons, double y, int count) {
  std::vector<int> windings(static_cast<std::size_t>(count), 0);
  for (const Polygon& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if ((a.y <= y) == (b.y <= y)) continue;
      const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
      for (int k = 0; k < count && (k + 0.5) * kSideMm / count < x; ++k) {
        windings[static_cast<std::size_t>(k)] += a.y <= y ? 1 : -1;
      }
    }
  }
  return windings;
}

/// Returns the number of pixels, of 100 x 100, that the even-odd rule of the area paints otherwise
/// than the rule of the contours, hairlines along the boundary excepted.
int wrong_pixels(const std::vector<SvgContour>& contours, const Affine& to_mm, bool even_odd) {
  constexpr int kPixels = 100;
  const SvgArea area = svg_area(contours, to_mm, even_odd);
  EXPECT_FALSE(area.may_lack_parts);
  std::vector<Polygon> before, after;
  for (const SvgContour& c : contours) {
    before.push_back(polygon_of(c.points));
    for (Point& p : before.back()) p = apply(to_mm, p);
  }
  for (const FillLoop& loop : area.fill.loops) {
    EXPECT_EQ(loop.points.front(), loop.points.back());
    after.push_back(polygon_of(loop.points));
  }
  int wrong = 0;
  for (int row = 0; row < kPixels; ++row) {
    const double y = (row + 0.4871) * kSideMm / kPixels;
    const std::vector<int> turns = windings_along(before, y, kPixels);
    const std::vector<int> crossings = windings_along(after, y, kPixels);
    for (std::size_t k = 0; k < turns.size(); ++k) {
      const bool painted = even_odd ? turns[k] % 2 != 0 : turns[k] != 0;
      if (painted == (crossings[k] % 2 != 0)) continue;
      const Point p{(static_cast<double>(k) + 0.5) * kSideMm / kPixels, y};
      double nearest = kSideMm;
      for (const Polygon& polygon : before) nearest = std::min(nearest, distance_to(polygon, p));
      if (nearest > kNearMm) ++wrong;
    }
  }
  return wrong;
}

TEST(SvgNonzero, FiveHundredArrangementsOfSharedEdgesLookAsInABrowser) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    std::mt19937_64 random(seed);
    const std::vector<SvgContour> contours = shared_edges(random);
    const double angle = seed % 3 == 0 ? 0.3 : 0.0;
    const Affine turned =
        then(then(translation({-50, -50}), rotation(angle)), translation({50, 50}));
    EXPECT_EQ(wrong_pixels(contours, turned, seed % 10 == 9), 0) << "seed " << seed;
  }
}

TEST(SvgNonzero, AShapeDrawnTwiceIsThatShapeBitForBit) {
  for (const SvgContour& one :
       {circle_contour({50, 50}, 30.0), polygon_contour({{10, 10}, {70, 15}, {40, 80}})}) {
    const Fill once = svg_area({one}, Affine(), false).fill;
    EXPECT_EQ(once.loops.front().points, one.points);
    EXPECT_EQ(svg_area({one, one}, Affine(), false).fill, once);
    EXPECT_EQ(svg_area({one, one, one}, Affine(), false).fill, once);
  }
}

TEST(SvgNonzero, OppositeContoursOnEachOtherPaintNothing) {
  const SvgContour one = circle_contour({50, 50}, 30.0);
  SvgContour other = one;
  std::reverse(other.points.begin(), other.points.end());
  const SvgArea area = svg_area({one, other}, Affine(), false);
  EXPECT_TRUE(area.fill.loops.empty());
  EXPECT_FALSE(area.may_lack_parts);
}

TEST(SvgNonzero, OverlappingBarsAreOneOutline) {
  const auto bar = [](double x0, double y0, double x1, double y1) {
    return polygon_contour({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
  };
  const SvgArea letter = svg_area({bar(10, 10, 70, 20), bar(35, 10, 45, 80)}, Affine(), false);
  ASSERT_EQ(letter.fill.loops.size(), 1u);
  EXPECT_EQ(wrong_pixels({bar(10, 10, 70, 20), bar(35, 10, 45, 80)}, Affine(), false), 0);
}

}  // namespace
}  // namespace felt::svg_nonzero_test
