#include "felt/solid/inflate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>

#include "felt/geometry/nearest.h"
#include "felt/geometry/polyline.h"
#include "felt/solid/testing/solid_drawings.h"
#include "felt/solid/testing/surface.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::inflate_test {
namespace {

using testing::examine;
using testing::smooth_ring;
using testing::SolidDrawing;
using testing::stroke_of;
using testing::SurfaceReport;

/// Half of the thickness of a body above a point of its frame: the height of the front there.
double height_at(const SolidBody& body, Point p) {
  double best = -1.0;
  for (const auto& [a, b, c] : body.triangles) {
    const Vec3 &u = body.points[a], &v = body.points[b], &w = body.points[c];
    const double area = cross(on_page(v) - on_page(u), on_page(w) - on_page(u));
    if (!(area > 0.0)) continue;  // of the back
    const double s = cross(on_page(w) - on_page(v), p - on_page(v)) / area;
    const double t = cross(on_page(u) - on_page(w), p - on_page(w)) / area;
    if (s < -1e-9 || t < -1e-9 || s + t > 1.0 + 1e-9) continue;
    best = std::max(best, s * u.z + t * v.z + (1.0 - s - t) * w.z);
  }
  return best;
}

void expect_sound(const SolidBody& body) {
  const SurfaceReport report = examine(testing::surface_of(body));
  EXPECT_EQ(report.fault, "");
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.euler, 2 - 2 * body.holes);
  EXPECT_GT(report.volume_mm3, 0.0);
  EXPECT_EQ(examine(testing::welded(testing::surface_of(body))).fault, "");
}

InflatedDrawing inflated(const SolidDrawing& drawing, const InflateOptions& options = {}) {
  Result<InflatedDrawing> result = inflate(drawing.document, options);
  EXPECT_TRUE(result) << result.error().message;
  if (!result) return {};
  for (const SolidBody& body : result->solid.bodies) expect_sound(body);
  return *std::move(result);
}

std::string error_of(const SolidDrawing& drawing, const InflateOptions& options = {}) {
  const Result<InflatedDrawing> result = inflate(drawing.document, options);
  return result ? "" : result.error().message;
}

/// A random outline, and the number of holes that its body has.
struct RandomOutline {
  SolidDrawing drawing;
  int holes = 0;
};

void add_union(SolidDrawing& drawing, Random& random, Point at, double size_mm) {
  double last = size_mm * random.between(0.7, 1.0);
  const int count = 2 + static_cast<int>(random.between(0.0, 5.0));
  for (int i = 0; i < count; ++i) {
    drawing.circle(at, last);
    const double next = size_mm * random.between(0.7, 1.0);
    const double angle = random.between(0.0, 2.0 * std::numbers::pi);
    at += random.between(0.5, 0.9) * (last + next) * Vec{std::cos(angle), std::sin(angle)};
    last = next;
  }
}

void add_star(SolidDrawing& drawing, Random& random, Point at, double size_mm) {
  const int tips = 3 + static_cast<int>(random.between(0.0, 10.0));
  const double inner = random.between(0.15, 0.8);
  std::vector<Point> corners;
  for (int i = 0; i < 2 * tips; ++i) {
    const double a = std::numbers::pi * (i + random.between(0.0, 0.3)) / tips;
    const double r = size_mm * (i % 2 == 0 ? 1.0 : inner);
    corners.push_back(at + Vec{r * std::cos(a), r * std::sin(a)});
  }
  drawing.polygon(std::move(corners));
}

/// A strip along a wave, much longer than wide.
void add_sausage(SolidDrawing& drawing, Random& random, Point at, double size_mm) {
  const double half = 0.5 * random.between(0.05, 0.2), waves = random.between(0.0, 3.0);
  std::vector<Point> there, back;
  for (int i = 0; i <= 60; ++i) {
    const double x = 4.0 * i / 60.0, phase = waves * x;
    const Vec along = normalized(Vec{1.0, 0.3 * waves * std::cos(phase)});
    const Point middle{x, 0.3 * std::sin(phase)};
    there.push_back(middle + half * perp(along));
    back.push_back(middle - half * perp(along));
  }
  there.insert(there.end(), back.rbegin(), back.rend());
  for (Point& p : there) p = at + size_mm * (p - Point{});
  drawing.polygon(std::move(there));
}

