#include "felt/haptics/bricks/snap_well.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>
#include <vector>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/force_model.h"
#include "felt/haptics/testing/feel_rig.h"

namespace felt::snap_well_test {
namespace {

Force pull(const SnapWells& wells, Point pen) {
  ForceMemory memory;
  return wells(rig::pen_at({pen.x, pen.y, -1}), memory);
}

TEST(Well, R43_IsZeroAtBothEndsAndContinuous) {
  const WellShape shape;
  EXPECT_EQ(shape.force_at_n(0.0), 0.0);
  EXPECT_EQ(shape.force_at_n(8.0), 0.0);
  EXPECT_EQ(shape.force_at_n(800.0), 0.0);
  EXPECT_DOUBLE_EQ(shape.force_at_n(1.0), 0.3);
  EXPECT_DOUBLE_EQ(shape.force_at_n(4.0), 0.6);
  EXPECT_DOUBLE_EQ(shape.force_at_n(7.0), 0.3);  // the middle of the rim
  double last = 0.0;
  for (double d = 0.0; d < 9.0; d += 1e-4) {
    const double force = shape.force_at_n(d);
    ASSERT_GE(force, 0.0);
    ASSERT_LE(force, 0.6);
    // The slope is 300 N/m in the core, and at most 1.5 Fp/w = 450 N/m in the rim.
    ASSERT_LE(std::abs(force - last), 0.45e-4 * 1.0001) << d;
    last = force;
  }
}

TEST(Well, PrintedIsEquation11) {
  const WellShape shape = WellShape{}.printed(0.5);
  double energy = 0.0;
  for (double d = 5e-4; d < 9.0; d += 1e-3) {
    const double force = shape.force_at_n(d);
    EXPECT_DOUBLE_EQ(force, d < 8.0 ? 0.5 * (0.2 + 0.8 * d / (d + 10.0)) : 0.0) << d;
    energy += 1e-3 * force;
    EXPECT_NEAR(shape.potential_mj(d + 5e-4), energy, 1e-6);
  }
  EXPECT_EQ(shape.softened(0.3).force_at_n(1.0), shape.force_at_n(1.0));
  EXPECT_NEAR(pull(SnapWells({1, 2}, shape), {1, 5}).y, -shape.force_at_n(3.0), 1e-12);
  EXPECT_EQ(SnapWells({1, 2}, shape).slopes(), Slopes{});
  EXPECT_EQ(WellShape{.force_n = 0.0}.printed(1.0).force_at_n(3.0), 0.0) << "stays switched off";
}

TEST(Well, R43_PullsTowardsTheTarget) {
  const Point target{10, 20};
  const SnapWells wells(target);
  EXPECT_EQ(norm(pull(wells, target)), 0.0);
  for (int i = 0; i < 24; ++i) {
    const Vec away{std::cos(kTau * i / 24), std::sin(kTau * i / 24)};
    for (const double d : {0.5, 3.0, 7.5}) {
      const Force force = pull(wells, target + d * away);
      EXPECT_NEAR(force.x, -WellShape{}.force_at_n(d) * away.x, 1e-12);
      EXPECT_NEAR(force.y, -WellShape{}.force_at_n(d) * away.y, 1e-12);
      EXPECT_EQ(force.z, 0.0);
    }
  }
}

TEST(Well, R43_ThePotentialIsTheIntegralAndBounded) {
  for (const WellShape& shape :
       {WellShape{}, WellShape{.radius_mm = 5, .core_mm = 4, .rim_mm = 3, .force_n = 0.4},
        WellShape{.radius_mm = 3, .core_mm = 5, .rim_mm = 1},
        WellShape{.radius_mm = 6, .core_mm = 1, .rim_mm = 0}}) {
    double integral = 0.0;
    constexpr double kStep = 0.001;
    for (int i = 1; i <= 10'000; ++i) {
      integral += kStep * shape.force_at_n((i - 0.5) * kStep);
      if (i % 250 == 0) {
        ASSERT_NEAR(shape.potential_mj(i * kStep), integral, 1e-5) << i;
      }
    }
  }
  EXPECT_NEAR(WellShape{}.potential_mj(100.0), 3.6, 1e-12);  // docs/design/forces.md#snap-well
}

TEST(Well, NoReachIsNoForce) {
  const WellShape none{.radius_mm = 0.0};
  EXPECT_EQ(norm(pull(SnapWells(Point{0, 0}, none), {0, 0})), 0.0);
  EXPECT_EQ(norm(pull(SnapWells(Point{0, 0}, none), {1, 0})), 0.0);
  EXPECT_EQ(norm(pull(SnapWells(), {0, 0})), 0.0);
  EXPECT_EQ(SnapWells().slopes(), Slopes{});
}

RC_GTEST_PROP(SnapWells, R43_SeveralAreContinuousPassiveAndAsStiffAsTheySay, ()) {
  std::vector<Point> targets;
  for (int i = *rc::gen::inRange(1, 7); i > 0; --i) {
    targets.push_back({0.1 * *rc::gen::inRange(0, 200), 0.1 * *rc::gen::inRange(0, 200)});
  }
  const SnapWells wells(targets);
  const double stiffest = 1e-3 * (wells.slopes().lateral_n_per_m + 450.0 * 4);
  const double back = 1e-3 * wells.slopes().lateral_n_per_m;
  double energy = 0.0;
  double largest = 0.0;
  constexpr double kStep = 1e-3;
  const double turn = 0.01 * *rc::gen::inRange(0, 628);
  const Vec way{kStep * std::cos(turn), kStep * std::sin(turn)};
  // Moving back and forth on the same path yields no energy, except for rounding.
  const Point start{0.1 * *rc::gen::inRange(0, 200), 0.1 * *rc::gen::inRange(0, 200)};
  for (int i = 0; i < 2000; ++i) {
    const Force a = pull(wells, start + (i * 1.0) * way);
    const Force b = pull(wells, start + (i + 1.0) * way);
    RC_ASSERT(norm(b - a) <= stiffest * kStep);
    // Along the path the well never pulls back harder than its slopes allow.
    RC_ASSERT(dot(b - a, {way.x, way.y, 0}) >= -back * kStep * kStep * (1 + 1e-6));
    energy += 0.5 * work_mj(a + b, {way.x, way.y, 0});
    largest = std::max(largest, norm(b));
  }
  double potential = 0.0;
  const Point end = start + 2000.0 * way;
  const std::size_t count = std::min(targets.size(), SnapWells::kMax);
  for (std::size_t i = 0; i < count; ++i) {
    potential += WellShape{}.potential_mj(distance(start, targets[i])) -
                 WellShape{}.potential_mj(distance(end, targets[i]));
  }
  RC_ASSERT(std::abs(energy - potential) < 1e-4);
  RC_ASSERT(largest <= 0.6 * static_cast<double>(count) + 1e-12);
}

TEST(SnapWells, R43_R56_ASmallerShareOfTheBudgetWidensTheCoreOfOneWell) {
  const WellShape shape;
  const auto pulls_n = [](const WellShape& given, double mm, double share) {
    ForceMemory memory;
    memory.scale.lateral = share;
    return -SnapWells(Point{0, 0}, given)(rig::pen_at({mm, 0, -1}), memory).x;
  };
  for (const double share : {1.0, 0.75, 0.6}) {
    const double core_mm = shape.core_mm / (share * share);
    for (double mm = 0.01; mm < 9.0; mm += 0.03) {
      const double level_n = mm < shape.core_mm ? shape.force_n : shape.force_at_n(mm);
      EXPECT_NEAR(pulls_n(shape, mm, share), level_n * std::min(1.0, mm / core_mm), 1e-12);
    }
  }
  // If the core cannot be wider, the force is reduced, and the slope still keeps to the share.
  for (const double share : {0.5, 0.1, 0.0}) {
    const double slope = 1e-3 * share * share * shape.core_slope_n_per_m();
    for (double mm = 0.01; mm < 6.0; mm += 0.03) {
      EXPECT_NEAR(pulls_n(shape, mm, share), slope * mm, 1e-12);
    }
    EXPECT_EQ(pulls_n(shape, 8.0, share), 0.0);
  }
  const WellShape none{.radius_mm = 0.0};
  EXPECT_EQ(pulls_n(none, 1.0, 0.5), 0.0);
}

TEST(SnapWells, TheDampingFadesWithTheRim) {
  ForceMemory memory;
  const SnapWells wells(Point{0, 0});
  const auto damped = [&](double d) {
    return wells(rig::pen_at({d, 0, -1}, {0, 106, 0}), memory).y;
  };
  EXPECT_NEAR(damped(1.0), -0.1, 1e-12);  // 1 N s/m on 106 - 6 mm/s
  EXPECT_NEAR(damped(7.0), -0.05, 1e-12);
  EXPECT_EQ(damped(8.0), 0.0);
}

TEST(SnapWells, R43_AreCalmOnTheSurface) {
  double worst = 0.0;
  for (const double period_s : {0.0002, 0.001}) {
    for (int delay = 0; delay <= 2; ++delay) {
      rig::for_each_grip(period_s, delay, [&](const rig::Setup& setup) {
        for (const double mm : {0.0, 12.0}) {
          const auto model =
              Compose(make_surface_force(surface_materials()[0], media()[0], setup.capabilities()),
                      SnapWells(Point{1, 1}));
          rig::Bench bench(setup, ForceModel(model), {0, 0, 1});
          const double aim = rig::aim_z_mm(setup.hand, 1.0, 500.0);
          const auto target = [&](double time) -> Vec3 {
            const double x = std::min(time / 0.4, 1.0);
            const double t = std::max(0.0, time - 0.7);
            return {mm * std::sin(kTau * t), 0.4 * mm * std::sin(1.5 * kTau * t),
                    1 + (aim - 1) * x * x * (3 - 2 * x)};
          };
          bench.run(0.8, target);
          bench.begin_measuring();
          bench.run(1.0, target);
          const rig::Figures figures = bench.figures();
          EXPECT_LT(figures.hf_n, 0.03) << setup.name() << ", " << mm << " mm";
          worst = std::max(worst, figures.hf_n);
          if (mm == 0.0) {
            EXPECT_LT(figures.energy_mj, 0.3) << setup.name();  // at rest it gains no energy
          }
        }
      });
    }
  }
  RecordProperty("worst_hf_n", std::to_string(worst));
}

}  // namespace
}  // namespace felt::snap_well_test
