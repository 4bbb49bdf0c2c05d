#include "felt/haptics/testing/feel_rig.h"

#include <gtest/gtest.h>

#include <numbers>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/spring.h"

namespace felt::feel_rig_test {
namespace {

TEST(FeelRig, HighFrequencyPassesWhatIsAbove30Hz) {
  for (const double period_s : {0.0002, 0.001}) {
    const auto rms_of = [&](double hz) {
      rig::HighFrequency hf(period_s);
      const auto ticks = static_cast<int>(3.0 / period_s);
      for (int i = 0; i < ticks; ++i) {
        if (i == ticks / 3) hf.begin();
        hf.push({0.0, 0.1 * std::sin(kTau * hz * i * period_s), 1.0});
      }
      return hf.rms_n() / (0.1 / std::numbers::sqrt2);
    };
    EXPECT_LT(rms_of(3.0), 0.001);
    EXPECT_NEAR(rms_of(30.0), 1.0 / std::numbers::sqrt2, 0.01);
    EXPECT_NEAR(rms_of(100.0), 1.0, 0.02);
  }
}

TEST(FeelRig, AHeldPenSwingsAsItsEquationSays) {
  // A mass of 75 g on 100 N/m and 1 N s/m is released 5 mm away, without other forces.
  const rig::Hand hand{"own", 0.0, 100.0, 1.0};
  const rig::Setup setup{hand, {"own", 0.075, 0.0}};
  rig::Bench bench(setup, ForceModel(), {5, 0, 0});
  double worst = 0.0;
  bench.run(
      0.5, [](double) { return Vec3{}; },
      [&](const rig::Bench& b) {
        const double decay = 1.0 / (2 * 0.075);
        const double w = std::sqrt(100.0 / 0.075 - decay * decay);
        const double t = b.time_s();
        const double x = 5 * std::exp(-decay * t) * (std::cos(w * t) + decay / w * std::sin(w * t));
        worst = std::max(worst, std::abs(b.position().x - x));
      });
  EXPECT_LT(worst, 0.005);
}

TEST(FeelRig, DeviceFrictionStopsThePen) {
  const rig::Setup setup{{"weak", 0.0, 30.0, 0.3}, rig::kStyluses[1]};
  rig::Bench bench(setup, ForceModel(), {5, 0, 0});  // 0.15 N against 0.26 N
  bench.run(0.5, [](double) { return Vec3{}; });
  EXPECT_EQ(bench.position(), (Vec3{5, 0, 0}));
}

TEST(FeelRig, ForcesComeLateByTheirTicks) {
  for (int delay = 0; delay <= 3; ++delay) {
    rig::Setup setup;
    setup.delay_ticks = delay;
    rig::Bench bench(setup, ForceModel(EditSpring({0, 0})), {5, 0, 0});
    int first = -1;
    int tick = 0;
    bench.run(
        0.01,
        [](double) {
          return Vec3{5, 0, 0};
        },
        [&](const rig::Bench& b) {
          if (first < 0 && norm(b.force()) > 0.0) first = tick;
          ++tick;
        });
    EXPECT_EQ(first, delay);
  }
}

TEST(FeelRig, CountsTheWorkOfASpringThatLosesNothing) {
  // A hand pulls the pen out against a spring, which stores the work as potential energy.
  rig::Setup setup;
  setup.step_mm = 0.0;
  setup.delay_ticks = 0;
  setup.period_s = 0.0002;
  rig::Bench bench(setup, ForceModel(EditSpring({0, 0}, {.damping_n_s_per_m = 0.0})), {0, 0, 0});
  bench.run(2.0, [](double t) {
    const double x = std::min(t / 1.5, 1.0);
    return Vec3{12 * x * x * (3 - 2 * x), 0, 0};
  });
  const double stored = kEditLaw.potential_mj(bench.position().x);
  EXPECT_NEAR(bench.figures().energy_mj / -stored, 1.0, 0.01);
}

}  // namespace
}  // namespace felt::feel_rig_test