void add_holes(RandomOutline& outline, Random& random, Point at, double size_mm) {
  outline.drawing.add(stroke_of(smooth_ring(testing::lumps(random, at, size_mm, 9, 0.85)), true));
  outline.holes = 1 + static_cast<int>(random.between(0.0, 4.0));
  for (int i = 0; i < outline.holes; ++i) {
    const double a = 2.0 * std::numbers::pi * i / outline.holes;
    const Vec away = 0.4 * size_mm * Vec{std::cos(a), std::sin(a)};
    outline.drawing.circle(at + away, size_mm * random.between(0.1, 0.2));
  }
}

/// An outline of several strokes, with a gap that the default closes.
void add_open_ring(SolidDrawing& drawing, Random& random, Point at, double size_mm) {
  const std::vector<Point> ring = smooth_ring(testing::lumps(random, at, size_mm, 12, 0.7));
  drawing.add(stroke_of({ring.begin(), ring.begin() + 19}));
  std::vector<Point> rest(ring.begin() + 18, ring.end());
  const Vec along = normalized(rest[rest.size() - 2] - rest.back());
  rest.back() += std::min(1.2, 0.05 * size_mm) * along;
  drawing.add(stroke_of(std::move(rest)));
}

RandomOutline random_outline(std::uint64_t seed) {
  Random random(seed);
  RandomOutline outline;
  SolidDrawing& drawing = outline.drawing;
  const Point at{random.between(-300.0, 1000.0), random.between(-300.0, 1000.0)};
  const double size = 4.0 * std::pow(50.0, random.between(0.0, 1.0));
  const int lumps = 5 + static_cast<int>(random.between(0.0, 40.0));
  switch (seed % 7) {
    case 0:
      drawing.add(stroke_of(smooth_ring(testing::lumps(random, at, size, lumps, 0.5)), true));
      break;
    case 1:
      drawing.polygon(testing::lumps(random, at, size, lumps, 0.15));
      break;
    case 2:
      add_union(drawing, random, at, size);
      break;
    case 3:
      add_star(drawing, random, at, size);
      break;
    case 4:
      add_sausage(drawing, random, at, std::max(size, 6.0));
      break;
    case 5:
      add_holes(outline, random, at, std::max(size, 8.0));
      break;
    default:
      add_open_ring(drawing, random, at, size);
      break;
  }
  return outline;
}

/// The number of random outlines: 150, or the number in SOLID_OUTLINES.
std::uint64_t outline_count() {
  const char* wanted = std::getenv("SOLID_OUTLINES");
  return wanted ? std::strtoull(wanted, nullptr, 10) : 150;
}

