#include "felt/haptics/bricks/yielding_spring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/force_model.h"
#include "felt/haptics/testing/feel_rig.h"

namespace felt::yielding_spring_test {
namespace {

constexpr double kYieldS = 0.01;
constexpr EditOptions kNoDamping{.damping_n_s_per_m = 0.0};

/// A pen without hand and device in the force of a pull that began at (0, 0).
struct Pen {
  explicit Pen(const EditOptions& options = kNoDamping, double yield_s = kYieldS)
      : spring({0, 0}, options, yield_s) {
    (void)at({0, 0});
  }
  Force at(Point p) {
    memory.begin_tick(period_s);
    const PenSample sample = rig::pen_at({p.x, p.y, -1}, {}, time_s);
    time_s += period_s;
    return spring(sample, memory);
  }

  YieldingSpring spring;
  ForceMemory memory;
  double period_s = 0.001, time_s = 1.0;
};

TEST(YieldingSpring, R73_ResistsAPenThatMovesAndLetsGoOfOneThatRests) {
  Pen pen;
  Force force;
  for (int i = 0; i <= 200; ++i) {
    force = pen.at({0.06 * i, 0.08 * i});  // 100 mm/s
    EXPECT_LE(0.6 * force.x + 0.8 * force.y, 0.0);
    EXPECT_NEAR(0.8 * force.x - 0.6 * force.y, 0.0, 1e-9);
  }
  // 1 mm behind the pen, of 3.33 mm.
  EXPECT_NEAR(norm(force), 0.3 * kEditLaw.level_n(20.0), 1e-3);
  for (int i = 0; i < 50; ++i) force = pen.at({12, 16});
  EXPECT_LT(norm(force), 0.002);
  for (int i = 1; i <= 50; ++i) force = pen.at({12 - 0.06 * i, 16 - 0.08 * i});
  EXPECT_GT(force.x, 0.1) << "it resists the way back, too";
}

TEST(YieldingSpring, R73_ResistsMoreTheFartherThePenIsAndTheFasterItMoves) {
  double slower = 0.0;
  for (const double mm_per_s : {30.0, 60.0, 120.0, 240.0}) {
    Pen pen;
    double last = 0.0;
    for (int i = 1; 1e-3 * i * mm_per_s < 30.0; ++i) {
      const double n = -pen.at({1e-3 * i * mm_per_s, 0}).x;
      EXPECT_GT(n, last);
      last = n;
    }
    EXPECT_GT(last, slower);
    EXPECT_LT(last, kEditLaw.level_n(30.0));
    slower = last;
  }
  Pen fast;
  Force force;
  for (int i = 1; i <= 40; ++i) force = fast.at({1.0 * i, 0});
  EXPECT_NEAR(force.x, -kEditLaw.level_n(40.0), 1e-9) << "no more than the law of the paper";
}

TEST(YieldingSpring, R73_TheRateOfTheLoopHasNoEffect) {
  for (const double period_s : {0.00025, 0.001, 0.004}) {
    Pen pen;
    pen.period_s = period_s;
    pen.time_s = 1.0 + period_s;
    const auto ticks = std::llround(0.2 / period_s);
    Force force;
    for (std::int64_t i = 1; i <= ticks; ++i) {
      force = pen.at({60 * period_s * static_cast<double>(i), 0});
    }
    // The lag is 60 mm/s times the time constant.
    EXPECT_NEAR(force.x, -0.3 * 0.6 * kEditLaw.level_n(12.0), 1e-6) << period_s;
  }
}

TEST(YieldingSpring, R73_AGestureBeginsWithoutForce) {
  Pen pen;
  for (int i = 1; i <= 100; ++i) (void)pen.at({0.1 * i, 0});
  pen.spring = YieldingSpring({10, 0}, kNoDamping, kYieldS);  // another line was grabbed
  EXPECT_EQ(norm(pen.at({10, 5})), 0.0);
  EXPECT_GT(norm(pen.at({10, 6})), 0.01);
  pen.time_s += 0.2;
  EXPECT_EQ(norm(pen.at({10, 9})), 0.0) << "the same place, but later";
  pen.memory.yield.time_ns += 50'000'000;  // a clock that goes back
  EXPECT_EQ(norm(pen.at({10, 12})), 0.0);
}

TEST(YieldingSpring, R73_NoStepOfThePenChangesItByMoreThanTheSlope) {
  for (const double share : {1.0, 0.5}) {
    Pen pen;
    pen.memory.scale.lateral = share;
    for (int i = 1; i < 20'000; ++i) {
      const double t = 1e-3 * i;
      const Point p{18 * std::sin(kTau * t), 11 * std::sin(1.7 * kTau * t)};
      ForceMemory a = pen.memory, b = pen.memory;
      const double h = 1e-4, angle = 3.1 * i;
      const auto force_at = [&](Point at, ForceMemory& memory) {
        return pen.spring(rig::pen_at({at.x, at.y, -1}, {}, pen.time_s), memory);
      };
      const Force change =
          force_at({p.x + h * std::cos(angle), p.y + h * std::sin(angle)}, a) - force_at(p, b);
      ASSERT_LE(norm(change), share * 0.3 * h * (1 + 1e-6)) << i;
      (void)pen.at(p);
    }
  }
}

TEST(YieldingSpring, R73_ReturnsNoEnergyOverAClosedCycle) {
  for (const double yield_s : {0.002, kYieldS, 0.05}) {
    for (const double hz : {0.5, 2.0, 8.0}) {
      for (std::size_t delay = 0; delay <= 2; ++delay) {
        Pen pen(kNoDamping, yield_s);
        std::vector<Force> late(delay + 1);
        const auto at = [hz](int i) -> Point {
          return {15 * std::sin(kTau * hz * 1e-3 * i), 6 * std::sin(2 * kTau * hz * 1e-3 * i)};
        };
        double energy = 0.0;
        for (int i = 0; i < 6'000; ++i) {
          if (i == 2'000) energy = 0.0;  // whole cycles only
          late[static_cast<std::size_t>(i) % late.size()] = pen.at(at(i));
          const Force acting = late[static_cast<std::size_t>(i + 1) % late.size()];
          energy += work_mj(acting, {at(i + 1).x - at(i).x, at(i + 1).y - at(i).y, 0});
        }
        EXPECT_LE(energy, 0.0) << yield_s << " s, " << hz << " Hz, delay " << delay;
      }
    }
  }
}

TEST(YieldingSpring, R73_IsCalmOnTheSurfaceAndGivesNoEnergy) {
  double worst = 0.0;
  for (const double period_s : {0.0002, 0.001}) {
    for (int delay = 0; delay <= 2; ++delay) {
      rig::for_each_grip(period_s, delay, [&](const rig::Setup& setup) {
        const SurfaceForce paper =
            make_surface_force(surface_materials()[0], media()[0], setup.capabilities());
        for (const double mm : {0.0, 12.0}) {
          rig::Bench bench(
              setup, ForceModel(Compose(paper, YieldingSpring({-3, 1}, EditOptions{}, kYieldS))),
              {0, 0, 1});
          const double aim = rig::aim_z_mm(setup.hand, 1.0, 500.0);
          const auto target = [&](double time) -> Vec3 {
            const double x = std::min(time / 0.4, 1.0), t = std::max(0.0, time - 0.7);
            return {mm * std::sin(kTau * t), 0.4 * mm * std::sin(2.0 * kTau * t),
                    1 + (aim - 1) * x * x * (3 - 2 * x)};
          };
          bench.run(1.7, target);
          bench.begin_measuring();
          bench.run(2.0, target);
          EXPECT_LT(bench.figures().hf_n, 0.03) << setup.name() << ", " << mm << " mm";
          EXPECT_LE(bench.figures().energy_mj, 1.0) << setup.name() << ", " << mm << " mm";
          worst = std::max(worst, bench.figures().hf_n);
        }
      });
    }
  }
  RecordProperty("worst_hf_n", std::to_string(worst));
}

}  // namespace
}  // namespace felt::yielding_spring_test
