#include "felt/solid/creases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "felt/geometry/triangle_tree.h"
#include "felt/solid/body_edits.h"
#include "felt/solid/inflate.h"
#include "felt/solid/testing/solid_drawings.h"

namespace felt::creases_test {
namespace {

/// Returns the inflated ellipse with the half axes 30 and `b` around (0, 0).
Solid ellipse(double b, const InflateOptions& options) {
  std::vector<Point> at;
  for (int i = 0; i < 24; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 24;
    at.push_back({30.0 * std::cos(a), b * std::sin(a)});
  }
  testing::SolidDrawing drawing;
  drawing.add(testing::stroke_of(testing::smooth_ring(at), true));
  return inflate(drawing.document, options).value().solid;
}

/// A straight cut through a point. Its face has the normal `out` and removes what is there.
struct Plane {
  Point through;
  Vec out;

  [[nodiscard]] double beyond(const Vec3& p) const { return dot(out, Point{p.x, p.y} - through); }
  [[nodiscard]] BodyEdit cut(Point origin) const {
    const Point at{through.x + origin.x, through.y - origin.y};
    // What is at the left of the stroke goes.
    const Point from = at + 60.0 * perp(out), to = at - 60.0 * perp(out);
    return {.kind = BodyEditKind::kCut, .path_mm = {{from.x, from.y, 0.0}, {to.x, to.y, 0.0}}};
  }
};

/// Returns the largest part of an ellipse that is cut, for shading.
SolidBody shaded(const Solid& solid, const Plane& plane) {
  const EditedSolid edited =
      apply_body_edits(solid, std::vector<BodyEdit>{plane.cut(solid.origin)});
  EXPECT_EQ(edited.refusals[0], "");
  EXPECT_EQ(edited.solid.bodies.size(), 1U);
  return split_at_creases(edited.solid.bodies.front());
}

constexpr double kOnPlaneMm = 0.02, kSameNormal = 0.99;

// The planes meet the surface at 30 to 90 degrees.
TEST(Creases, ACutIsSharpAllAroundHoweverItMeetsTheSurface) {
  const Solid body = ellipse(18.0, {});
  for (const Plane& plane : {Plane{{20.0, 0.0}, {1.0, 0.0}}, Plane{{25.0, 0.0}, {1.0, 0.0}},
                             Plane{{14.0, 6.0}, {0.6, 0.8}}, Plane{{0.0, 12.0}, {0.0, 1.0}}}) {
    const SolidBody split = shaded(body, plane);
    const std::vector<Vec3> normals = point_normals(split);
    int faces = 0, blurred = 0;
    for (const SolidBody::Triangle& t : split.triangles) {
      const Vec3& at = split.points[t[0]];
      const Vec3 facet = cross(split.points[t[1]] - at, split.points[t[2]] - at);
      const bool is_face =
          std::fabs(plane.beyond(at)) < kOnPlaneMm &&
          facet.x * plane.out.x + facet.y * plane.out.y > kSameNormal * norm(facet);
      if (!is_face) continue;
      ++faces;
      for (const std::uint32_t i : t) {
        const Vec3& n = normals[i];
        blurred += n.x * plane.out.x + n.y * plane.out.y < kSameNormal ? 1 : 0;
      }
    }
    EXPECT_GT(faces, 50);
    EXPECT_EQ(blurred, 0) << plane.through.x << ", " << plane.through.y;
  }
}

TEST(Creases, TheRestOfABodyThatWasCutStaysSmooth) {
  for (const int triangles : {300, 1000, 5000, 30'000}) {
    const Plane plane{{8.0, 0.0}, {1.0, 0.0}};
    const Solid whole = ellipse(18.0, {.triangles = triangles});
    const EditedSolid edited =
        apply_body_edits(whole, std::vector<BodyEdit>{plane.cut(whole.origin)});
    const SolidBody& body = edited.solid.bodies.front();
    const SolidBody split = split_at_creases(body);
    EXPECT_GT(split.points.size(), body.points.size()) << triangles;
    for (std::size_t i = body.points.size(); i < split.points.size(); ++i) {
      EXPECT_LT(std::fabs(plane.beyond(split.points[i])), kOnPlaneMm) << triangles;
    }
  }
}

}  // namespace
}  // namespace felt::creases_test
