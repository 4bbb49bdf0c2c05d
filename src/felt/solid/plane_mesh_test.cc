#include "felt/solid/plane_mesh.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "felt/base/constants.h"
#include "felt/base/random.h"

namespace felt::plane_mesh_test {
namespace {

/// The places at which parts of an outline come near each other.
enum class Narrow { kSpike, kTips, kSliver, kShortEdge, kCount };

/// Returns an outline with parts that are `gap_mm` apart, somewhere on a page.
std::vector<Point> outline_with(Narrow narrow, double gap_mm, Random& random) {
  std::vector<Point> points;
  switch (narrow) {
    case Narrow::kSpike:
      points = {{0, 0},    {20, 0}, {20, 20}, {10.3, 20}, {random.between(7.0, 13.0), gap_mm},
                {9.7, 20}, {0, 20}};
      break;
    case Narrow::kTips:
      points = {{0, 0},   {9.7, 0},   {10, 10},          {10.3, 0}, {20, 0},
                {20, 20}, {10.3, 20}, {10, 10 + gap_mm}, {9.7, 20}, {0, 20}};
      break;
    case Narrow::kSliver:
      points = {{0, 0},
                {20, gap_mm},
                {20, random.between(2.0, 3.0) * gap_mm},
                {random.between(1.0, 19.0), 10}};
      break;
    case Narrow::kShortEdge:
    case Narrow::kCount:
      points = {{0, 0},
                {20, 0},
                {20, 20},
                {20 - gap_mm, 20 + random.between(-1.0, 1.0) * gap_mm},
                {0, 20}};
      break;
  }
  const double angle = random.between(0.0, kTau);
  const Vec x{std::cos(angle), std::sin(angle)};
  const Point at{random.between(0.0, 200.0), random.between(0.0, 200.0)};
  for (Point& p : points) p = at + p.x * x + p.y * perp(x);
  return points;
}

Result<PlaneMesh> filled(const std::vector<Point>& points) {
  std::vector<std::array<std::size_t, 2>> edges;
  for (std::size_t i = 0; i < points.size(); ++i) edges.push_back({i, (i + 1) % points.size()});
  return fill_plane(points, edges, 2.0, 100'000);
}

double area_mm2(const PlaneMesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += 0.5 * cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
  }
  return sum;
}

// The mesher accessed memory out of bounds, or did not end, if two parts were only some rounding
// errors apart, as at the mirror axis of a drawing.
RC_GTEST_PROP(PlaneMesh, PartsThatNearlyTouchAreReportedAndOthersAreFilled, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const auto narrow = static_cast<Narrow>(*rc::gen::inRange(0, static_cast<int>(Narrow::kCount)));
  const double gap_mm = std::pow(10.0, -0.1 * *rc::gen::inRange(10, 165));
  const std::vector<Point> outline = outline_with(narrow, gap_mm, random);
  const Result<PlaneMesh> mesh = filled(outline);
  if (gap_mm > 1e-8) {
    RC_ASSERT(mesh.has_value());
    double area = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      area += 0.5 * cross(outline[i] - outline[0], outline[(i + 1) % outline.size()] - outline[0]);
    }
    RC_ASSERT(std::fabs(area_mm2(*mesh) - std::fabs(area)) < 1e-6);
  } else if (gap_mm < 1e-10) {
    RC_ASSERT(!mesh.has_value());
    RC_ASSERT(!mesh.error().message.empty());
  }
}

TEST(PlaneMesh, EqualPointsAreReported) {
  EXPECT_FALSE(filled({{0, 0}, {20, 0}, {20, 0}, {10, 10}}));
  EXPECT_FALSE(triangulate_ring({{0, 0}, {20, 0}, {20, 0}, {10, 10}}));
  EXPECT_FALSE(filled({{0, 0}, {20, 0}, {10, 0}}));
}

}  // namespace
}  // namespace felt::plane_mesh_test
