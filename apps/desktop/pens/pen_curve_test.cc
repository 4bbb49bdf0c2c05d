#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "desktop/pens/device_clock.h"
#include "desktop/pens/pressure_curve.h"
#include "felt/base/constants.h"

namespace felt::desktop::pen_curve_test {
namespace {

// For any handles, the curve goes from 0 to 1 and never falls.
TEST(PressureCurve, NeverFalls) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-0.5, 1.5);
  for (int n = 0; n < 200; ++n) {
    const PressureCurve curve({any(random), any(random)}, {any(random), any(random)},
                              0.5 * any(random));
    EXPECT_EQ(curve(0.0), 0.0);
    EXPECT_NEAR(curve(1.0), 1.0, 1e-9);
    double last = 0.0;
    for (int i = 0; i <= 500; ++i) {
      const double pressure = curve(i / 500.0);
      ASSERT_GE(pressure, last - 1e-9) << n;
      ASSERT_LE(pressure, 1.0);
      last = pressure;
    }
    EXPECT_EQ(curve(curve.threshold()), 0.0);
  }
}

TEST(PressureCurve, IsStraightUnlessTold) {
  const PressureCurve straight;
  for (int i = 0; i <= 100; ++i) EXPECT_NEAR(straight(i / 100.0), i / 100.0, 1e-9);
  EXPECT_EQ(straight(std::numeric_limits<double>::quiet_NaN()), 0.0);
  EXPECT_EQ(straight(2.0), 1.0);
  EXPECT_TRUE(straight.touches(0.0)) << "the tip's switch decides";
  EXPECT_FALSE(PressureCurve({}, {}, 0.1).touches(0.1));
  EXPECT_TRUE(PressureCurve({}, {}, 0.1).touches(0.11));
}

TEST(PressureCurve, SoftIsWiderThanFirm) {
  for (double firmness = -1.0; firmness <= 1.0; firmness += 0.125) {
    const PressureCurve curve = PressureCurve::of_firmness(firmness, 0.0);
    EXPECT_NEAR(curve.firmness(), firmness, 1e-12);
    EXPECT_EQ(curve(0.5) > 0.5 + 1e-9, firmness < 0.0);
    EXPECT_EQ(curve(0.5) < 0.5 - 1e-9, firmness > 0.0);
  }
}

TEST(PressureCurve, IsKeptByTheSettings) {
  const PressureCurve curve({0.1, 0.4}, {0.7, 0.6}, 0.05);
  curve.store();
  EXPECT_EQ(PressureCurve::load(), curve);
  PressureCurve().store();
}

// Events may be up to 20 ms late, and several may arrive together. The resulting times still have
// the spacing of the stamps.
TEST(DeviceClock, KeepsTheSpacingOfTheStamps) {
  std::mt19937 random(2);
  std::uniform_int_distribution<std::int64_t> late(0, 20 * kMs);
  DeviceClock clock;
  std::int64_t now_ns = 0, last_ns = 0;
  int uneven = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::int64_t made_ns = 1'000 * kMs + i * 5 * kMs;
    now_ns = std::max(now_ns, made_ns + late(random));
    const std::int64_t time_ns = clock.time_ns(777'000 + 5 * static_cast<std::uint64_t>(i), now_ns);
    ASSERT_LE(time_ns, now_ns);
    ASSERT_GE(time_ns, last_ns);
    if (i > 200) {
      uneven += std::abs(time_ns - last_ns - 5 * kMs) > kMs ? 1 : 0;
      EXPECT_LT(time_ns - made_ns, 2 * kMs) << "the fastest tells how the clocks lie";
    }
    last_ns = time_ns;
  }
  EXPECT_LT(uneven, 20);
}

TEST(DeviceClock, BeginsAnewWhereStampsJump) {
  DeviceClock clock;
  EXPECT_EQ(clock.time_ns(5'000, 100 * kMs), 100 * kMs);
  EXPECT_NEAR(static_cast<double>(clock.time_ns(5'010, 115 * kMs)), 110e6, 2e3);
  EXPECT_EQ(clock.time_ns(90'000'000, 120 * kMs), 120 * kMs) << "another device";
  EXPECT_EQ(clock.time_ns(7, 130 * kMs), 130 * kMs);
  EXPECT_EQ(clock.time_ns(0, 140 * kMs), 140 * kMs) << "no stamp";
  EXPECT_EQ(clock.time_ns(~std::uint64_t{0}, 150 * kMs), 150 * kMs);
}

}  // namespace
}  // namespace felt::desktop::pen_curve_test
