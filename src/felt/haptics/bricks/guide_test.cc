#include "felt/haptics/bricks/guide.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/force_model.h"
#include "felt/haptics/testing/feel_rig.h"

namespace felt::guide_test {
namespace {

/// Returns the piece of a path with `turn(i)` radians between steps i and i + 1. The pen is in the
/// middle, at the origin.
template <class Turn>
GuidePiece piece_with(const Turn& turn) {
  GuidePiece piece;
  piece.count = GuidePiece::kPoints;
  piece.hold = 1;
  const std::size_t middle = piece.count / 2;
  piece.at_mm = static_cast<double>(middle) * piece.spacing_mm;
  double angle = 0.0;
  for (std::size_t i = middle; i + 1 < piece.count; ++i) {
    const Vec step{std::cos(angle), std::sin(angle)};
    piece.points[i + 1] = piece.points[i] + piece.spacing_mm * step;
    angle += turn(i);
  }
  angle = 0.0;
  for (std::size_t i = middle; i > 0; --i) {
    const Vec step{std::cos(angle), std::sin(angle)};
    piece.points[i - 1] = piece.points[i] - piece.spacing_mm * step;
    angle -= turn(i);
  }
  return piece;
}

GuidePiece straight() {
  return piece_with([](std::size_t) { return 0.0; });
}

/// Returns a path of lines, arcs and corners.
GuidePiece random_piece() {
  std::vector<double> turns;
  double bend = 0.0;
  while (turns.size() < GuidePiece::kPoints) {
    const int kind = *rc::gen::inRange(0, 12);
    if (kind < 3) bend = 0.01 * *rc::gen::inRange(-25, 26);
    turns.push_back(kind == 11 ? 0.01 * *rc::gen::inRange(-250, 251) : bend);
  }
  return piece_with([&](std::size_t i) { return turns[i]; });
}

/// Returns a memory in which a guide has held the pen for a while.
ForceMemory held() {
  ForceMemory memory;
  memory.guide = {.number = 1, .is_held = true, .share = 1.0};
  return memory;
}

Force force_at(const Guide& guide, Point pen, const Vec3& velocity = {}) {
  ForceMemory memory = held();
  return guide(rig::pen_at({pen.x, pen.y, -1.0}, velocity), memory);
}

TEST(GuideLaw, IsWithinItsBounds) {
  const GuideLaw groove = GuideLaw::groove(1.0);
  EXPECT_NEAR(groove.well.core_slope_n_per_m(), 300.0, 1e-9);
  EXPECT_EQ(groove.well.force_n, 0.8);
  EXPECT_EQ(groove.well.force_at_n(5.0), 0.0);
  EXPECT_EQ(GuideLaw::error_amplifying(1.0).well.force_n, 0.2);
  EXPECT_EQ(GuideLaw::groove(0.5).well.force_n, 0.4);
  EXPECT_LT(GuideLaw::error_amplifying(1.0).potential_mj(9.0), -0.5);
  EXPECT_NEAR(groove.potential_mj(9.0), 0.5 * 0.8 * 0.8 / 0.3 + (3.0 - 0.8 / 0.3) * 0.8 + 0.8,
              1e-9);
}

TEST(Guide, ActsOnlyAcrossAStraightPath) {
  for (const GuideLaw& law : {GuideLaw::groove(1.0), GuideLaw::error_amplifying(1.0)}) {
    const Guide guide(law, straight());
    const double sign = law.pushes_away ? 1.0 : -1.0;
    for (double mm = -7.0; mm <= 7.0; mm += 0.13) {
      for (const double along : {-0.25, 0.0, 0.1, 0.2}) {
        const Force force = force_at(guide, {along, mm});
        EXPECT_NEAR(force.x, 0.0, law.pushes_away ? 4e-3 : 1e-5) << mm;
        const double size = law.well.force_at_n(std::fabs(mm));
        EXPECT_NEAR(force.y, std::copysign(size, sign * mm), law.pushes_away ? 0.02 : 1e-5) << mm;
        EXPECT_EQ(force_at(guide, {along, -mm}).y, -force.y);
      }
    }
  }
}

TEST(Guide, TheDeadZoneHasNoForce) {
  GuideLaw law = GuideLaw::groove(1.0);
  law.dead_mm = 1.0;
  const Guide guide(law, straight());
  EXPECT_EQ(force_at(guide, {0.0, 0.9}).y, 0.0);
  EXPECT_NEAR(force_at(guide, {0.0, 2.0}).y, -0.3, 1e-6);
}

TEST(Guide, DampsOnlyAcrossThePath) {
  const Guide guide(GuideLaw::groove(1.0), straight());
  EXPECT_NEAR(force_at(guide, {}, {106.0, 0.0, 0.0}).x, 0.0, 1e-9);
  EXPECT_NEAR(force_at(guide, {}, {0.0, 106.0, 0.0}).y, -0.1, 1e-9);  // 1 N s/m on 106 - 6 mm/s
}

RC_GTEST_PROP(Guide, IsContinuousBoundedAndAsStiffAsItSays, ()) {
  const bool away = *rc::gen::arbitrary<bool>();
  const GuideLaw law = away ? GuideLaw::error_amplifying(1.0) : GuideLaw::groove(1.0);
  const Guide guide(law, random_piece());
  const double stiffest = 1e-3 * guide.slopes().lateral_n_per_m;
  const double angle = 0.01 * *rc::gen::inRange(0, 628);
  constexpr double kStep = 1e-3;
  const Vec step{kStep * std::cos(angle), kStep * std::sin(angle)};
  const Point start{0.1 * *rc::gen::inRange(-80, 81), 0.1 * *rc::gen::inRange(-80, 81)};
  for (int i = 0; i < 3000; ++i) {
    const Force a = force_at(guide, start + (1.0 * i) * step);
    const Force b = force_at(guide, start + (1.0 + i) * step);
    RC_ASSERT(norm(b) <= law.well.force_n + 1e-12);
    // Between two parts of a path the force turns within the blur: at most 0.8 N in 0.05 mm.
    RC_ASSERT(norm(b - a) <= 16.0 * kStep);
    RC_ASSERT(dot(b - a, {step.x, step.y, 0.0}) >= -stiffest * kStep * kStep * 1.001);
  }
}

RC_GTEST_PROP(Guide, AClosedLoopDoesNoWork, ()) {
  const bool away = *rc::gen::arbitrary<bool>();
  const Guide guide(away ? GuideLaw::error_amplifying(1.0) : GuideLaw::groove(1.0), random_piece());
  const double radius = 0.1 * *rc::gen::inRange(2, 40);
  const Point centre{0.1 * *rc::gen::inRange(-30, 31), 0.1 * *rc::gen::inRange(-30, 31)};
  constexpr int kSteps = 8000;
  const auto at = [&](int i) {
    const double angle = kTau * i / kSteps;
    return centre + radius * Vec{std::cos(angle), std::sin(angle)};
  };
  double energy_mj = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const Vec way = at(i + 1) - at(i);
    energy_mj +=
        0.5 * work_mj(force_at(guide, at(i)) + force_at(guide, at(i + 1)), {way.x, way.y, 0.0});
  }
  RC_ASSERT(std::abs(energy_mj) < 0.05);
}

RC_GTEST_PROP(Guide, IsContinuousWhileThePieceSlides, ()) {
  std::vector<double> turns;
  for (int i = 0; i < 60; ++i) turns.push_back(0.01 * *rc::gen::inRange(-40, 41));
  std::vector<Point> path{{0.0, 0.0}};
  double angle = 0.0;
  for (const double turn : turns) {
    path.push_back(path.back() + 0.5 * Vec{std::cos(angle), std::sin(angle)});
    angle += turn;
  }
  const Point pen =
      path[30] + Vec{0.1 * *rc::gen::inRange(-20, 21), 0.1 * *rc::gen::inRange(-20, 21)};
  const auto force = [&](double at_mm) {  // as GuideTrack makes the piece
    GuidePiece piece;
    piece.count = GuidePiece::kPoints;
    piece.hold = 1;
    const auto from = static_cast<std::ptrdiff_t>(std::floor(at_mm / 0.5)) - 20;
    std::copy_n(path.begin() + from, piece.count, piece.points.begin());
    piece.at_mm = at_mm - 0.5 * static_cast<double>(from);
    return force_at(Guide(GuideLaw::groove(1.0), piece), pen);
  };
  for (double at = 11.0; at < 19.0; at += 0.001) {
    RC_ASSERT(norm(force(at + 0.001) - force(at)) < 0.004);
  }
}

TEST(Guide, LeavingTheGuideNeedsNoMoreThanItsForceAndItReturnsFromZero) {
  const Guide guide(GuideLaw::groove(1.0), straight());
  ForceMemory memory;
  memory.dt_s = 0.001;
  const auto pull = [&](double mm, double z) {
    return -guide(rig::pen_at({0.0, mm, z}), memory).y;
  };
  double last = 0.0;
  const auto follow = [&](double mm, double z) {
    const double now = pull(mm, z);
    EXPECT_LE(std::abs(now), 0.8);
    EXPECT_LE(std::abs(now - last), 0.8 * 0.001 / 0.03 + 0.1 * 0.6) << mm;
    last = now;
    return now;
  };
  for (int i = 0; i < 100; ++i) EXPECT_EQ(follow(1.0, 1.0), 0.0);  // above the surface
  for (int i = 0; i < 200; ++i) follow(1.0, -1.0);                 // touches
  EXPECT_NEAR(last, 0.3, 1e-6);
  for (double mm = 1.0; mm <= 10.0; mm += 0.1) follow(mm, -1.0);  // leaves
  EXPECT_EQ(last, 0.0);
  for (double mm = 10.0; mm > 3.05; mm -= 0.1) EXPECT_EQ(follow(mm, -1.0), 0.0);  // comes back
  EXPECT_LT(follow(2.9, -1.0), 0.01);
  for (int i = 0; i < 200; ++i) follow(2.9, -1.0);
  EXPECT_NEAR(last, 0.8, 1e-6);
  for (int i = 0; i < 40; ++i) follow(2.9, 1.0);  // lifts
  EXPECT_EQ(last, 0.0);
}

TEST(Guide, AnotherPieceStartsFromZero) {
  GuidePiece piece = straight();
  ForceMemory memory = held();
  EXPECT_NEAR(Guide(GuideLaw::groove(1.0), piece)(rig::pen_at({0, 1, -1}), memory).y, -0.3, 1e-6);
  ++piece.hold;
  EXPECT_GT(Guide(GuideLaw::groove(1.0), piece)(rig::pen_at({0, 1, -1}), memory).y, -0.01);
}

RC_GTEST_PROP(Guide, AFastPenFeelsNoMoreThanTheBound, ()) {
  const double strength = 0.01 * *rc::gen::inRange(0, 101);
  GuidePiece piece = random_piece();
  piece.speeds_mm_per_s.fill(500.0F);
  const Guide guide(GuideLaw::teacher(strength), piece);
  const Point pen{0.1 * *rc::gen::inRange(-100, 101), 0.1 * *rc::gen::inRange(-100, 101)};
  const Vec3 velocity{1.0 * *rc::gen::inRange(-2000, 2001), 1.0 * *rc::gen::inRange(-2000, 2001),
                      0};
  RC_ASSERT(norm(force_at(guide, pen, velocity)) <= 0.8 * strength + 1e-12);
}

TEST(Guide, ATeacherLeadsButNeverBrakes) {
  GuidePiece piece = straight();
  piece.speeds_mm_per_s.fill(80.0F);
  const Guide guide(GuideLaw::teacher(1.0), piece);
  EXPECT_NEAR(force_at(guide, {}).x, 0.16, 1e-6);  // 2 N s/m on 80 mm/s
  EXPECT_NEAR(force_at(guide, {}, {46.0, 0.0, 0.0}).x, 0.08, 1e-6);
  EXPECT_NEAR(force_at(guide, {}, {300.0, 0.0, 0.0}).x, 0.0, 1e-12);
  EXPECT_NEAR(force_at(guide, {}, {-300.0, 0.0, 0.0}).x, 0.2, 1e-6);
  EXPECT_NEAR(force_at(guide, {0.0, 4.0}).x, 0.08, 1e-4);  // the middle of the rim
  EXPECT_EQ(force_at(guide, {0.0, 5.1}).x, 0.0);
}

TEST(Guide, AnEdgePushesToItsFreeSideOnly) {
  GuideLaw law = GuideLaw::line(1.0);
  law.is_edge = true;
  GuidePiece piece = straight();
  for (const double side : {1.0, -1.0}) {
    piece.free_side = side;
    const Guide guide(law, piece);
    EXPECT_EQ(force_at(guide, {0.0, 0.3 * side}), Force{});
    EXPECT_EQ(force_at(guide, {0.0, 30.0 * side}), Force{});
    EXPECT_NEAR(force_at(guide, {0.0, 0.0}).y, side * 0.15, 1e-6);
    EXPECT_NEAR(force_at(guide, {0.0, -0.5 * side}).y, side * 0.45, 1e-6);
    EXPECT_NEAR(force_at(guide, {0.2, -2.0 * side}).y, side * 0.8, 1e-6);
    EXPECT_EQ(force_at(guide, {0.0, -4.8 * side}), Force{});
    // A pen that comes from the other side is free until it has been on the free side.
    ForceMemory memory;
    EXPECT_EQ(guide(rig::pen_at({0.0, -1.0 * side, -1.0}), memory), Force{});
    for (int i = 0; i < 200; ++i) guide(rig::pen_at({0.0, side, -1.0}), memory);
    EXPECT_NEAR(guide(rig::pen_at({0.0, -0.5 * side, -1.0}), memory).y, side * 0.45, 1e-6);
  }
}

TEST(Guide, APieceOfOnePointPullsFromAllSides) {
  GuidePiece piece;
  piece.points[0] = {1.0, 2.0};
  piece.count = 1;
  piece.hold = 1;
  const Guide guide(GuideLaw::tick(1.0, 2.0), piece);
  for (double angle = 0.0; angle < kTau; angle += 0.1) {
    const Vec out{std::cos(angle), std::sin(angle)};
    const Force force = force_at(guide, Point{1.0, 2.0} + 0.5 * out);
    EXPECT_NEAR(force.x, -0.15 * out.x, 1e-9);
    EXPECT_NEAR(force.y, -0.15 * out.y, 1e-9);
    EXPECT_EQ(force_at(guide, Point{1.0, 2.0} + 2.0 * out), Force{});
  }
  EXPECT_NEAR(force_at(guide, {1.0, 2.0}, {106.0, 0.0, 0.0}).x, -0.1, 1e-9);
  EXPECT_LT(GuideLaw::tick(1.0, 0.5).well.force_n, 0.1) << "small wells are weak";
}

TEST(Guide, ObeysTheStiffnessBudget) {
  const Guide guide(GuideLaw::groove(1.0), straight());
  EXPECT_NEAR(guide.slopes().lateral_n_per_m, 300.0, 1e-9);
  EXPECT_EQ(Guide().slopes(), Slopes{});
  ForceMemory memory = held();
  memory.scale.lateral = 0.5;
  EXPECT_NEAR(guide(rig::pen_at({0, 1, -1}), memory).y, -0.075, 1e-6);
  ASSERT_EQ(memory.terms.size(), 1U);
  EXPECT_STREQ(memory.terms[0].name, "guide");
}

/// Returns the worst figures of a hand that rests beside the path, or moves across it and beyond
/// the capture width (`mm` > 0).
void expect_calm(const Guide& guide, const rig::Setup& setup, double mm, double& worst) {
  const auto model =
      Compose(make_surface_force(surface_materials()[0], media()[0], setup.capabilities()), guide);
  rig::Bench bench(setup, ForceModel(model), {0, 1, 1});
  const double aim = rig::aim_z_mm(setup.hand, 1.0, 500.0);
  const auto target = [&](double time) -> Vec3 {
    const double x = std::min(time / 0.4, 1.0);
    const double t = std::max(0.0, time - 0.7);
    return {0.0, 1.0 + mm * std::sin(kTau * t), 1 + (aim - 1) * x * x * (3 - 2 * x)};
  };
  bench.run(0.8, target);
  bench.begin_measuring();
  bench.run(1.0, target);
  const rig::Figures figures = bench.figures();
  EXPECT_LT(figures.hf_n, 0.03) << setup.name() << ", " << mm << " mm";
  worst = std::max(worst, figures.hf_n);
  if (mm == 0.0 && !guide.law().pushes_away) {
    EXPECT_LT(figures.energy_mj, 0.3) << setup.name();  // at rest it gains no energy
  }
}

TEST(Guide, IsCalmOnTheSurface) {
  double worst = 0.0;
  const GuidePiece arc = piece_with([](std::size_t) { return 0.1; });  // radius 5 mm
  for (const GuideLaw& law :
       {GuideLaw::groove(1.0), GuideLaw::error_amplifying(1.0), GuideLaw::teacher(1.0)}) {
    for (const GuidePiece& piece : {straight(), arc}) {
      const Guide guide(law, piece);
      for (const double period_s : {0.0002, 0.001}) {
        for (const int delay : {0, 2}) {
          rig::for_each_grip(period_s, delay, [&](const rig::Setup& setup) {
            for (const double mm : {0.0, 10.0}) expect_calm(guide, setup, mm, worst);
          });
        }
      }
    }
  }
  RecordProperty("worst_hf_n", std::to_string(worst));
}

}  // namespace
}  // namespace felt::guide_test
