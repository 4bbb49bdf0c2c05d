#include "felt/driver/position_filter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace felt::position_filter_test {
namespace {

TEST(PositionFilter, HasNoLagInSteadyMovement) {
  PositionFilter filter(80.0, 0.5);
  Vec3 at;
  for (int i = 0; i < 100; ++i) filter.update(at = {0.1 * i, -0.05 * i, 3.0}, 0.001);
  EXPECT_NEAR(norm(filter.position() - at), 0.0, 1e-6);
  EXPECT_NEAR(norm(filter.velocity() - Vec3{100.0, -50.0, 0.0}), 0.0, 1e-3);
}

TEST(PositionFilter, SmoothsTheStepsOfAnEncoder) {
  PositionFilter filter(80.0, 0.5);
  double largest = 0.0;
  for (int i = 0; i < 400; ++i) {
    const double true_mm = 0.01 * i;  // 10 mm/s, in steps of 0.04 mm
    filter.update({0.04 * std::floor(true_mm / 0.04), 0.0, 0.0}, 0.001);
    if (i > 100) largest = std::max(largest, std::fabs(filter.velocity().x - 10.0));
  }
  EXPECT_LT(largest, 12.0) << "a plain difference is wrong by 30 mm/s";
}

TEST(PositionFilter, PassesJumpsAndPausesOnAsTheyAre) {
  PositionFilter filter(80.0, 0.5);
  for (int i = 0; i < 10; ++i) filter.update({0.1 * i, 0.0, 0.0}, 0.001);
  filter.update({50.0, 0.0, 0.0}, 0.001);
  EXPECT_EQ(filter.position(), (Vec3{50.0, 0.0, 0.0}));
  EXPECT_EQ(filter.velocity(), Vec3{});
  filter.update({50.1, 0.0, 0.0}, 0.5);
  EXPECT_EQ(filter.position(), (Vec3{50.1, 0.0, 0.0}));
  filter.reset();
  filter.update({50.2, 0.0, 0.0}, 0.001);
  EXPECT_EQ(filter.position(), (Vec3{50.2, 0.0, 0.0}));
  EXPECT_EQ(filter.velocity(), Vec3{});
}

}  // namespace
}  // namespace felt::position_filter_test
