#include "felt/tools/connect/connect_force.h"

#include <gtest/gtest.h>

#include <cmath>

#include "felt/haptics/safety/safety_chain.h"
#include "felt/haptics/safety/safety_limits.h"
#include "felt/haptics/testing/feel_rig.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::connect_force_test {
namespace {

using testing::Fixture;
using testing::RandomStroke;

ConnectFeel well_at(Point p) {
  return {.well = p, .dragged_from = {}};
}
ConnectFeel dragged_from(Point p) {
  return {.well = {}, .dragged_from = p};
}

/// Returns the force on a hovering pen, on which surface and friction have no effect.
Force force_at(const ForceModel& model, Point pen) {
  ForceMemory memory;
  memory.begin_tick(0.001);
  return model(rig::pen_at({pen.x, pen.y, 1.0}), memory);
}

ConnectSettings random_settings(RandomStroke& random) {
  ConnectSettings s;
  s.snap.reach_mm = random.uniform(1, 40);
  s.snap.force_n = random.uniform(0, 0.8);
  s.strength = random.uniform(0, 1);
  return s;
}

TEST(ConnectForce, R43_ZeroAtTheTargetAndFromTheReachOnTowardsItBetween) {
  Fixture fixture;
  const ConnectSettings settings;
  const ForceModel model = make_connect_force(settings, fixture.scene(), well_at({10, 10}));
  EXPECT_EQ(norm(force_at(model, {10, 10})), 0.0);
  double last = 0.0;
  for (double d = 0.01; d < 12.0; d += 0.01) {
    const Force f = force_at(model, {10 + 0.6 * d, 10 + 0.8 * d});
    EXPECT_NEAR(f.x * 0.8 - f.y * 0.6, 0.0, 1e-12);
    const double towards = -(f.x * 0.6 + f.y * 0.8);
    if (d < 7.995) {
      EXPECT_GT(towards, 0.0) << d;
    } else {
      EXPECT_NEAR(towards, 0.0, 1e-6) << d;
    }
    EXPECT_NEAR(towards, last, 0.0061) << d;  // continuous: at most 0.6 N/mm, in steps of 0.01 mm
    last = towards;
    if (d > 2.6 && d < 5.9) {
      EXPECT_NEAR(towards, 0.6, 1e-12);
    }
  }
}

TEST(ConnectForce, ADraggedEndHoldsBackALittle) {
  Fixture fixture;
  const ForceModel model = make_connect_force({}, fixture.scene(), dragged_from({10, 10}));
  EXPECT_EQ(norm(force_at(model, {10, 10})), 0.0);
  double last = 0.0;
  for (double d = 0.1; d < 200; d *= 1.1) {
    const Force f = force_at(model, {10 + d, 10});
    EXPECT_LT(f.x, -last);
    EXPECT_GT(f.x, -0.2);
    last = -f.x;
  }
  EXPECT_GT(last, 0.19);
}

TEST(ConnectForce, NeverMoreThanOneNewtonNorSteeperThanThreeHundred) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    RandomStroke random(seed);
    Fixture fixture;
    const ConnectSettings settings = random_settings(random);
    const Point well{random.uniform(-20, 20), random.uniform(-20, 20)};
    const ForceModel model =
        make_connect_force(settings, fixture.scene(), {.well = well, .dragged_from = Point{0, 0}});
    EXPECT_LE(model.slopes().lateral_n_per_m, 300.0 + 1e-9) << seed;
    for (int k = 0; k < 200; ++k) {
      const Point pen{random.uniform(-60, 60), random.uniform(-60, 60)};
      EXPECT_LE(norm(force_at(model, pen)), 1.0 * settings.strength + 1e-12) << seed;
    }
    // Near the target the force is steepest. The pull back grows by at most 0.3 N/mm.
    for (int k = 0; k < 200; ++k) {
      const Point a = well + Vec{random.uniform(-1, 1), random.uniform(-1, 1)};
      const Vec step{random.uniform(-1e-3, 1e-3), random.uniform(-1e-3, 1e-3)};
      const Force d = force_at(model, a + step) - force_at(model, a);
      EXPECT_GE(dot(Vec{d.x, d.y}, step), -0.3001 * dot(step, step)) << seed;
    }
  }
}

TEST(ConnectForce, StrengthScalesAllButTheSurface) {
  Fixture fixture;
  ConnectSettings settings;
  settings.strength = 0.0;
  const ForceModel model = make_connect_force(settings, fixture.scene(),
                                              {.well = Point{3, 0}, .dragged_from = Point{0, 0}});
  EXPECT_EQ(norm(force_at(model, {5, 1})), 0.0);
  ForceMemory memory;
  memory.begin_tick(0.001);
  EXPECT_GT(model(rig::pen_at({5, 1, -1}), memory).z, 0.4);
}

TEST(ConnectForce, TheSameFeelHasTheSameIdAndAnotherTargetAnother) {
  Fixture fixture;
  const auto id = [&](const ConnectFeel& feel) {
    return make_connect_force({}, fixture.scene(), feel).fade_id();
  };
  const ConnectFeel none, well = well_at({1, 2}), other = well_at({1, 3}),
                          drag = dragged_from({1, 2});
  EXPECT_EQ(id(well), id(well));
  EXPECT_NE(id(well), id(other));
  EXPECT_NE(id(well), id(none));
  EXPECT_NE(id(well), id(drag));
  EXPECT_NE(id(drag), id(none));
}

TEST(ConnectForce, R43_CalmWhileAHandLeadsAnEndOntoAnother) {
  double worst = 0.0;
  for (const double period_s : {0.0002, 0.001}) {
    for (int delay = 0; delay <= 2; ++delay) {
      rig::for_each_grip(period_s, delay, [&](const rig::Setup& setup) {
        Fixture fixture;
        fixture.device = setup.capabilities();
        const ForceModel model = make_connect_force(
            {}, fixture.scene(), {.well = Point{12, 0}, .dragged_from = Point{0, 0}});
        rig::Bench bench(setup, model, {0, 0, 1});
        bench.memory().scale = SafetyChain(limits_for(setup.capabilities())).budget(model.slopes());
        const double aim = rig::aim_z_mm(setup.hand, 1.0, 500.0);
        // Lands, drags the end 12 mm in 0.6 s, and rests in the well.
        const auto smooth = [](double x) {
          const double y = std::clamp(x, 0.0, 1.0);
          return y * y * (3 - 2 * y);
        };
        const auto target = [&](double t) -> Vec3 {
          return {12 * smooth((t - 0.8) / 0.6), 0, 1 + (aim - 1) * smooth(t / 0.4)};
        };
        bench.run(0.7, target);
        bench.begin_measuring();
        bench.run(1.2, target);
        worst = std::max(worst, bench.figures().hf_n);
        EXPECT_LT(bench.figures().hf_n, 0.03) << setup.name();
        EXPECT_LT(bench.figures().max_size_n, 2.5) << setup.name();
      });
    }
  }
  RecordProperty("worst_hf_n", std::to_string(worst));
}

}  // namespace
}  // namespace felt::connect_force_test
