#include "felt/tools/width/width_force.h"

#include <gtest/gtest.h>

#include "felt/haptics/testing/feel_rig.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::width_force_test {
namespace {

using testing::Fixture;

Force force_at(const ForceModel& model, const Vec3& position, const Vec3& velocity = {}) {
  ForceMemory memory;
  memory.begin_tick(0.001);
  model(rig::pen_at(position), memory);  // so that the plane knows the position of the pen
  memory.begin_tick(0.001);
  return model(rig::pen_at(position, velocity), memory);
}

WidthFeel at_stop(double harder, double lighter) {
  WidthFeel feel;
  feel.stops = {harder, lighter};
  return feel;
}

TEST(WidthForce, TheStopPushesMoreTheNearerTheLimitAndNeverPullsIn) {
  const Fixture fixture;
  const WidthSettings settings;
  const double neutral = 1e3 * (0.1 + 0.5 * 1.1) / 500.0;  // 1.3 mm on paper
  for (double z = 0.0; z < 6.0; z += 0.05) {
    double last = 500.0 * 1e-3 * z;
    for (const double near : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double push =
          force_at(make_width_force(settings, fixture.scene(), at_stop(near, 0)), {0, 0, -z}).z;
      EXPECT_GE(push, last - 1e-12);
      EXPECT_NEAR(push, 0.5 * z + near * 0.4 * z, 1e-9);
      last = push;
    }
    const double light =
        force_at(make_width_force(settings, fixture.scene(), at_stop(0, 1)), {0, 0, -z}).z;
    EXPECT_NEAR(light, 0.5 * z + 0.4 * std::min(z, neutral), 1e-9);
  }
}

TEST(WidthForce, R56_TheStiffnessStaysWithinTheBudgetAndTheCapOfTheDevice) {
  for (const SurfaceMaterial& surface : surface_materials()) {
    for (const double cap : {0.0, 300.0, 400.0, 700.0, 1000.0, 3000.0}) {
      for (const int delay : {1, 2, 3}) {
        Fixture fixture;
        fixture.surface = surface;
        fixture.device.max_stiffness_n_per_m = cap;
        fixture.device.delay_ticks = delay;
        const ForceModel model = make_width_force({}, fixture.scene(), at_stop(1, 1));
        const double slope = model.slopes().normal_n_per_m;
        EXPECT_LE(slope, stiffness_budget_n_per_m(fixture.device) + 1e-9);
        if (cap > 0.0) {
          EXPECT_LE(slope, 0.9 * cap + 1e-9);
        }
        // The measured slope is at most that of slopes().
        for (double z = 0.0; z < 6.0; z += 0.1) {
          const double rise = force_at(model, {0, 0, -z - 1e-4}).z - force_at(model, {0, 0, -z}).z;
          EXPECT_LE(rise, 1e-3 * slope * 1e-4 + 1e-12);
        }
      }
    }
  }
}

TEST(WidthForce, R12_TheStopIsCalmInEveryHand) {
  for (const int delay : {0, 1, 2}) {
    rig::for_each_grip(0.001, delay, [&](const rig::Setup& setup) {
      SCOPED_TRACE(setup.name());
      Fixture held;
      held.device = setup.capabilities();
      held.surface.id = "smooth";  // without grain, which intentionally has forces above 30 Hz
      held.surface.grain_um = 0.0;
      const double plane = plane_for(held.surface, held.device).stiffness_n_per_m;
      rig::Bench bench(setup, make_width_force({}, held.scene(), at_stop(1, 0)));
      const double down = rig::aim_z_mm(setup.hand, 1.6, plane);
      const auto aim = [&](double t) {
        return Vec3{15.0 * t, 0.0, t < 0.3 ? 2.0 + (down - 2.0) * t / 0.3 : down};
      };
      bench.run(0.6, aim);
      bench.begin_measuring();
      bench.run(1.0, aim);
      EXPECT_LT(bench.figures().hf_n, 0.03);
    });
  }
}

TEST(WidthForce, PressingIntoTheStopAndOutTakesEnergy) {
  for (const rig::Hand& hand : rig::kHands) {
    const rig::Setup setup{hand, rig::kStyluses[0], 0.001, 1};
    SCOPED_TRACE(setup.name());
    Fixture held;
    held.device = setup.capabilities();
    for (const WidthFeel& feel : {at_stop(1, 0), at_stop(0, 1), at_stop(1, 1)}) {
      rig::Bench bench(setup, make_width_force({}, held.scene(), feel), {0, 0, 1});
      bench.run(0.2, [](double) { return Vec3{0, 0, 1}; });
      bench.begin_measuring();
      const double depth = -rig::aim_z_mm(hand, 1.5, 500.0);
      bench.run(5.0, [&](double t) {
        return Vec3{0, 0, 1.0 - (1.0 + depth) * 0.5 * (1.0 - std::cos(6.283185307 * (t - 0.2)))};
      });
      EXPECT_LE(bench.figures().energy_mj, 1.0);
    }
  }
}

TEST(WidthForce, ScalingPullsBackAlongTheHeightOnly) {
  const Fixture fixture;
  WidthFeel feel;
  feel.origin_y_mm = 20.0;
  const ForceModel model = make_width_force({}, fixture.scene(), feel);
  double last = 0.0;
  for (double dy = 0.0; dy < 60.0; dy += 0.05) {
    const Force up = force_at(model, {3, 20 - dy, 5}), down = force_at(model, {-9, 20 + dy, 5});
    EXPECT_EQ(up.x, 0.0);
    EXPECT_NEAR(up.y, -down.y, 1e-12);
    if (dy == 0.0) {
      EXPECT_EQ(up.y, 0.0);
    } else {
      EXPECT_GT(up.y, last);
    }
    EXPECT_LT(up.y, 1.0);
    EXPECT_LE(up.y - last, 0.3 * 0.05 + 1e-12);
    last = up.y;
  }
  EXPECT_LE(model.slopes().lateral_n_per_m, 300.0);
}

TEST(WidthForce, StrengthScalesWhatTheToolAdds) {
  const Fixture fixture;
  WidthSettings none;
  none.strength = 0.0;
  WidthFeel feel = at_stop(1, 1);
  EXPECT_EQ(force_at(make_width_force(none, fixture.scene(), feel), {0, 0, -4}),
            (Force{0, 0, 2.0}));
  feel.origin_y_mm = 20.0;
  EXPECT_EQ(force_at(make_width_force(none, fixture.scene(), feel), {0, 0, -4}),
            (Force{0, 0, 2.0}));
}

TEST(WidthForce, TheFeelStaysTheSameWhileTheStopComes) {
  const Fixture fixture;
  const auto id = [&](const WidthFeel& feel) {
    return make_width_force({}, fixture.scene(), feel).fade_id();
  };
  EXPECT_EQ(id(at_stop(0, 0)), id(at_stop(0.4, 0.7)));
  WidthFeel scale;
  scale.origin_y_mm = 1.0;
  EXPECT_NE(id(at_stop(0, 0)), id(scale));
}

TEST(WidthStop, R13_R46_IsFeltOnPaperOnEveryDevice) {
  const SurfaceMaterial& paper = surface_materials().front();
  // The 3D Systems Touch and the Novint Falcon leave the least stiffness for a stop.
  Capabilities touch, falcon;
  touch.max_stiffness_n_per_m = 400.0;
  touch.position_step_mm = 0.055;
  falcon.position_step_mm = 0.06;
  Capabilities slow;
  slow.period_ns = 4'000'000;
  for (const Capabilities& device : {touch, falcon, slow, Capabilities{}}) {
    EXPECT_GT(width_stop_stiffness(paper, device), 45.0);
  }
}

}  // namespace
}  // namespace felt::width_force_test