TEST(Inflate, R54_EveryOutlineBecomesOneClosedBody) {
  constexpr int kShownFailures = 10;
  for (std::uint64_t seed = 1; seed <= outline_count(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomOutline outline = random_outline(seed);
    const InflateOptions options{.triangles = 400 + static_cast<int>(seed % 5) * 400};
    const InflatedDrawing result = inflated(outline.drawing, options);
    EXPECT_EQ(result.solid.bodies.size(), 1U);
    for (const SolidBody& body : result.solid.bodies) EXPECT_EQ(body.holes, outline.holes);
    const auto& so_far = *::testing::UnitTest::GetInstance()->current_test_info()->result();
    if (so_far.total_part_count() > 3 * kShownFailures) return;
  }
}

// Scribbles that cross themselves anywhere, several of them, with dots and long lines.
TEST(Inflate, AnyLinesAreRefusedOrGiveClosedBodies) {
  int refused = 0, inflated_count = 0;
  for (std::uint64_t seed = 1; seed <= outline_count(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    testing::RandomStroke random(seed);
    SolidDrawing drawing;
    for (int i = random.pick(1, 8); i > 0; --i) {
      drawing.add(std::make_shared<const Stroke>(Stroke::create(random.make()).value()));
    }
    const Result<InflatedDrawing> result =
        inflate(drawing.document, {.triangles = 300, .max_gap_mm = random.pick(0, 3) * 2.0});
    ++(result ? inflated_count : refused);
    if (!result) {
      EXPECT_FALSE(result.error().message.empty());
    } else {
      for (const SolidBody& body : result->solid.bodies) expect_sound(body);
    }
  }
  EXPECT_GT(inflated_count, 0);
  EXPECT_GT(refused, 0);
}

TEST(Inflate, R54_ADiscBecomesABall) {
  for (const double radius : {5.0, 20.0}) {
    SolidDrawing drawing;
    drawing.circle({50, 40}, radius);
    const InflatedDrawing result = inflated(drawing);
    ASSERT_EQ(result.solid.bodies.size(), 1U);
    const SolidBody& body = result.solid.bodies[0];
    for (const Vec3& p : body.points) {
      EXPECT_NEAR(std::sqrt(norm_squared(p)), radius, 0.01 * radius);
    }
    EXPECT_NEAR(volume_mm3(body), 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3.0),
                0.02 * std::pow(radius, 3.0) * 4.0);
    EXPECT_NEAR(static_cast<double>(body.triangles.size()), 5000.0, 1000.0);
  }
}

TEST(Inflate, R54_WidePartsAreFatAndNarrowOnesThin) {
  // A dumb-bell: two heads 20 mm wide, a neck of 6 mm.
  SolidDrawing drawing;
  drawing.add(stroke_of(
      smooth_ring({{-30, 0}, {-27, -7}, {-20, -10}, {-13, -7}, {-8, -3},  {0, -3},  {8, -3},
                   {13, -7}, {20, -10}, {27, -7},   {30, 0},   {27, 7},   {20, 10}, {13, 7},
                   {8, 3},   {0, 3},    {-8, 3},    {-13, 7},  {-20, 10}, {-27, 7}}),
      true));
  const InflatedDrawing result = inflated(drawing);
  ASSERT_EQ(result.solid.bodies.size(), 1U);
  const SolidBody& body = result.solid.bodies[0];
  EXPECT_GT(height_at(body, {-20, 0}), 2.0 * height_at(body, {0, 0}));
  EXPECT_GT(height_at(body, {0, 0}), 2.0);
}

TEST(Inflate, AStripIsAnEllipse) {
  SolidDrawing drawing;
  drawing.polygon({{0, 0}, {400, 0}, {400, 10}, {0, 10}});
  const InflatedDrawing result = inflated(drawing, {.triangles = 20000});
  ASSERT_EQ(result.solid.bodies.size(), 1U);
  // u = 2 (w^2 - y^2) far from the ends.
  for (const double y : {0.0, 2.0, 4.0}) {
    EXPECT_NEAR(height_at(result.solid.bodies[0], {3.0, y}), std::sqrt(2.0 * (25.0 - y * y)), 0.15);
  }
}

TEST(Inflate, TheThicknessIsAFactor) {
  SolidDrawing drawing;
  drawing.circle({50, 40}, 10.0);
  const InflatedDrawing once = inflated(drawing), half = inflated(drawing, {.thickness = 0.5});
  ASSERT_EQ(once.solid.bodies[0].points.size(), half.solid.bodies[0].points.size());
  EXPECT_NEAR(volume_mm3(half.solid.bodies[0]), 0.5 * volume_mm3(once.solid.bodies[0]), 1e-6);
}

TEST(Inflate, TheBorderFollowsTheOutline) {
  for (std::uint64_t seed = 7; seed <= 140; seed += 7) {
    SCOPED_TRACE(seed);
    const RandomOutline outline = random_outline(seed);  // smooth lumps
    const StrokePtr stroke = outline.drawing.document.find({1});
    const InflatedDrawing result = inflated(outline.drawing);
    const SolidBody& body = result.solid.bodies.at(0);
    const Point origin = result.solid.origin;
    for (std::size_t i = 0; i < body.points.size(); ++i) {
      const Vec3& p = body.points[i];
      EXPECT_EQ(p.z == 0.0, i < body.border_count);
      if (i >= body.border_count) continue;
      double best = 1e300;
      for (int s = 0; s < stroke->segment_count(); ++s) {
        const Point at{origin.x + p.x, origin.y - p.y};
        best = std::min(best, nearest(stroke->segment(s), at).distance_squared);
      }
      EXPECT_LE(std::sqrt(best), 0.05);
    }
  }
}

/// Returns the largest distance of the mirror image of a point of the body, in the vertical line
/// at x, from the surface point of the body above it.
double asymmetry(const SolidBody& body, double x) {
  double worst = 0.0;
  for (std::size_t i = 0; i < body.points.size(); i += 7) {
    const Vec3& p = body.points[i];
    if (!(p.z > 0.0)) continue;
    worst = std::max(worst, std::fabs(height_at(body, {2.0 * x - p.x, p.y}) - p.z));
  }
  return worst;
}

TEST(Inflate, FrontAndBackAreMirrorImages) {
  for (std::uint64_t seed = 1; seed <= 21; ++seed) {
    const InflatedDrawing result = inflated(random_outline(seed).drawing);
    const SolidBody& body = result.solid.bodies.at(0);
    const std::size_t inner = (body.points.size() - body.border_count) / 2;
    ASSERT_EQ(body.border_count + 2 * inner, body.points.size());
    for (std::size_t i = body.border_count; i < body.border_count + inner; ++i) {
      const Vec3 &front = body.points[i], &back = body.points[i + inner];
      EXPECT_EQ(front, (Vec3{back.x, back.y, -back.z}));
    }
  }
}

TEST(Inflate, ASymmetricOutlineBecomesASymmetricBody) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    // The right half at random, the left its mirror image; points on the axis at both ends. Some
    // are polygons, and the start of the curve is anywhere.
    std::vector<Point> at{{0.0, 20.0}};
    for (int k = 1; k < 8; ++k) {
      const double a = std::numbers::pi * (0.5 - k / 8.0), r = random.between(12.0, 30.0);
      at.push_back({r * std::cos(a), r * std::sin(a)});
    }
    at.push_back({0.0, -random.between(15.0, 30.0)});
    for (int k = 7; k >= 1; --k)
      at.push_back({-at[static_cast<std::size_t>(k)].x, at[static_cast<std::size_t>(k)].y});
    std::rotate(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(seed % 16), at.end());
    for (Point& p : at) p += Vec{70.0, 50.0};
    SolidDrawing drawing;
    if (seed % 2 == 0)
      drawing.polygon(at);
    else
      drawing.add(stroke_of(smooth_ring(at), true));
    if (seed % 3 == 0) drawing.circle({70.0, 50.0}, 4.0);
    const InflatedDrawing result = inflated(drawing);
    const double x = 70.0 - result.solid.origin.x;
    EXPECT_LE(asymmetry(result.solid.bodies.at(0), x), 1e-6 * 60.0);
  }
}

