#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "felt/geometry/polyline.h"
#include "felt/haptics/testing/feel_rig.h"
#include "felt/tools/gather/gather_force.h"
#include "felt/tools/gather/gather_tool.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::gather_test {
namespace {

/// Returns a rough stroke: straight from `a` to `b`, with waves of this height.
Stroke rough(Point a, Point b, double wave_mm, double phase) {
  constexpr int kPieces = 6;
  const auto at = [&](double t) {
    return lerp(a, b, t) + wave_mm * std::sin(7.0 * t + phase) * perp(normalized(b - a));
  };
  StrokeData data;
  data.points.push_back(at(0.0));
  for (int i = 0; i < kPieces; ++i) {
    for (int k = 1; k <= 3; ++k) data.points.push_back(at((i + k / 3.0) / kPieces));
  }
  data.joints.assign(kPieces - 1, JointKind::kCorner);
  data.widths = {{0.0, 0.5}, {static_cast<double>(kPieces), 0.5}};
  return Stroke::create(std::move(data)).value();
}

struct Fixture {
  testing::Fixture fixture;
  GatherTool tool;
  testing::Pen pen{tool, fixture};

  /// Adds four rough strokes along y = 0, from x = 0 to 60.
  std::vector<StrokeId> add_bundle() {
    std::vector<StrokeId> ids;
    for (int i = 0; i < 4; ++i) {
      const double y = 1.2 * (i - 1.5);
      ids.push_back(fixture.add(rough({0.0 + i, y}, {60.0 - i, y}, 0.2, i)));
    }
    return ids;
  }
  void lock_or_hide(bool visible, bool locked) {
    Edit edit{"Layer", {}, {}};
    const Layer& old = fixture.document.layers().front();
    edit.layers.push_back({old.id, LayerState{old.name, old.visible, old.locked},
                           LayerState{old.name, visible, locked}, 0, 0});
    fixture.apply(edit);
  }
  [[nodiscard]] std::size_t count() const { return fixture.document.stroke_count(); }
};

/// Returns the largest distance of the stroke from the line y = 0, where all strokes of the bundle
/// are (x = 3 to 57).
double largest_y(const Stroke& stroke) {
  double largest = 0.0;
  for (const Point p : rough_line(stroke)) {
    if (p.x >= 3.0 && p.x <= 57.0) largest = std::max(largest, std::fabs(p.y));
  }
  return largest;
}

TEST(Gather, ABundleBecomesOneLineInItsMiddle) {
  Fixture f;
  f.add_bundle();
  f.pen.line(testing::way({-2, 0.3}, {62, 0.3}));
  ASSERT_EQ(f.count(), 1U);
  EXPECT_EQ(f.pen.commits, 1);
  const Stroke& line = *f.fixture.strokes().front();
  EXPECT_LT(largest_y(line), 0.36) << "a tenth of the width of the strip";
  EXPECT_NEAR(line.position(0.0).x, 0.0, 2.0);
  EXPECT_NEAR(line.position(line.segment_count()).x, 60.0, 2.0);
  EXPECT_DOUBLE_EQ(line.width_mm(0.0), 0.5);
  f.fixture.undo();
  EXPECT_EQ(f.count(), 4U);
}

TEST(Gather, ThePreviewShowsTheLineWhileBrushing) {
  Fixture f;
  f.add_bundle();
  f.pen.up({-2, 0});
  std::size_t removed = 0;
  for (const Point p : testing::way({-2, 0}, {62, 0})) {
    const ToolResult result = f.pen.at({p.x, p.y, -1.0});
    if (!result.preview) continue;
    removed = 0;
    for (const StrokeChange& change : result.preview->changes) removed += change.after ? 0 : 1;
  }
  EXPECT_EQ(removed, 3U);
  EXPECT_EQ(f.count(), 4U) << "nothing changes before the pen is lifted";
}

TEST(Gather, TheStripWidthIsAnOption) {
  Fixture f;
  f.add_bundle();
  ASSERT_TRUE(f.tool.set_option("width", std::string("strip")));
  f.pen.line(testing::way({-2, 0}, {62, 0}));
  ASSERT_EQ(f.count(), 1U);
  EXPECT_NEAR(f.fixture.strokes().front()->width_mm(0.5), 3.6 + 0.5, 0.8);
}

TEST(Gather, LeavesACrossingLineAndANeighbourAlone) {
  Fixture f;
  const StrokeId crossing = f.fixture.add(rough({30, -20}, {30, 20}, 0.2, 0.0));
  const StrokeId slanted = f.fixture.add(rough({10, -20}, {35, 20}, 0.2, 0.0));
  const StrokeId beside = f.fixture.add(rough({0, 9}, {60, 9}, 0.2, 0.0));
  f.add_bundle();
  f.pen.line(testing::way({-2, 0}, {62, 0}));
  EXPECT_EQ(f.count(), 4U);
  for (const StrokeId id : {crossing, slanted, beside}) EXPECT_TRUE(f.fixture.document.find(id));
}

TEST(Gather, OfALongStrokeOnlyTheBrushedPartIsCutOut) {
  Fixture f;
  const StrokeId longer = f.fixture.add(rough({-100, 0.4}, {100, 0.4}, 0.1, 0.0));
  f.fixture.add(rough({-15, -0.6}, {15, -0.6}, 0.1, 1.0));
  f.pen.line(testing::way({-18, 0}, {18, 0}));
  ASSERT_EQ(f.count(), 3U) << "the line, and two remainders";
  const StrokePtr left = f.fixture.document.find(longer);
  ASSERT_TRUE(left);
  EXPECT_EQ(left->position(0.0), (Point{-100, 0.4 + 0.1 * std::sin(0.0)}));
  // The remainders end on the line.
  std::size_t touching = 0;
  const std::vector<StrokePtr> all = f.fixture.strokes();
  for (const StrokePtr& a : all) {
    for (const double u : {0.0, static_cast<double>(a->segment_count())}) {
      for (const StrokePtr& b : all) {
        if (a == b) continue;
        const RoughLine other = rough_line(*b);
        touching += nearest_on_polyline(other, a->position(u)).distance_squared < 1e-6 ? 1 : 0;
      }
    }
  }
  EXPECT_GE(touching, 2U);
}

TEST(Gather, AZigzagWithoutLiftsIsABundle) {
  Fixture f;
  StrokeData data;
  data.points.push_back({0, 0});
  for (int i = 0; i < 3; ++i) {
    const double y = 0.8 * i;
    const Point from{i % 2 == 0 ? 0.0 : 50.0, y}, to{i % 2 == 0 ? 50.0 : 0.0, y + 0.8};
    for (int k = 1; k <= 3; ++k) data.points.push_back(lerp(from, to, k / 3.0));
  }
  data.joints.assign(2, JointKind::kCorner);
  data.widths = {{0.0, 0.5}, {3.0, 0.5}};
  f.fixture.add(Stroke::create(std::move(data)).value());
  f.pen.line(testing::way({-2, 1.2}, {52, 1.2}));
  ASSERT_EQ(f.pen.commits, 1);
  ASSERT_EQ(f.count(), 1U);
  const Stroke& line = *f.fixture.strokes().front();
  EXPECT_LT(polyline_length(rough_line(line)), 60.0) << "one line, not three";
}

TEST(Gather, PiecesThatContinueEachOtherBecomeOneLine) {
  Fixture f;
  f.fixture.add(rough({0, 0}, {30, 0}, 0.1, 0.0));
  f.fixture.add(rough({32, 0.2}, {60, 0.2}, 0.1, 0.0));
  f.pen.line(testing::way({-2, 0}, {62, 0}));
  EXPECT_EQ(f.count(), 1U);
}

TEST(Gather, LeavesASingleLineAndLockedOrHiddenLayersAlone) {
  Fixture single;
  single.fixture.add(rough({0, 0}, {60, 0}, 0.2, 0.0));
  single.pen.line(testing::way({-2, 0}, {62, 0}));
  EXPECT_EQ(single.pen.commits, 0);
  for (const bool visible : {false, true}) {
    Fixture f;
    f.add_bundle();
    f.lock_or_hide(visible, visible);
    f.pen.line(testing::way({-2, 0}, {62, 0}));
    EXPECT_EQ(f.pen.commits, 0);
    EXPECT_EQ(f.count(), 4U);
  }
}

TEST(Gather, CancelKeepsTheBundle) {
  Fixture f;
  f.add_bundle();
  f.pen.up({-2, 0});
  f.pen.along(testing::way({-2, 0}, {62, 0}));
  f.tool.cancel();
  f.pen.up({62, 0});
  EXPECT_EQ(f.pen.commits, 0);
  EXPECT_EQ(f.count(), 4U);
}

TEST(Gather, TheSampleRateDoesNotMatter) {
  std::vector<StrokeData> lines;
  for (const double step_mm : {0.1, 1.7}) {
    Fixture f;
    f.add_bundle();
    f.pen.line(testing::way({-2, 0}, {62, 0}, step_mm));
    ASSERT_EQ(f.count(), 1U);
    lines.push_back(f.fixture.strokes().front()->data());
  }
  EXPECT_EQ(lines[0], lines[1]);
}

/// Returns the largest force that the hand feels along the surface while it brushes once.
double largest_resistance_n(Fixture& f, Point from, Point to) {
  double largest = 0.0;
  ForceMemory memory;
  for (const Point p : testing::way(from, to)) {
    f.pen.down(p);
    PenSample sample = rig::pen_at({p.x, p.y, -1.0}, 100.0 * Vec3{to.x - from.x, 0.0, 0.0});
    memory.begin_tick(1e-3);
    const Force force = f.tool.force(f.fixture.scene())(sample, memory);
    if (std::fabs(p.x - from.x) > 10.0) largest = std::max(largest, std::hypot(force.x, force.y));
  }
  return largest;
}

TEST(Gather, TheBundleResistsUntilItIsOneLine) {
  Fixture single, bundle;
  single.fixture.add(rough({0, 0}, {60, 0}, 0.2, 0.0));
  bundle.add_bundle();
  const double surface_n = largest_resistance_n(single, {0, 0}, {60, 0});
  const double first_n = largest_resistance_n(bundle, {0, 0}, {60, 0});
  EXPECT_GT(first_n, surface_n + 0.1);
  const double again_n = largest_resistance_n(bundle, {60, 0}, {0, 0});
  EXPECT_LT(again_n, surface_n + 0.02) << "it has given way";
  EXPECT_LE(first_n, surface_n + BundleFeel::kMaxN);
}

RC_GTEST_PROP(GatherForce, GrowsWithTheSpreadAndIsLimited, ()) {
  const double normal_n = 0.01 * *rc::gen::inRange(1, 400);
  const double small = 0.01 * *rc::gen::inRange(0, 300);
  const double more = small + 0.01 * *rc::gen::inRange(0, 300);
  const auto friction_n = [&](double spread) {
    ForceMemory memory;
    memory.begin_tick(1e-3);
    memory.normal_force_n = normal_n;
    (void)BundleFeel(spread, 0.25, 1.0)(PenSample{}, memory);
    return 0.25 * memory.friction_factor * normal_n;
  };
  const double plain_n = 0.25 * normal_n;
  RC_ASSERT(friction_n(0.0) == plain_n);
  RC_ASSERT(friction_n(small) <= friction_n(more));
  RC_ASSERT(friction_n(more) <= plain_n + BundleFeel::kMaxN + 1e-12);
}

/// The force may give back what the bristle of the friction has stored, and never more: over every
/// movement it takes energy from the hand, however the spread changes.
RC_GTEST_PROP(GatherForce, NeverPushes, ()) {
  const auto spreads = *rc::gen::container<std::vector<int>>(20, rc::gen::inRange(0, 300));
  const double speed_mm_per_s = *rc::gen::inRange(5, 200);
  const double hz = *rc::gen::inRange(1, 6);
  testing::Fixture fixture;
  fixture.surface.grain_um = 0.0;
  rig::Setup setup;
  setup.step_mm = 0.0;
  rig::Bench bench(setup, make_gather_force(fixture.scene(), 0.0, 1.0), {0.0, 0.0, -1.0});
  const double depth_mm = rig::aim_z_mm(setup.hand, 1.0, fixture.surface.stiffness_n_per_m);
  const double reach_mm = speed_mm_per_s / (2.0 * std::numbers::pi * hz);
  const auto hand = [&](double t) {
    return Vec3{reach_mm * std::sin(2.0 * std::numbers::pi * hz * t), 0.0, depth_mm};
  };
  bench.run(0.5, hand);
  bench.begin_measuring();
  for (const int spread : spreads) {
    bench.set_model(make_gather_force(fixture.scene(), 0.01 * spread, 1.0));
    bench.run(0.05, hand);
  }
  RC_ASSERT(bench.figures().energy_mj <= 0.05);
}

/// The trials "rest" and "slow" of docs/stability.md, with the largest resistance.
TEST(GatherForce, IsCalmInEveryHand) {
  testing::Fixture fixture;
  fixture.surface.grain_um = 0.0;
  rig::for_each_grip(0.001, 1, [&](const rig::Setup& setup) {
    fixture.device = setup.capabilities();
    const double plane = plane_for(fixture.surface, fixture.device).stiffness_n_per_m;
    const double depth_mm = rig::aim_z_mm(setup.hand, 0.8, plane);
    for (const double speed_mm_per_s : {0.0, 20.0}) {
      rig::Bench bench(setup, make_gather_force(fixture.scene(), 3.0, 1.0), {0.0, 0.0, 0.0});
      const auto hand = [&](double t) { return Vec3{speed_mm_per_s * t, 0.0, depth_mm}; };
      bench.run(1.0, hand);
      bench.begin_measuring();
      bench.run(1.0, hand);
      EXPECT_LT(bench.figures().hf_n, 0.03) << setup.name() << ", " << speed_mm_per_s << " mm/s";
      EXPECT_LE(bench.figures().energy_mj, 0.05) << setup.name();
    }
  });
}

}  // namespace
}  // namespace felt::gather_test
