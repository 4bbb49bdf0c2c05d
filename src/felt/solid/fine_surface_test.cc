#include "felt/solid/fine_surface.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "felt/geometry/polyline.h"
#include "felt/geometry/triangle_tree.h"
#include "felt/solid/inflate.h"
#include "felt/solid/testing/random_bodies.h"
#include "felt/solid/testing/solid_drawings.h"
#include "felt/solid/testing/surface.h"

namespace felt::fine_surface_test {
namespace {

using testing::SolidDrawing;

constexpr double kDegree = std::numbers::pi / 180.0;

Solid inflated(const SolidDrawing& drawing, std::optional<int> triangles = {}) {
  Result<InflatedDrawing> result = inflate(drawing.document, {.triangles = triangles});
  FELT_CHECK(result.has_value());
  return result->solid;
}

SolidDrawing ellipse(double a, double b) {
  std::vector<Point> at;
  for (int i = 0; i < 120; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 120.0;
    at.push_back({a * std::cos(angle), b * std::sin(angle)});
  }
  SolidDrawing drawing;
  drawing.add(testing::stroke_of(testing::smooth_ring(at), true));
  return drawing;
}

TEST(FineSurface, KeepsTheNumberOfTrianglesIfThereIsOne) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const SolidDrawing drawing = ellipse(20.0 + 2.0 * static_cast<double>(seed), 20.0);
    for (const int wanted : {2000, 5000, 20000}) {
      const auto count = static_cast<double>(triangle_count(inflated(drawing, wanted)));
      EXPECT_GT(count, 0.6 * wanted);
      EXPECT_LT(count, 1.2 * wanted);
    }
  }
}

/// Returns the angles in degrees between the facets at both sides of the edges for which `counts`
/// is true, in order.
template <typename Counts>
std::vector<double> turns(const SolidBody& body, Counts counts) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3> normals;
  std::vector<double> all;
  for (const SolidBody::Triangle& t : body.triangles) {
    const Vec3 n =
        cross(body.points[t[1]] - body.points[t[0]], body.points[t[2]] - body.points[t[0]]);
    for (std::size_t k = 0; k < 3; ++k) normals[{t[k], t[(k + 1) % 3]}] = (1.0 / norm(n)) * n;
  }
  for (const auto& [edge, n] : normals) {
    const auto [a, b] = edge;
    if (a > b || !counts(a, b)) continue;
    all.push_back(std::acos(std::clamp(dot(n, normals.at({b, a})), -1.0, 1.0)) / kDegree);
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST(FineSurface, TheSurfaceIsRoundAtTheOutline) {
  for (const SolidDrawing& drawing : {ellipse(50, 50), ellipse(60, 20), ellipse(30, 6)}) {
    const Solid solid = inflated(drawing);
    const SolidBody& body = solid.bodies.at(0);
    const std::vector<double> border = turns(body, [&](std::uint32_t a, std::uint32_t b) {
      return a < body.border_count && b < body.border_count;
    });
    EXPECT_LE(border[border.size() * 98 / 100], 8.0);
    const std::vector<double> all = turns(body, [](auto, auto) { return true; });
    EXPECT_LE(all[all.size() / 2], 8.0);
    EXPECT_LE(all[all.size() * 98 / 100], 16.0);
  }
}

// u of an ellipse is a polynomial of degree 2, which the elements contain: the surface is exact but
// for the polygon of the border.
TEST(FineSurface, AnEllipseHasNoRipples) {
  const double a = 60.0, b = 20.0;
  const Solid solid = inflated(ellipse(a, b));
  const double c2 = 2.0 * a * a * b * b / (a * a + b * b);  // the square of half of the thickness
  double worst_turn = 0.0;
  const SolidBody& body = solid.bodies.at(0);
  const std::vector<Vec3> normals = point_normals(body);
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    const Vec3& p = body.points[i];
    EXPECT_NEAR(p.x * p.x / (a * a) + p.y * p.y / (b * b) + p.z * p.z / c2, 1.0, 0.005);
    const Vec3 exact{p.x / (a * a), p.y / (b * b), p.z / c2};
    worst_turn =
        std::max(worst_turn, std::acos(std::min(1.0, dot(normals[i], exact) / norm(exact))));
  }
  EXPECT_LE(worst_turn, 3.0 * kDegree);
}

TEST(FineSurface, ABallHasExactNormalsWhereverItsTrianglesAreUneven) {
  const SolidBody ball = testing::ball(20.0);
  const std::vector<Vec3> normals = point_normals(ball);
  for (std::size_t i = 0; i < ball.points.size(); ++i) {
    EXPECT_GT(dot(normals[i], ball.points[i]) / norm(ball.points[i]), std::cos(1.5 * kDegree));
  }
}

/// Returns an outline with pointed tips: leaves around a centre, as ears and tails are.
SolidDrawing tips(Random& random) {
  const int count = 3 + static_cast<int>(random.between(0.0, 4.0));
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const auto polar = [&](double turn, double r) {
      const double angle = 2.0 * std::numbers::pi * (i + turn) / count;
      return Point{r * std::cos(angle), r * std::sin(angle)};
    };
    const double tip = random.between(40.0, 60.0), notch = random.between(15.0, 25.0);
    if (i == 0) points.push_back(polar(0.0, notch));
    points.insert(points.end(), {polar(0.2, 1.5 * notch), polar(0.4, 0.7 * tip), polar(0.5, tip)});
    points.insert(points.end(), {polar(0.6, 0.7 * tip), polar(0.8, 1.5 * notch)});
    points.push_back(i + 1 < count ? polar(1.0, notch) : points.front());
  }
  SolidDrawing drawing;
  drawing.add(testing::stroke_of(points, true));
  return drawing;
}