TEST(Inflate, AllMirrorAxesOfASquareAndARingCount) {
  for (const bool ring : {false, true}) {
    SolidDrawing drawing;
    if (ring) {
      drawing.circle({50, 50}, 30.0);
      drawing.circle({50, 50}, 12.0);
    } else {
      drawing.polygon({{20, 20}, {80, 20}, {80, 80}, {20, 80}});
    }
    const InflatedDrawing result = inflated(drawing);
    const SolidBody& body = result.solid.bodies.at(0);
    EXPECT_LE(asymmetry(body, 0.0), 6e-5);
    SolidBody turned = body;  // by an eighth of a turn
    const double s = std::sqrt(0.5);
    for (Vec3& p : turned.points) p = {s * (p.x - p.y), s * (p.x + p.y), p.z};
    EXPECT_LE(asymmetry(turned, 0.0), 6e-5);
  }
}

TEST(Inflate, TheSameDrawingGivesTheSameBody) {
  for (std::uint64_t seed = 1; seed <= 7; ++seed) {
    const InflatedDrawing a = inflated(random_outline(seed).drawing);
    const InflatedDrawing b = inflated(random_outline(seed).drawing);
    EXPECT_EQ(a.solid.bodies.at(0).points, b.solid.bodies.at(0).points);
    EXPECT_EQ(a.solid.bodies.at(0).triangles, b.solid.bodies.at(0).triangles);
  }
}

