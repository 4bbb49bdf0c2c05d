#include "felt/tools/transform/transform_force.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "felt/haptics/testing/feel_rig.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::transform_force_test {
namespace {

using testing::Fixture;

constexpr TransformKind kKinds[] = {TransformKind::kMove,     TransformKind::kRotate,
                                    TransformKind::kScale,    TransformKind::kStretch,
                                    TransformKind::kStretchX, TransformKind::kStretchY};

std::vector<Point> points_around(int count, double radius) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    points.push_back({radius * std::cos(0.3 + 2.4 * i), radius * std::sin(0.3 + 2.4 * i)});
  }
  return points;
}

/// Returns the tether term of the force, for a pen at rest.
class Hold {
 public:
  Hold(TransformKind kind, Point grab, const std::vector<Point>& anchors, double strength = 1.0)
      : model_(make_transform_force(fixture_.scene(), strength, &hold_)) {
    hold_.kind = kind;
    hold_.grab = grab;
    hold_.anchors = anchors;
    hold_.gesture = 1;
    model_ = make_transform_force(fixture_.scene(), strength, &hold_);
  }
  Vec at(Point pen) {
    ForceMemory memory;
    return at(pen, memory);
  }
  Vec at(Point pen, ForceMemory& memory) {
    memory.begin_tick(0.001);
    model_(rig::pen_at({pen.x, pen.y, -1.0}), memory);
    Vec sum;
    for (const auto& term : memory.terms) {
      if (std::string_view(term.name) == "tether") sum += {term.force.x, term.force.y};
    }
    return sum;
  }
  [[nodiscard]] const ForceModel& model() const { return model_; }

 private:
  Fixture fixture_;
  TransformHold hold_;
  ForceModel model_;
};

TEST(TransformForce, R35_NoAnchorsNoTetherAndTheSurfaceAsItIs) {
  const Fixture fixture;
  for (const TransformKind kind : kKinds) {
    Hold none(kind, {20, 15}, {});
    EXPECT_EQ(none.at({60, 70}), Vec{});
    EXPECT_EQ(none.model().slopes(), make_transform_force(fixture.scene(), 1.0, nullptr).slopes());
    EXPECT_EQ(none.model().fade_id(),
              make_transform_force(fixture.scene(), 1.0, nullptr).fade_id());
  }
}

TEST(TransformForce, R35_GrowsWithTheLinesThatHold) {
  for (const double d : {3.4, 10.0, 40.0}) {
    double last = 0.0;
    for (int n = 1; n <= 64; ++n) {
      Hold hold(TransformKind::kMove, {0, 0}, points_around(n, 30));
      const Vec force = hold.at({0.6 * d, 0.8 * d});
      EXPECT_GT(norm(force), last) << n << " anchors at " << d << " mm";
      EXPECT_LE(norm(force), 1.0);
      EXPECT_NEAR(force.x / norm(force), -0.6, 1e-12);
      last = norm(force);
    }
  }
}

TEST(TransformForce, R35_NothingBeforeAnyMotion) {
  for (const TransformKind kind : kKinds) {
    for (const int n : {1, 4, 64}) {
      EXPECT_EQ(norm(Hold(kind, {20, 15}, points_around(n, 30)).at({20, 15})), 0.0);
    }
  }
}

TEST(TransformForce, R36_RotationIsAcrossTheArmAndGrowsOverTwoTurns) {
  Hold hold(TransformKind::kRotate, {20, 0}, points_around(3, 25));
  ForceMemory memory;
  double last = -1.0;
  for (double turn = 0.0; turn <= 4.0 * std::numbers::pi; turn += 0.02) {
    const Vec arm{20 * std::cos(turn), 20 * std::sin(turn)};
    const Vec force = hold.at(Point{} + arm, memory);
    EXPECT_NEAR(dot(force, normalized(arm)), 0.0, 1e-12);
    EXPECT_LE(dot(force, perp(arm)), 0.0) << "against the turn";
    ASSERT_GT(norm(force), last);
    last = norm(force);
  }
  EXPECT_EQ(Hold(TransformKind::kRotate, {20, 0}, points_around(3, 25)).at({0, 0}), Vec{});
}

TEST(TransformForce, R37_ScalesAndStretchesAreTheSameBothWays) {
  for (const TransformKind kind : {TransformKind::kScale, TransformKind::kStretchX}) {
    Hold hold(kind, {50, 0}, points_around(3, 30));
    for (double s = 1.05; s < 9.0; s *= 1.3) {
      const Vec up = hold.at({50 * s, 0}), down = hold.at({50 / s, 0});
      EXPECT_NEAR(norm(up), norm(down), 1e-12) << s;
      EXPECT_LT(up.x, 0.0);
      EXPECT_GT(down.x, 0.0);
      EXPECT_EQ(up.y, 0.0);
    }
    EXPECT_EQ(hold.at({5000, 0}), hold.at({9000, 0})) << "the factor stands still";
  }
}