// The polygon of the border is what is seen from the front. A fifth of a pixel, if the body is
// 1,200 pixels large; tips end where they are narrower than a file can tell.
TEST(FineSurface, TheBorderIsWithinAFifthOfAPixelOfTheOutline) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const SolidDrawing drawing = tips(random);
    const Solid solid = inflated(drawing);
    const SolidBody& body = solid.bodies.at(0);
    EXPECT_EQ(testing::examine(testing::surface_of(body)).fault, "");
    std::vector<std::pair<Point, Point>> edges;
    double extent = 0.0;
    for (const SolidBody::Triangle& t : body.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        if (a >= body.border_count || b >= body.border_count || a > b) continue;
        const Vec3 &p = body.points[a], &q = body.points[b];
        edges.push_back({{p.x, p.y}, {q.x, q.y}});
        extent = std::max({extent, std::fabs(p.x), std::fabs(p.y)});
      }
    }
    const double px_mm = 2.0 * extent / 1200.0;
    const StrokePtr stroke = drawing.document.find({1});
    for (int s = 0; s < stroke->segment_count(); ++s) {
      for (int k = 0; k < 40; ++k) {
        const Point at = evaluate(stroke->segment(s), (k + 0.5) / 40.0);
        const Point p{at.x - solid.origin.x, solid.origin.y - at.y};
        double best = 1e300;
        for (const auto& [a, b] : edges) {
          best = std::min(best, nearest_on_line(a, b, p).distance_squared);
        }
        EXPECT_LE(std::sqrt(best), 0.2 * px_mm) << at.x << ' ' << at.y;
      }
    }
  }
}

// Where two discs meet, the outline has inner corners, from which creases lead inwards. Beside
// these creases, triangles that are too large for the corner turn by 60 degrees and more: jagged
// light.
TEST(FineSurface, ThereAreNoRipplesBesideTheCreaseOfAnInnerCorner) {
  for (const double r : {14.0, 18.0, 22.0}) {
    for (const double right_mm : {24.0, 30.0}) {
      SCOPED_TRACE(std::to_string(r) + ", " + std::to_string(right_mm));
      const Vec between{right_mm, 6.0};
      SolidDrawing drawing;
      drawing.circle({50.0, 50.0}, 20.0);
      drawing.circle(Point{50.0, 50.0} + between, r);
      const Solid solid = inflated(drawing);
      // The corners are on the line at this distance from the first centre, across the line between
      // the centres.
      const double d = norm(between), u = (400.0 - r * r + d * d) / (2.0 * d);
      const Vec axis = (1.0 / d) * between, across = perp(axis);
      for (const double side : {-1.0, 1.0}) {
        const Point corner =
            Point{50.0, 50.0} + u * axis + side * std::sqrt(400.0 - u * u) * across;
        const SolidBody& body = solid.bodies.at(0);
        const auto is_beside = [&](std::uint32_t a, std::uint32_t b) {
          const Vec3 p = 0.5 * (body.points[a] + body.points[b]);
          const Vec from = Point{solid.origin.x + p.x, solid.origin.y - p.y} - corner;
          const double inwards = -side * dot(across, from), off = std::fabs(dot(axis, from));
          return norm(from) > 0.5 && norm(from) < 3.0 && off > 0.15 && inwards > 0.0;
        };
        const std::vector<double> all = turns(body, is_beside);
        ASSERT_GT(all.size(), 20U);
        EXPECT_LT(all.back(), 30.0);
      }
    }
  }
}

RC_GTEST_PROP(FineSurface, DividedTrianglesFillTheMesh, ()) {
  Random random(*rc::gen::inRange<std::uint64_t>(1, 100000));
  // A square of triangles with any values inside.
  PlaneMesh mesh;
  std::vector<std::uint8_t> on_border;
  SquaredHeights squares;
  constexpr std::uint32_t kSide = 5;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    const std::uint32_t x = i % kSide, y = i / kSide;
    mesh.points.push_back({1.0 * x, 1.0 * y});
    on_border.push_back(x == 0 || y == 0 || x == kSide - 1 || y == kSide - 1 ? 1 : 0);
    squares.at_points.push_back(on_border.back() ? 0.0 : random.between(0.1, 9.0));
  }
  for (std::uint32_t y = 0; y + 1 < kSide; ++y) {
    for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
      const std::uint32_t a = y * kSide + x;
      mesh.triangles.push_back({a, a + 1, a + kSide + 1});
      mesh.triangles.push_back({a, a + kSide + 1, a + kSide});
    }
  }
  for (const auto& t : mesh.triangles) {
    std::array<double, 3> middles{};
    for (std::size_t k = 0; k < 3; ++k) {
      middles[k] = 0.5 * (squares.at_points[t[k]] + squares.at_points[t[(k + 1) % 3]]);
    }
    squares.at_middles.push_back(middles);
  }
  const FineSurface fine = fine_surface(
      mesh, on_border, squares, {.max_turn_rad = random.between(0.1, 0.8), .min_edge_mm = 0.02});
  double area = 0.0;
  for (const auto& [a, b, c] : fine.mesh.triangles) {
    const double twice =
        cross(fine.mesh.points[b] - fine.mesh.points[a], fine.mesh.points[c] - fine.mesh.points[a]);
    RC_ASSERT(twice > 0.0);
    area += 0.5 * twice;
  }
  RC_ASSERT(std::fabs(area - 16.0) < 1e-9);
  RC_ASSERT(fine.mesh.triangles.size() > mesh.triangles.size());
  for (std::size_t i = 0; i < fine.heights.size(); ++i) {
    RC_ASSERT((fine.heights[i] > 0.0) == (fine.on_border[i] == 0));
  }
}

}  // namespace
}  // namespace felt::fine_surface_test