TEST(Inflate, ThinTipsAndSpikesAreCutOff) {
  SolidDrawing needle;
  needle.polygon({{0, 0}, {100, 0.05}, {100, 20}, {0, 20}, {-60, 10}, {0, 19.9}});
  EXPECT_EQ(inflated(needle).solid.bodies.size(), 1U);
  SolidDrawing crescent;  // two arcs that are tangent at their ends
  crescent.add(stroke_of({{0, 0}, {20, 30}, {60, 30}, {80, 0}, {60, 29}, {20, 29}, {0, 0}}, true));
  EXPECT_EQ(inflated(crescent).solid.bodies.size(), 1U);
  SolidDrawing heart;  // a cusp at the top and a tip at the bottom
  heart.add(stroke_of({{50, 60},
                       {50, 20},
                       {0, 20},
                       {0, 50},
                       {0, 80},
                       {50, 90},
                       {50, 120},
                       {50, 90},
                       {100, 80},
                       {100, 50},
                       {100, 20},
                       {50, 20},
                       {50, 60}},
                      true));
  EXPECT_EQ(inflated(heart).solid.bodies.size(), 1U);
}

TEST(Inflate, SaysWhatCannotBeInflated) {
  SolidDrawing eight;
  eight.polygon({{0, 0}, {40, 40}, {40, 0}, {0, 40}});
  EXPECT_EQ(error_of(eight),
            "stroke s1 crosses itself at (20.00, 20.00) mm, so its parts meet in only one point");
  SolidDrawing touching;
  touching.polygon({{0, 0}, {20, 20}, {0, 40}});
  touching.polygon({{20, 20}, {40, 0}, {40, 40}});
  EXPECT_NE(error_of(touching).find("strokes s1 and s2 enclose areas that meet in only one point, "
                                    "(20.00, 20.00) mm"),
            std::string::npos)
      << error_of(touching);
  SolidDrawing four;
  four.polyline({{20, 20}, {0, 0}, {0, 20}});
  four.polyline({{0, 20}, {0, 40}, {20, 20}});
  four.polyline({{20, 20}, {40, 0}, {40, 20}});
  four.polyline({{40, 20}, {40, 40}, {20, 20}});
  EXPECT_EQ(error_of(four).find("strokes s1, s2, s3 and s4 enclose areas that meet in only one "),
            0U)
      << error_of(four);
  SolidDrawing open;
  open.polyline({{0, 0}, {40, 0}, {40, 40}, {0, 40}, {0, 5}});
  EXPECT_EQ(error_of(open),
            "contains no closed outline: there is a gap of 5.00 mm at (0.00, 0.00) mm, at the end "
            "of stroke s1");
  SolidDrawing small;
  small.polygon({{10, 10}, {10.5, 10}, {10.5, 10.5}});
  EXPECT_NE(error_of(small).find("too small"), std::string::npos);
  EXPECT_NE(error_of(small).find("stroke s1 at (10.00, 10.00) mm, 0.50 x 0.50 mm"),
            std::string::npos)
      << error_of(small);
  EXPECT_EQ(error_of(SolidDrawing()), "contains no visible strokes");
}

