#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "felt/geometry/nearest.h"
#include "felt/geometry/polyline.h"
#include "samples/inflate/inflated.h"

namespace felt::inflate_test {
namespace {

/// Returns a closed, smooth stroke through the points in this order. The handles at a point depend
/// on its neighbours.
Stroke ring_through(const std::vector<Point>& at) {
  const std::size_t n = at.size();
  StrokeData d;
  d.closed = true;
  d.points.push_back(at[0]);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec out = at[(i + 1) % n] - at[(i + n - 1) % n], in = at[(i + 2) % n] - at[i];
    const Point b = at[(i + 1) % n];
    d.points.insert(d.points.end(), {at[i] + out / 6.0, b - in / 6.0, b});
    d.joints.push_back(JointKind::kCorner);
  }
  d.widths = {{0, 1}, {static_cast<double>(n), 1}};
  return Stroke::create(d).value();
}

Stroke circle(double radius) {
  std::vector<Point> at;
  for (int k = 0; k < 24; ++k) {
    const double a = 2 * std::numbers::pi * k / 24;
    at.push_back({50 + radius * std::cos(a), 40 + radius * std::sin(a)});
  }
  return ring_through(at);
}

/// Returns a lumpy outline. It cannot cross itself, because it has one distance from the centre for
/// each direction.
Stroke lumpy(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  std::vector<Point> at;
  const int n = 8 + static_cast<int>(uniform(0, 30));
  const double size = uniform(1, 40);
  for (int k = 0; k < n; ++k) {
    const double a = 2 * std::numbers::pi * k / n, r = size * uniform(0.5, 1.0);
    at.push_back({r * std::cos(a), r * std::sin(a)});
  }
  return ring_through(at);
}

double volume(const Mesh& mesh) {
  double six = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 p = mesh.points[static_cast<std::size_t>(a)],
               q = mesh.points[static_cast<std::size_t>(b)],
               r = mesh.points[static_cast<std::size_t>(c)];
    six += p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) +
           p.z * (q.x * r.y - q.y * r.x);
  }
  return six / 6.0;
}

double thickness_at(const Mesh& mesh, Point place) {
  double best = 1e300, z = 0.0;
  for (const Vec3& p : mesh.points) {
    const double d = std::hypot(p.x - place.x, p.y + place.y);
    if (d < best && p.z >= 0.0) best = d, z = p.z;
  }
  return 2.0 * z;
}

void expect_watertight(const Mesh& mesh, const Stroke& stroke) {
  // Every edge exists twice, once in each direction. So the mesh is closed, and all faces have the
  // same orientation.
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_TRUE(edges.contains({edge.second, edge.first}));
  }
  const auto euler = static_cast<std::ptrdiff_t>(mesh.points.size()) -
                     static_cast<std::ptrdiff_t>(edges.size() / 2) +
                     static_cast<std::ptrdiff_t>(mesh.triangles.size());
  EXPECT_EQ(euler, 2);
  EXPECT_GT(volume(mesh), 0.0);
  // The outline is on the stroke, and every point of the stroke is near the outline.
  std::vector<Point> rim;
  for (int i = 0; i < mesh.outline_count; ++i) {
    const Vec3 p = mesh.points[static_cast<std::size_t>(i)];
    ASSERT_EQ(p.z, 0.0);
    rim.push_back({p.x, -p.y});
    double best = 1e300;
    for (int s = 0; s < stroke.segment_count(); ++s) {
      best = std::min(best, nearest(stroke.segment(s), rim.back()).distance_squared);
    }
    ASSERT_LE(std::sqrt(best), 0.05);
  }
  rim.push_back(rim.front());
  for (double u = 0; u < stroke.segment_count(); u += 0.01) {
    ASSERT_LE(std::sqrt(nearest_on_polyline(rim, stroke.position(u)).distance_squared), 0.05);
  }
}

TEST(Inflate, R54_AClosedStrokeBecomesAWatertightBody) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Stroke stroke = lumpy(seed);
    const auto mesh = inflated(stroke, 16);
    ASSERT_TRUE(mesh) << seed << ": " << mesh.error().message;
    expect_watertight(*mesh, stroke);
    if (::testing::Test::HasFatalFailure()) FAIL() << "seed " << seed;
  }
}

TEST(Inflate, R54_ADiscIsRoundAndTwiceTheSizeIsTwiceAsThick) {
  for (const double radius : {5.0, 20.0}) {
    const Stroke stroke = circle(radius);
    const auto mesh = inflated(stroke);
    ASSERT_TRUE(mesh);
    expect_watertight(*mesh, stroke);
    // The solution of laplace u = -3 in a disc is u = 3/4 (R^2 - r^2).
    EXPECT_NEAR(thickness_at(*mesh, {50, 40}), 2 * std::sqrt(0.75) * radius, 0.05 * radius);
    const double ball = 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3.0) * std::sqrt(0.75);
    EXPECT_NEAR(volume(*mesh), ball, 0.05 * ball);
  }
}

TEST(Inflate, R54_WidePartsAreFatAndNarrowOnesThin) {
  // A dumb-bell: two heads 20 mm wide, a neck of 6 mm.
  const Stroke stroke =
      ring_through({{-30, 0}, {-27, -7}, {-20, -10}, {-13, -7}, {-8, -3},  {0, -3},  {8, -3},
                    {13, -7}, {20, -10}, {27, -7},   {30, 0},   {27, 7},   {20, 10}, {13, 7},
                    {8, 3},   {0, 3},    {-8, 3},    {-13, 7},  {-20, 10}, {-27, 7}});
  const auto mesh = inflated(stroke);
  ASSERT_TRUE(mesh);
  expect_watertight(*mesh, stroke);
  EXPECT_GT(thickness_at(*mesh, {-20, 0}), 2.0 * thickness_at(*mesh, {0, 0}));
  EXPECT_GT(thickness_at(*mesh, {0, 0}), 4.0);
}

TEST(Inflate, SaysWhatCannotBeInflated) {
  StrokeData open = circle(5).data();
  open.closed = false;
  open.joints.pop_back();
  EXPECT_FALSE(inflated(Stroke::create(open).value()));
  // A figure of eight.
  const auto eight =
      inflated(ring_through({{0, 0}, {10, 10}, {20, 0}, {20, 10}, {10, 0}, {0, 10}}));
  ASSERT_FALSE(eight);
  EXPECT_NE(eight.error().message.find("crosses itself"), std::string::npos);
}

}  // namespace
}  // namespace felt::inflate_test
