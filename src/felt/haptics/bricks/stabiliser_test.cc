#include "felt/haptics/bricks/stabiliser.h"

#include <gtest/gtest.h>

#include <numbers>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/testing/feel_rig.h"

namespace felt::stabiliser_test {
namespace {

TEST(Towed, NothingIsFeltWhileTheRopeIsSlack) {
  const Towed towed({.rope_mm = 4.0});
  ForceMemory memory;
  towed(rig::pen_at({0, 0, -1}), memory);
  for (int i = 0; i < 100; ++i) {
    const double a = kTau * i / 100;
    EXPECT_EQ(towed(rig::pen_at({3.9 * std::cos(a), 3.9 * std::sin(a), -1}, {200, 0, 0}), memory),
              Force{});
    EXPECT_EQ(memory.nib.position, (Point{0, 0}));
  }
}

TEST(Towed, TheNibFollowsOnItsRopeAtEveryRate) {
  for (const double period_s : {0.0002, 0.001, 0.004}) {
    const TowOptions options{.rope_mm = 4.0, .time_constant_s = 0.020, .damping_n_s_per_m = 0.0};
    const Towed towed(options);
    ForceMemory memory;
    Force force;
    Point own{};  // as a tool computes it
    for (int i = 0; i < 5000; ++i) {
      const Point pen{100.0 * i * period_s, 0};
      memory.begin_tick(period_s);
      force = towed(rig::pen_at({pen.x, 0, -1}), memory);
      own = towed_nib(options, own, pen, period_s);
      ASSERT_EQ(own, memory.nib.position);
    }
    EXPECT_NEAR(-force.x, options.law.force_n(2.0), 1e-9);  // 100 mm/s x 20 ms
  }
}

TEST(Towed, LiftingDropsTheRope) {
  const Towed towed;
  ForceMemory memory;
  towed(rig::pen_at({0, 0, -1}), memory);
  EXPECT_GT(norm(towed(rig::pen_at({10, 0, -1}), memory)), 0.2);
  EXPECT_EQ(towed(rig::pen_at({10, 0, 1}), memory), Force{});
  EXPECT_EQ(towed(rig::pen_at({10, 0, -1}), memory), Force{});
}

TEST(Towed, ARopeNeverPushes) {
  const Towed towed;
  ForceMemory memory;
  for (int i = 0; i < 5000; ++i) {
    const double t = 0.001 * i;
    const Vec3 pen{20 * std::sin(9 * t), 9 * std::sin(14 * t), -1};
    const Vec3 velocity{180 * std::cos(9 * t), 126 * std::cos(14 * t), 0};
    memory.begin_tick(0.001);
    const Force force = towed(rig::pen_at(pen, velocity), memory);
    const Vec rope = on_page(pen) - memory.nib.position;
    ASSERT_LE(force.x * rope.x + force.y * rope.y, 1e-12);
  }
}

TEST(Inertia, APushIsFeltAsMass) {
  // Moves 2 mm at 2 Hz, well below the coupling's resonance: F = m a, without drag.
  const InertiaOptions options{.mass_kg = 0.05, .drag_n_s_per_m = 0.0};
  const Inertia inertia(options);
  ForceMemory memory;
  double largest = 0.0;
  for (int i = 0; i < 40'000; ++i) {
    const double w = kTau * 2.0;
    const double t = 0.0002 * i;
    const double grown = std::min(1.0, t / 2.0);
    memory.begin_tick(0.0002);
    const Force force = inertia(rig::pen_at({10 * grown * std::sin(w * t), 0, -1},
                                            {10 * grown * w * std::cos(w * t), 0, 0}),
                                memory);
    if (t > 5.0) largest = std::max(largest, std::abs(force.x));
  }
  const double expected = 0.05 * 0.010 * (kTau * 2.0) * (kTau * 2.0);
  EXPECT_NEAR(largest / expected, 1.0, 0.06);
}

TEST(Inertia, IsBoundedAndComesToRest) {
  const Inertia inertia;
  ForceMemory memory;
  inertia(rig::pen_at({0, 0, -1}), memory);
  for (int i = 0; i < 3000; ++i) {
    memory.begin_tick(0.001);
    const Force force = inertia(rig::pen_at({80, -40, -1}), memory);
    ASSERT_LE(norm(force), 1.0 + 1e-12);
    if (i == 2999) {
      EXPECT_LT(norm(force), 1e-3);
    }
  }
  EXPECT_LT(distance(memory.nib.position, {80, -40}), 0.01);
}

TEST(Inertia, OnlyTakesEnergyOverAClosedCycle) {
  for (const double period_s : {0.0002, 0.001, 0.004}) {
    for (const double hz : {0.5, 2.0, 6.0}) {
      const Inertia inertia;
      ForceMemory memory;
      VelocityFilter filter;
      double energy = 0.0;
      const auto ticks = static_cast<int>(std::lround(1.0 / hz / period_s));
      Vec3 last{0, 0, -1};
      for (int i = 1; i <= 12 * ticks; ++i) {
        if (i == 10 * ticks + 1) energy = 0.0;
        const double a = kTau * i / ticks;
        const Vec3 now{10 * std::sin(a), 4 * std::sin(2 * a), -1};
        memory.begin_tick(period_s);
        const Force force = inertia(rig::pen_at(now, filter.update(now, period_s)), memory);
        energy += work_mj(force, now - last);
        last = now;
      }
      EXPECT_LE(energy, 0.0) << period_s << " s, " << hz << " Hz";
    }
  }
}

TEST(Stabilisers, AreCalmOnTheSurface) {
  double worst = 0.0;
  for (const bool tow : {true, false}) {
    for (const double period_s : {0.0002, 0.001}) {
      for (int delay = 0; delay <= 2; ++delay) {
        rig::for_each_grip(period_s, delay, [&](const rig::Setup& setup) {
          const SurfaceForce surface =
              make_surface_force(surface_materials()[0], media()[0], setup.capabilities());
          rig::Bench bench(
              setup,
              tow ? ForceModel(Compose(surface, Towed())) : ForceModel(Compose(surface, Inertia())),
              {0, 0, 1});
          const double aim = rig::aim_z_mm(setup.hand, 1.0, 500.0);
          const auto target = [&](double time) -> Vec3 {
            const double x = std::min(time / 0.4, 1.0);
            const double t = std::max(0.0, time - 0.7);
            return {20 * std::sin(kTau * t), 8 * std::sin(1.5 * kTau * t),
                    1 + (aim - 1) * x * x * (3 - 2 * x)};
          };
          bench.run(0.8, target);
          bench.begin_measuring();
          bench.run(1.0, target);
          EXPECT_LT(bench.figures().hf_n, 0.03) << setup.name() << (tow ? " towed" : " inertia");
          worst = std::max(worst, bench.figures().hf_n);
        });
      }
    }
  }
  RecordProperty("worst_hf_n", std::to_string(worst));
}

}  // namespace
}  // namespace felt::stabiliser_test