TEST(Inflate, LeavesOutWhatCannotBeInflatedIfAsked) {
  const InflateOptions lenient{.faults = FaultChoice::kLeaveOut};
  SolidDrawing drawing;
  drawing.circle({150, 50}, 20.0);
  const Solid alone = inflated(drawing).solid;
  drawing.polygon({{0, 0}, {40, 40}, {40, 0}, {10, 30}});  // an eight; its left part is smaller
  ASSERT_NE(error_of(drawing), "");
  const InflatedDrawing result = inflated(drawing, lenient);
  ASSERT_EQ(result.solid.bodies.size(), 2U);
  ASSERT_EQ(result.notes.size(), 1U);
  EXPECT_EQ(
      result.notes[0],
      "left out the smaller part: stroke s2 crosses itself at (20.00, 20.00) mm, so its parts "
      "meet in only one point");
  double volume = 0.0;
  for (const SolidBody& body : result.solid.bodies) {
    EXPECT_TRUE(check_body(body, result.solid.origin));
    if (body.stroke == StrokeId{1}) volume = volume_mm3(body);
    // The larger part has the point (40, 0).
    if (body.stroke == StrokeId{2}) {
      double right = -1e9;
      for (const Vec3& p : body.points) right = std::max(right, p.x + result.solid.origin.x);
      EXPECT_NEAR(right, 40.0, 0.5);
    }
  }
  EXPECT_NEAR(volume, volume_mm3(alone.bodies[0]), 0.05 * volume);
  SolidDrawing open;
  open.polyline({{0, 0}, {40, 0}, {40, 40}});
  EXPECT_NE(error_of(open, lenient), "") << "there is nothing to leave out";
}

TEST(Inflate, RejectsOptionsThatMakeNoSense) {
  SolidDrawing drawing;
  drawing.circle({50, 40}, 10.0);
  const double nan = std::nan("");
  EXPECT_NE(error_of(drawing, {.triangles = 0}), "");
  EXPECT_NE(error_of(drawing, {.max_gap_mm = nan}), "");
  EXPECT_NE(error_of(drawing, {.thickness = nan}), "");
  EXPECT_NE(error_of(drawing, {.thickness = 0.0}), "");
}

TEST(Inflate, FarFromTheOriginItIsTheSame) {
  for (const double far_mm : {1e5, 1e8}) {
    SolidDrawing drawing;
    drawing.circle({far_mm, -far_mm}, 30.0);
    const InflatedDrawing result = inflated(drawing);
    ASSERT_EQ(result.solid.bodies.size(), 1U);
    EXPECT_NEAR(volume_mm3(result.solid.bodies[0]), 113097.0, 2000.0);
  }
  SolidDrawing huge;
  huge.circle({0, 0}, 1e8);
  EXPECT_EQ(inflated(huge).solid.bodies.size(), 1U);
}

TEST(Inflate, PageTrianglesFaceOutwardsInTheFrameOfThePage) {
  SolidDrawing drawing;
  drawing.polygon({{20, 40}, {60, 40}, {60, 80}, {20, 80}});
  const Solid solid = inflated(drawing).solid;
  ASSERT_EQ(solid.bodies.size(), 1U);
  const std::vector<Triangle3> triangles = page_triangles(solid, 5.0);
  double volume = 0.0;
  for (const auto& [a, b, c] : triangles) volume += dot(a, cross(b, c)) / 6.0;
  EXPECT_NEAR(volume, volume_mm3(solid.bodies[0]), 1e-6 * volume);
  const TriangleTree tree(triangles);
  const auto hit = tree.sweep({42, 63, 50}, {42, 63, 0});
  ASSERT_TRUE(hit);
  const double height = height_at(solid.bodies[0], {42 - solid.origin.x, solid.origin.y - 63});
  EXPECT_NEAR(50.0 - 50.0 * hit->t, height - 5.0, 1e-6);
  EXPECT_GT(hit->normal.z, 0.9);
}

}  // namespace
}  // namespace felt::inflate_test
