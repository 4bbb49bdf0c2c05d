#include "felt/devices/simulated/stroke_forces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "felt/base/constants.h"

namespace felt::stroke_forces_test {
namespace {

StrokePlan plan_on(const char* surface) {
  return {.device = find_stylus_preset("touch"),
          .hand = &typical_hand(),
          .surface = find_surface(surface),
          .tool = find_medium("pencil"),
          .speed_mm_per_s = 100.0,
          .rest_s = 0.4};
}

TEST(StrokeForces, LandsRestsAndGoesBothWays) {
  const StrokeForces forces = draw_stroke(plan_on("rough-paper"));
  EXPECT_TRUE(forces.is_sound);
  EXPECT_FALSE(forces.touching.empty());
  EXPECT_NEAR(static_cast<double>(forces.resting.size()) * forces.period_s, 0.6, 0.01);
  ASSERT_GT(forces.along_x.size(), 100u);
  ASSERT_GT(forces.along_y.size(), 100u);
  EXPECT_LT(forces.along_x.back().x, 0.0) << "friction is against the way";
  EXPECT_LT(forces.along_y.back().y, 0.0);
  EXPECT_EQ(draw_stroke(plan_on("rough-paper")).along_x, forces.along_x);
}

TEST(StrokeForces, R48_APenThatRestsIsQuiet) {
  for (const SurfaceMaterial& surface : surface_materials()) {
    const StrokeForces forces = draw_stroke(plan_on(surface.id.c_str()));
    EXPECT_LT(force_above_30_hz_n(forces.resting, forces.period_s), 0.04) << surface.id;
  }
}

TEST(StrokeForces, OnlyWhatIsFastCountsAsTrembling) {
  constexpr double kPeriodS = 0.001;
  const auto trembling = [&](double hz) {
    std::vector<Force> forces(2000);
    for (std::size_t i = 0; i < forces.size(); ++i) {
      forces[i] = {0.0, 0.1 * std::sin(kTau * hz * kPeriodS * static_cast<double>(i)), 0.8};
    }
    return force_above_30_hz_n(forces, kPeriodS);
  };
  EXPECT_NEAR(trembling(150.0), 0.1 / std::sqrt(2.0), 0.003);
  EXPECT_LT(trembling(5.0), 0.003);
  EXPECT_EQ(force_above_30_hz_n({}, kPeriodS), 0.0);
}

}  // namespace
}  // namespace felt::stroke_forces_test
