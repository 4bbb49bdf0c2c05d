#include "felt/haptics/bricks/friction.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/plane.h"
#include "felt/haptics/force_model.h"
#include "felt/haptics/testing/feel_rig.h"

namespace felt::friction_test {
namespace {

/// Returns the force of the bristle alone at the current position of the pen, for a push of
/// `normal_n`.
Force step(const Friction& friction, ForceMemory& memory, Vec3 position, Vec3 velocity,
           double normal_n, double dt_s = 0.001) {
  memory.begin_tick(dt_s);
  memory.normal_force_n = normal_n;
  return friction(rig::pen_at(position, velocity), memory);
}

RC_GTEST_PROP(Friction, R13_NeverExceedsMuFnNorLiftsThePen, ()) {
  const Friction friction({.coefficient = *rc::gen::inRange(0, 100) * 0.01});
  ForceMemory memory;
  for (int i = *rc::gen::inRange(1, 100); i > 0; --i) {
    const double normal_n = std::max(0.0, 0.01 * *rc::gen::inRange(-50, 200));
    const Vec3 position{0.1 * *rc::gen::inRange(-100, 100), 0.1 * *rc::gen::inRange(-100, 100), -1};
    const Vec3 velocity{1.0 * *rc::gen::inRange(-900, 900), 1.0 * *rc::gen::inRange(-900, 900), 0};
    const Force force = step(friction, memory, position, velocity, normal_n);
    RC_ASSERT(norm(force) <= friction.options().coefficient * normal_n * (1.0 + 1e-12));
    RC_ASSERT(force.z == 0.0);
  }
}

RC_GTEST_PROP(Friction, R68_WhatTheDeviceHasByItselfIsNotRenderedAgain, ()) {
  const double mu = *rc::gen::inRange(0, 100) * 0.01, own_n = *rc::gen::inRange(0, 50) * 0.01;
  const double normal_n = *rc::gen::inRange(1, 200) * 0.01;
  const double factor = *rc::gen::inRange(0, 180) * 0.01, grain = *rc::gen::inRange(0, 100) * 0.01;
  const double reference = *rc::gen::inRange(0, 60) * 0.01;
  const Friction friction(
      {.coefficient = mu, .own_friction_n = own_n, .own_coefficient = reference});
  ForceMemory memory;
  Force force;
  for (double mm = 0.0; mm < 8.0; mm += 0.05) {
    memory.begin_tick(0.001);
    memory.normal_force_n = normal_n;
    memory.friction_factor = factor;
    memory.friction_grain = grain;
    force = friction(rig::pen_at({mm, 0, -1}, {50, 0, 0}), memory);
  }
  const double counted_n = std::min(own_n, reference * normal_n);
  const double beyond_n =
      std::max({0.0, factor * mu * normal_n - counted_n, grain * mu * normal_n});
  RC_ASSERT(std::fabs(force.x + beyond_n) < 1e-12);
  RC_ASSERT(force.y == 0.0);
}

/// Returns the viscous force on a pen that moves at `velocity` for 0.1 s and reports `reported`.
Force viscous_force(double b, Vec velocity, Vec reported, double normal_n) {
  const Friction friction({.coefficient = 0.0, .viscosity_n_s_per_m = b});
  ForceMemory memory;
  Force force;
  for (int i = 0; i <= 100; ++i) {
    const Vec at = 0.001 * i * velocity;
    memory.begin_tick(0.001);
    memory.normal_force_n = normal_n;
    PenSample sample = rig::pen_at({at.x, at.y, -1}, {reported.x, reported.y, 0}, 0.001 * i);
    force = friction(sample, memory);
  }
  return force;
}

RC_GTEST_PROP(Friction, R68_TheViscosityOpposesTheMotionAndIsNoWall, ()) {
  const double b = *rc::gen::inRange(1, 800) * 0.01, normal_n = *rc::gen::inRange(0, 200) * 0.01;
  const Vec v{1.0 * *rc::gen::inRange(-900, 900), 1.0 * *rc::gen::inRange(-900, 900)};
  const Force force = viscous_force(b, v, v, normal_n);
  const double share = std::min(1.0, normal_n / Friction::kWholeViscosityN);
  const double whole_n = 1e-3 * b * share * norm(known_velocity(rig::pen_at({}, {v.x, v.y, 0})));
  RC_ASSERT(std::fabs(norm(force) - std::min(whole_n, Friction::kMaxViscousN)) < 1e-9);
  RC_ASSERT(force.x * v.x + force.y * v.y <= 0.0);
  RC_ASSERT(force.z == 0.0);
}

TEST(Friction, R68_R49_AWrongVelocityDoesNotDriveThePen) {
  EXPECT_EQ(viscous_force(2.0, {50, 0}, {-50, 0}, 0.5), Force{});  // of the wrong sign
  EXPECT_EQ(viscous_force(2.0, {50, 0}, {0, 50}, 0.5), Force{});   // across
  EXPECT_EQ(viscous_force(2.0, {}, {50, 0}, 0.5), Force{});        // of a pen at rest
  const Force tenfold = viscous_force(2.0, {10, 0}, {100, 0}, 0.5);
  EXPECT_LT(tenfold.x, 0.0);
  EXPECT_GE(tenfold.x, -1e-3 * 2.0 * 2.0 * 10.0 * 1.01);
}

TEST(Friction, InTheAirThereIsNoneAndTheBristleIsLifted) {
  const Friction friction;
  ForceMemory memory;
  step(friction, memory, {0, 0, -1}, {}, 1.0);
  EXPECT_GT(norm(step(friction, memory, {0.2, 0, -1}, {}, 1.0)), 0.1);
  EXPECT_EQ(step(friction, memory, {0.2, 0, 1}, {100, 0, 0}, 0.0), Force{});
  EXPECT_FALSE(memory.bristle_is_set);
  // The bristle is anchored again where the pen lands.
  EXPECT_EQ(step(friction, memory, {30, 5, -1}, {}, 1.0), Force{});
}

TEST(Friction, R13_SlidingSteadilyCostsMuFn) {
  for (const Medium& tool : media()) {
    for (const SurfaceMaterial& surface : surface_materials()) {
      for (const double period_s : {0.0002, 0.001, 0.004}) {  // R50
        const rig::Setup setup{.hand = rig::kHands[2], .period_s = period_s, .delay_ticks = 1};
        const SurfaceForce feel = make_surface_force(surface, tool, setup.capabilities());
        rig::Bench bench(setup, ForceModel(feel), {0, 0, 0});
        const double aim = rig::aim_z_mm(setup.hand, 1.0, 500.0);
        const auto target = [&](double t) -> Vec3 { return {40 * t, -20 * t, aim}; };
        bench.run(0.4, target);
        double share = 0.0;
        int ticks = 0;
        bench.run(0.3, target, [&](const rig::Bench& b) {
          share += norm(Force{b.force().x, b.force().y, 0.0}) / b.force().z;
          ++ticks;
        });
        EXPECT_NEAR(share / ticks / friction_of(tool, surface), 1.0, 0.05)
            << tool.id << " on " << surface.id << ", T " << period_s;
      }
    }
  }
}

TEST(Friction, HasNoDirectionOfItsOwn) {
  for (int i = 0; i < 12; ++i) {
    const Friction friction;
    ForceMemory memory;
    const Vec way{std::cos(kTau * i / 12), std::sin(kTau * i / 12)};
    Force force;
    for (double mm = 0.0; mm < 3.0; mm += 0.05) {
      force = step(friction, memory, {mm * way.x, mm * way.y, -1}, {}, 1.0);
    }
    EXPECT_NEAR(force.x, -0.25 * way.x, 1e-12);
    EXPECT_NEAR(force.y, -0.25 * way.y, 1e-12);
  }
}

TEST(Friction, StaticEqualsKinetic) {
  const Friction friction;
  ForceMemory memory;
  double largest = 0.0;
  for (double mm = 0.0; mm < 5.0; mm += 0.001) {
    largest = std::max(largest, norm(step(friction, memory, {mm, 0, -1}, {1, 0, 0}, 1.0)));
  }
  EXPECT_LE(largest, 0.25 + 1e-12);
}

TEST(Friction, MovingTheFootAlongMakesNoSpike) {
  // docs/design/forces.md#friction: a damper on dz/dt would reverse the force when the foot starts
  // to move. On any path with the true velocity of the pen, the force must change between ticks
  // only by the changes of stretch and velocity.
  const Friction friction({.coefficient = 0.5, .stiffness_n_per_m = 600, .damping_n_s_per_m = 1.5});
  for (const double hz : {1.0, 3.0, 7.0}) {
    ForceMemory memory;
    Force last;
    Vec3 last_position, last_velocity;
    for (int i = 0; i < 2000; ++i) {
      const double t = 0.001 * i;
      const Vec3 position{6 * std::sin(kTau * hz * t), 2 * std::sin(kTau * 1.7 * hz * t), -2};
      const Vec3 velocity{6 * kTau * hz * std::cos(kTau * hz * t),
                          2 * 1.7 * kTau * hz * std::cos(kTau * 1.7 * hz * t), 0};
      const Point foot = memory.bristle;
      const Force force = step(friction, memory, position, velocity, 1.0);
      if (i > 0) {
        const double moved_mm = 1.1e-3 * norm(velocity) + 0.02;
        // Shortening to a length is 1-Lipschitz, and so is moving the foot, so twice k dx bounds
        // both.
        EXPECT_LE(norm(force - last),
                  2 * 0.6 * moved_mm + 1.5e-3 * norm(velocity - last_velocity) + 1e-9);
        // Whenever the foot moves, the force opposes the motion.
        if (distance(memory.bristle, foot) > 1e-9) {
          EXPECT_LT(work_mj(force, position - last_position), 0.0);
        }
      }
      last = force;
      last_position = position;
      last_velocity = velocity;
    }
  }
}

TEST(Friction, OnlyTakesEnergyOnAClosedPath) {
  for (const double period_s : {0.0002, 0.001, 0.004}) {
    for (const double radius_mm : {0.05, 0.3, 1.0, 10.0}) {
      const Friction friction;
      ForceMemory memory;
      double energy = 0.0;
      double length_mm = 0.0;
      Vec3 last{radius_mm, 0, -1};
      const int n = static_cast<int>(2.0 / period_s);
      for (int i = 0; i <= n; ++i) {
        const double angle = kTau * 2.0 * i / n;
        const Vec3 now{radius_mm * std::cos(angle), radius_mm * std::sin(2 * angle), -1};
        const Force force =
            step(friction, memory, now, (1 / period_s) * (now - last), 1.0, period_s);
        energy += work_mj(force, now - last);
        length_mm += norm(now - last);
        last = now;
      }
      EXPECT_LE(energy, 1e-6) << radius_mm << " mm, T " << period_s;
      // The work of sliding is mu Fn per distance, except while the bristle reverses (0.42 mm).
      if (radius_mm >= 10.0) {
        EXPECT_NEAR(energy / (-0.25 * length_mm), 1.0, 0.1) << "T " << period_s;
      }
    }
  }
}

TEST(Friction, TheBudgetTakesFromSpringAndDamperAlike) {
  const Friction friction({.coefficient = 5.0});
  ForceMemory memory;
  step(friction, memory, {0, 0, -1}, {}, 1.0);
  const Force full = step(friction, memory, {0.1, 0, -1}, {50, 0, 0}, 1.0);
  memory.scale.friction = 0.5;
  const Force half = step(friction, memory, {0.1, 0, -1}, {50, 0, 0}, 1.0);
  EXPECT_NEAR(half.x, 0.5 * full.x, 1e-15);
  memory.scale.friction = 0.0;
  EXPECT_EQ(step(friction, memory, {0.1, 0, -1}, {50, 0, 0}, 1.0), Force{});
}

TEST(Friction, R42_LeaningOnItForFourSecondsDoesNotCreep) {
  // Pushes with half of mu Fn along the surface for 4 s, with an additional tremor of 8 Hz, on the
  // frictionless device.
  for (const double period_s : {0.0002, 0.001, 0.004}) {  // R50
    for (int delay = 0; delay <= 1; ++delay) {
      const rig::Setup setup{rig::kHands[0], rig::kStyluses[0], period_s, delay};
      const PlaneOptions plane = plane_for(surface_materials()[0], setup.capabilities());
      // The friction is that of the pencil: 600 N/m and 2 N s/m, or less if the device renders
      // less. At 250 Hz the safety chain reduces it (R56).
      FrictionOptions friction =
          friction_for(media()[0], surface_materials()[0], setup.capabilities());
      if (period_s > 0.002) {
        friction.stiffness_n_per_m *= 0.5;
        friction.damping_n_s_per_m *= 0.5;
      }
      rig::Bench bench(setup, ForceModel(Compose(Plane(plane), Friction(friction))), {0, 0, 0});
      const double aim_z = rig::aim_z_mm(setup.hand, 1.0, plane.stiffness_n_per_m);
      const double tilt = 0.5 * 0.25 * 1.0;  // N
      const double aim_x =
          1e3 * tilt * (1 / setup.hand.stiffness_n_per_m + 1 / friction.stiffness_n_per_m);
      const auto target = [&](double t) -> Vec3 {
        const double x = std::clamp((t - 0.8) / 0.4, 0.0, 1.0);
        return {aim_x * x * x * (3 - 2 * x) + 0.3 * x * std::sin(kTau * 8 * t), 0, aim_z};
      };
      bench.run(1.5, target);
      const Point foot = bench.memory().bristle;
      bench.run(4.0, target);
      EXPECT_LT(distance(foot, bench.memory().bristle), 0.05) << setup.name();
    }
  }
}

/// Moves in three patterns: at rest, sliding, and strokes back and forth. Returns the worst
/// high-frequency force.
double worst_hf(const rig::Setup& setup, const Medium& tool) {
  double worst = 0.0;
  for (int scenario = 0; scenario < 3; ++scenario) {
    const SurfaceForce feel =
        make_surface_force(surface_materials()[0], tool, setup.capabilities());
    rig::Bench bench(setup, ForceModel(feel), {0, 0, 1});
    const double aim = rig::aim_z_mm(setup.hand, 1.0, 500.0);
    const auto target = [&](double time) -> Vec3 {
      const double x = std::min(time / 0.4, 1.0);
      const double z = 1 + (aim - 1) * x * x * (3 - 2 * x);
      const double t = std::max(0.0, time - 0.7);
      if (scenario == 0) return {0, 0, z};
      if (scenario == 1) return {20 * t, 5 * t, z};
      return {20 * std::sin(kTau * t), 8 * std::sin(1.5 * kTau * t), z};
    };
    bench.run(0.8, target);
    bench.begin_measuring();
    bench.run(1.0, target);
    worst = std::max(worst, bench.figures().hf_n);
  }
  return worst;
}

TEST(Friction, R41_AnEraserDragsMoreThanAPencilAndBothAreCalm) {
  const Medium& pencil = *find_medium("pencil");
  const Medium& eraser = *find_medium("eraser");
  for (const SurfaceMaterial& surface : surface_materials()) {
    EXPECT_GE(friction_of(eraser, surface) / friction_of(pencil, surface), 2.0);
  }
  double worst = 0.0;
  for (const double period_s : {0.0002, 0.001}) {
    for (int delay = 0; delay <= 2; ++delay) {  // R41 asks for up to 1
      rig::for_each_grip(period_s, delay, [&](const rig::Setup& setup) {
        for (const Medium* tool : {&pencil, &eraser}) {
          const double hf = worst_hf(setup, *tool);
          EXPECT_LT(hf, 0.03) << setup.name() << ", " << tool->id;
          worst = std::max(worst, hf);
        }
      });
    }
  }
  RecordProperty("worst_hf_n", std::to_string(worst));
}

}  // namespace
}  // namespace felt::friction_test