TEST(TransformForce, R37_AStretchPullsAlongItsAxesOnly) {
  Hold x(TransformKind::kStretchX, {30, 20}, points_around(4, 30));
  EXPECT_EQ(x.at({30, 90}), Vec{});
  EXPECT_LT(x.at({45, 90}).x, 0.0);
  EXPECT_EQ(x.at({45, 90}).y, 0.0);
  EXPECT_EQ(x.at({-10, 20}), Vec{}) << "through the centre the factor stands still";
  Hold both(TransformKind::kStretch, {30, 20}, points_around(4, 30));
  const Vec force = both.at({45, 10});
  EXPECT_LT(force.x, 0.0);
  EXPECT_GT(force.y, 0.0);
  EXPECT_LE(norm(both.at({4000, 4000})), 1.0);
}

TEST(TransformForce, R38_IsContinuousAndNeverStifferThan300) {
  constexpr double kH = 1e-5;
  for (const TransformKind kind :
       {TransformKind::kMove, TransformKind::kStretch, TransformKind::kStretchX}) {
    for (const int n : {1, 4, 16, 64}) {
      for (const Point grab : {Point{2, 1.5}, Point{12, 3}, Point{40, 60}}) {
        Hold hold(kind, grab, points_around(n, 25));
        EXPECT_LE(hold.model().slopes().lateral_n_per_m, 300.0);
        double steepest = 0.0;
        for (int i = 0; i < 1500; ++i) {
          const double r = 90.0 * (i % 50) * (i % 50) / 2500.0;
          const Point pen =
              (i % 2 ? grab : Point{}) + r * Vec{std::cos(0.61 * i), std::sin(0.61 * i)};
          const Vec way = kH * Vec{std::cos(1.7 * i), std::sin(1.7 * i)};
          steepest = std::max(steepest, norm(hold.at(pen + way) - hold.at(pen)) / kH);
        }
        EXPECT_LE(1e3 * steepest, 300.5) << static_cast<int>(kind) << ", " << n << " anchors";
      }
    }
  }
}

TEST(TransformForce, StrengthScalesItAndZeroLeavesTheSurface) {
  for (const TransformKind kind : kKinds) {
    const Point grab{20, 15}, pen{35, 28};
    const Vec full = Hold(kind, grab, points_around(5, 30)).at(pen);
    const Vec half = Hold(kind, grab, points_around(5, 30), 0.5).at(pen);
    EXPECT_GT(norm(full), 0.1);
    EXPECT_NEAR(norm(half), 0.5 * norm(full), 1e-12);
    EXPECT_EQ(norm(Hold(kind, grab, points_around(5, 30), 0.0).at(pen)), 0.0);
  }
}

TEST(TransformForce, TheSameFeelKeepsItsFadeId) {
  const std::vector<Point> anchors = points_around(3, 20);
  const Hold a(TransformKind::kScale, {20, 15}, anchors),
      b(TransformKind::kScale, {20, 15}, anchors);
  EXPECT_EQ(a.model().fade_id(), b.model().fade_id());
  EXPECT_NE(a.model().fade_id(), Hold(TransformKind::kMove, {20, 15}, anchors).model().fade_id());
}

TEST(TransformForce, R30_TheStretchIsCalmOnEveryGrip) {
  double worst = 0.0;
  for (const int delay : {0, 1}) {
    rig::for_each_grip(0.001, delay, [&](const rig::Setup& setup) {
      const std::vector<Point> anchors = points_around(16, 25);
      Fixture fixture;
      fixture.device = setup.capabilities();
      const TransformHold hold{TransformKind::kStretch, {0, 0}, {25, 20}, anchors, 1};
      const double plane = plane_for(fixture.surface, fixture.device).stiffness_n_per_m;
      const double z = rig::aim_z_mm(setup.hand, 0.8, plane);
      rig::Bench bench(setup, make_transform_force(fixture.scene(), 1.0, &hold), {25, 20, 0});
      const auto target = [&](double t) {
        const double w = t < 0.3 ? 0.0 : 2.0 * (t - 0.3);
        return Vec3{25 + 12 * std::sin(w), 20 + 9 * std::sin(1.7 * w), z};
      };
      bench.run(0.4, target);
      bench.begin_measuring();
      bench.run(1.0, target);
      worst = std::max(worst, bench.figures().hf_n);
    });
  }
  EXPECT_LT(worst, 0.03);
  RecordProperty("worst_hf_n", std::to_string(worst));
}

}  // namespace
}  // namespace felt::transform_force_test
