#include "felt/devices/evdev/local_fit.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/spring.h"

namespace felt::local_fit_test {
namespace {

/// Returns one sample per millisecond of a grip that trembles around `x0` by `mm` at `hz`, with the
/// force that `law` gives for position and velocity.
template <class Law>
std::vector<FitSample> trembling(double x0, double mm, double hz, const Law& law, int count = 24) {
  std::vector<FitSample> samples;
  for (int i = 0; i < count; ++i) {
    const double phase = kTau * hz * 1e-3 * i;
    FitSample s{x0 + mm * std::sin(phase), mm * kTau * hz * std::cos(phase), 0.0};
    s.force_n = law(s.position_mm, s.speed_mm_per_s);
    samples.push_back(s);
  }
  return samples;
}

double at(const AxisFit& fit, double x, double v) {
  return fit.force_n - fit.stiffness_n_per_mm * (x - fit.position_mm) -
         fit.friction_n * v / (std::abs(v) + 5.0);
}

TEST(LocalFit, ASpringGivesBackItsStiffnessWithinFivePercent) {
  for (const double k : {0.02, 0.1, 0.3, 0.6}) {
    const AxisFit fit =
        fit_axis(trembling(12.0, 1.0, 8.0, [k](double x, double) { return -k * (x - 13.5); }), {});
    EXPECT_NEAR(fit.stiffness_n_per_mm, k, 0.05 * k) << k;
    EXPECT_LE(fit.friction_n, 0.05 * k);
    EXPECT_NEAR(fit.force_n, -k * (fit.position_mm - 13.5), 0.01);
  }
}

/// Fits the edit spring that tools publish. The fitted stiffness is its slope at the grip's
/// position.
TEST(LocalFit, AnEditSpringGivesBackItsStiffnessWithinATenth) {
  const EditSpring brick(Point{20.0, 0.0}, EditOptions{.damping_n_s_per_m = 0.0});
  const auto force = [&brick](double x) {
    PenSample pen;
    pen.position = {x, 0.0, -1.0};
    ForceMemory memory;
    memory.begin_tick(0.001);
    return brick(pen, memory).x;
  };
  for (const double x : {18.0, 16.0, 14.0}) {
    const double slope = (force(x - 0.2) - force(x + 0.2)) / 0.4;
    ASSERT_GT(slope, 0.01) << x;
    const AxisFit fit =
        fit_axis(trembling(x, 0.8, 6.0, [&](double at, double) { return force(at); }), {});
    EXPECT_NEAR(fit.stiffness_n_per_mm, slope, 0.1 * slope) << x;
    EXPECT_NEAR(fit.force_n, force(fit.position_mm), 0.02) << x;
  }
}

TEST(LocalFit, FrictionIsFrictionAndASpringBesideItStaysASpring) {
  // Slow motion with a reversal: the fit can separate friction and spring.
  const AxisFit fit = fit_axis(
      trembling(0.0, 2.0, 30.0,
                [](double x, double v) { return -0.1 * x - 0.4 * v / (std::abs(v) + 5.0); }),
      {});
  EXPECT_NEAR(fit.stiffness_n_per_mm, 0.1, 0.01);
  EXPECT_NEAR(fit.friction_n, 0.4, 0.04);
  // Motion in one direction: a force against the motion counts as friction, a force along it does
  // not.
  const auto slide = [](double force) {
    std::vector<FitSample> samples;
    for (int i = 0; i < 24; ++i) samples.push_back({0.06 * i, 60.0, force});
    return samples;
  };
  EXPECT_GT(fit_axis(slide(-0.5), {}).friction_n, 0.3);
  EXPECT_EQ(fit_axis(slide(0.5), {}).friction_n, 0.0);
  EXPECT_NEAR(fit_axis(slide(0.5), {}).force_n, 0.5, 0.02);
}

TEST(LocalFit, AtRestThereIsNoStiffness) {
  std::vector<FitSample> samples(24, FitSample{7.0, 0.0, -0.6});
  const AxisFit fit = fit_axis(samples, {});
  EXPECT_NEAR(fit.force_n, -0.6, 0.01);
  EXPECT_LT(fit.stiffness_n_per_mm, 0.01);
  EXPECT_EQ(fit.position_mm, 7.0);
}

TEST(LocalFit, DoesWhatTheDeviceCan) {
  const auto spring = trembling(12.0, 1.0, 8.0, [](double x, double) { return -0.3 * (x - 13.5); });
  const AxisFit none = fit_axis(spring, {.spring = false, .friction = false});
  EXPECT_EQ(none.stiffness_n_per_mm, 0.0);
  EXPECT_EQ(none.friction_n, 0.0);
  EXPECT_NEAR(none.force_n, 0.3, 0.3);
  const AxisFit soft = fit_axis(spring, {.max_stiffness_n_per_mm = 0.1});
  EXPECT_DOUBLE_EQ(soft.stiffness_n_per_mm, 0.1);
  EXPECT_NEAR(at(soft, spring.back().position_mm, spring.back().speed_mm_per_s),
              spring.back().force_n, 0.2);
}

TEST(LocalFit, NonsenseIsLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(fit_axis({}, {}).force_n, 0.0);
  std::vector<FitSample> samples{{nan, 0, 1}, {0, inf, 1}, {0, 0, nan}, {1e300, 0, 0}};
  EXPECT_EQ(fit_axis(samples, {}).force_n, 0.0);
  samples.push_back({3.0, 0.0, 0.5});
  EXPECT_NEAR(fit_axis(samples, {}).force_n, 0.5, 0.01);
  EXPECT_EQ(fit_axis(samples, {}).position_mm, 3.0);
}

/// For any input, the fit is finite, and neither its stiffness nor its friction adds energy.
RC_GTEST_PROP(LocalFit, NeverGivesEnergyBack, ()) {
  std::vector<FitSample> samples;
  const int count = *rc::gen::inRange(1, 40);
  for (int i = 0; i < count; ++i) {
    samples.push_back({0.01 * *rc::gen::inRange(-5000, 5000), 0.1 * *rc::gen::inRange(-9000, 9000),
                       0.01 * *rc::gen::inRange(-300, 300)});
  }
  const AxisFit fit =
      fit_axis(samples, {.spring = *rc::gen::arbitrary<bool>(),
                         .friction = *rc::gen::arbitrary<bool>(),
                         .max_stiffness_n_per_mm = 0.01 * *rc::gen::inRange(1, 100)});
  RC_ASSERT(std::isfinite(fit.force_n));
  RC_ASSERT(fit.stiffness_n_per_mm >= 0.0);
  RC_ASSERT(fit.stiffness_n_per_mm <= 1.0);
  RC_ASSERT(fit.friction_n >= 0.0);
  RC_ASSERT(std::isfinite(fit.friction_n));
  RC_ASSERT(std::abs(fit.force_n) + fit.friction_n <=
            1.25 * std::abs(samples.back().force_n) + 1e-12);
}

}  // namespace
}  // namespace felt::local_fit_test
