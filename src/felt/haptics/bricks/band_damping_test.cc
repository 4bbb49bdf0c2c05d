#include "felt/haptics/bricks/band_damping.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/testing/feel_rig.h"

namespace felt::band_damping_test {
namespace {

/// Returns the largest force while the pen oscillates along x with 1 mm, after 2 s.
double force_at(double hz, double period_s) {
  const BandDamping damping({.hz = 5.0});
  ForceMemory memory;
  double largest = 0.0;
  for (int i = 0; i * period_s < 3.0; ++i) {
    const double t = i * period_s, w = kTau * hz;
    memory.begin_tick(period_s);
    const Force f =
        damping(rig::pen_at({std::sin(w * t), 0, -1}, {w * std::cos(w * t), 0, 0}), memory);
    if (t > 2.0) largest = std::max(largest, norm(f));
  }
  return largest;
}

TEST(BandDamping, DampsTheBandAndLeavesSlowMotionFree) {
  for (const double period_s : {0.0002, 0.001, 0.004}) {
    // 4 N s/m times the speed above what is unknown of it.
    const double expected = 4e-3 * (kTau * 5.0 - kUnknownSpeedMmPerS);
    EXPECT_NEAR(force_at(5.0, period_s), expected, 0.15 * expected) << period_s;
    EXPECT_LT(force_at(0.5, period_s), 1e-9);  // 3 mm/s
  }
  // 100 mm/s straight on: free once the pen is on its course.
  const BandDamping damping({.hz = 5.0});
  ForceMemory memory;
  Force last;
  for (int i = 0; i < 2000; ++i) {
    memory.begin_tick(0.001);
    last = damping(rig::pen_at({0.1 * i, 0, -1}, {100, 0, 0}), memory);
  }
  EXPECT_LT(norm(last), 1e-3);
}

TEST(BandDamping, ShakingAcrossTheLineIsDampedToo) {
  const BandDamping damping({.hz = 5.0});
  ForceMemory memory;
  double largest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const double vy = 40.0 * std::cos(kTau * 5.0 * 0.001 * i);
    memory.begin_tick(0.001);
    const Force f = damping(rig::pen_at({0, 0, -1}, {80, vy, 0}), memory);
    if (i > 2000) largest = std::max(largest, std::fabs(f.y));
  }
  EXPECT_GT(largest, 0.1);
}

TEST(BandDamping, LiftingForgetsTheBand) {
  const BandDamping damping;
  ForceMemory memory;
  damping(rig::pen_at({0, 0, -1}, {200, 0, 0}), memory);
  EXPECT_EQ(damping(rig::pen_at({0, 0, 1}, {200, 0, 0}), memory), Force{});
  EXPECT_EQ(memory.shake_band.band, Vec{});
}

RC_GTEST_PROP(BandDamping, IsADamperWhateverThePenDoes, (std::uint64_t seed)) {
  Random random(seed);
  const BandDampingOptions options{.hz = random.between(3, 12),
                                   .damping_n_s_per_m = random.between(0, 10)};
  const BandDamping damping(options);
  ForceMemory memory;
  for (int i = 0; i < 500; ++i) {
    memory.begin_tick(random.between(0.0002, 0.005));
    const double speed = std::pow(10.0, random.between(0, 4));
    const Vec3 v{speed * random.normal(), speed * random.normal(), random.normal()};
    const Force f = damping(rig::pen_at({0, 0, random.between(-1, 0.1)}, v), memory);
    RC_ASSERT(is_finite(f));
    RC_ASSERT(f.z == 0.0);
    RC_ASSERT(norm(f) <= 0.5 + 1e-12);
    RC_ASSERT(work_mj(f, v) <= 0.0);
    RC_ASSERT(norm(f) <= 1e-3 * options.damping_n_s_per_m * norm(in_plane(v)) + 1e-12);
  }
}

TEST(BandDamping, LeavesAWeakDeviceItsDamping) {
  EXPECT_EQ(band_damping_for(6.0, {.max_damping_n_s_per_m = 8.0}).damping_n_s_per_m, 2.0);
  EXPECT_EQ(band_damping_for(6.0, {}).hz, 6.0);
  EXPECT_EQ(band_damping_for(6.0, {}).damping_n_s_per_m, 4.0);
}

}  // namespace
}  // namespace felt::band_damping_test
