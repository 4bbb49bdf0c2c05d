#include "felt/solid/smooth_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "felt/geometry/triangle_tree.h"
#include "felt/solid/body_parts.h"
#include "felt/solid/cut_body.h"
#include "felt/solid/testing/random_bodies.h"
#include "felt/solid/testing/surface.h"
#include "felt/solid/view_frame.h"

namespace felt::smooth_body_test {
namespace {

constexpr Vec3 kFromFront{0.0, 0.0, -1.0};

/// Returns the largest angle between the normals of two triangles with a common edge, in radians.
/// Triangles that are thinner than a tenth of a mean edge do not count: a cut leaves some, and
/// their normals say nothing about the shape.
double sharpest_edge(const SolidBody& body) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3> normals;
  const double min_height = 0.1 * mean_edge_mm(body);
  for (const SolidBody::Triangle& t : body.triangles) {
    const Vec3 &a = body.points[t[0]], &b = body.points[t[1]], &c = body.points[t[2]];
    const Vec3 n = cross(b - a, c - a);
    if (norm(n) < min_height * std::max({norm(b - a), norm(c - b), norm(a - c)})) continue;
    for (std::size_t k = 0; k < 3; ++k) normals[{t[k], t[(k + 1) % 3]}] = (1.0 / norm(n)) * n;
  }
  double sharpest = 0.0;
  for (const auto& [edge, normal] : normals) {
    const auto twin = normals.find({edge.second, edge.first});
    if (twin == normals.end()) continue;
    sharpest = std::max(sharpest, std::acos(std::clamp(dot(normal, twin->second), -1.0, 1.0)));
  }
  return sharpest;
}

TEST(SmoothBody, LeavesTheBodyAwayFromTheStroke) {
  const SolidBody ball = testing::ball(20.0);
  const Result<SolidBody> smooth =
      smooth_body(ball, std::vector<Vec3>{{-10, 0, 0}, {10, 0, 0}}, kFromFront, 8.0, 1.0);
  ASSERT_TRUE(smooth) << smooth.error().message;
  int moved = 0;
  for (std::size_t i = 0; i < ball.points.size(); ++i) {
    if (ball.points[i] == smooth->points[i]) continue;
    ++moved;
    EXPECT_LT(std::fabs(ball.points[i].y), 4.0);
    EXPECT_GT(ball.points[i].z, 0.0);
  }
  EXPECT_GT(moved, 20);
}

TEST(SmoothBody, RefusesAStrokeBesideTheBody) {
  const Result<SolidBody> missed =
      smooth_body(testing::ball(20.0), std::vector<Vec3>{{30, 0, 0}}, kFromFront, 5.0, 1.0);
  ASSERT_FALSE(missed);
  EXPECT_EQ(missed.error().message, "the stroke does not touch the body");
}

// A cut body has sharp edges. Smoothing the whole of it makes them less sharp.
TEST(SmoothBody, R60_MakesCutEdgesLessSharpAndKeepsTheVolume) {
  int smoothed = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    SolidBody body = testing::random_body(random, 1500);
    const ViewFrame frame = view_frame(testing::random_direction(random));
    const double at = random.between(-8.0, 8.0);
    const auto cut = cut_body(
        body,
        std::vector<Vec3>{frame.to_solid({at, -100}, 0.0), frame.to_solid({at + 1.0, 100}, 0.0)},
        -1.0 * frame.towards);
    ASSERT_TRUE(cut) << "seed " << seed;
    if (!*cut) continue;
    body = (*cut)->front();
    const double amount = random.between(0.3, 1.0);
    const Result<SolidBody> smooth = smooth_body(body, {}, kFromFront, 0.0, amount);
    ASSERT_TRUE(smooth) << "seed " << seed << ": " << smooth.error().message;
    ++smoothed;
    EXPECT_LT(sharpest_edge(*smooth), sharpest_edge(body)) << "seed " << seed;
    EXPECT_NEAR(volume_mm3(*smooth), volume_mm3(body), 0.02 * volume_mm3(body)) << "seed " << seed;
    EXPECT_EQ(testing::examine(testing::surface_of(*smooth)).fault, "") << "seed " << seed;
    EXPECT_EQ(smooth->triangles, body.triangles);
  }
  EXPECT_GE(smoothed, 20);
}

}  // namespace
}  // namespace felt::smooth_body_test
