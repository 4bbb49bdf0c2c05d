#include "felt/geometry/tilt.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "felt/base/constants.h"

namespace felt::tilt_test {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

TEST(Tilt, OfAnAxisIsItsAngleToTheUpright) {
  EXPECT_EQ(tilt_of_axis({0, 0, 1}), 0.0);
  EXPECT_EQ(tilt_of_axis({1, 0, 1}), 45.0);
  EXPECT_EQ(tilt_of_axis({0, -3, 3}), 45.0);
  EXPECT_EQ(tilt_of_axis({0.3, 0.4, 0}), 90.0);
  EXPECT_EQ(tilt_of_axis({1, 0, std::sqrt(3.0)}), 30.0);
}

TEST(Tilt, KnowsNoEndOfThePenFromTheOther) {
  EXPECT_EQ(tilt_of_axis({1, 2, -3}), tilt_of_axis({-1, -2, 3}));
  EXPECT_EQ(tilt_of_axis({0, 0, -1}), 0.0);
}

TEST(Tilt, OfNoDirectionIsNone) {
  for (const Vec3& axis : {Vec3{0, 0, 0}, Vec3{kNan, 0, 1}, Vec3{0, kNan, 1}, Vec3{0, 0, kNan},
                           Vec3{kEndless, 0, 1}, Vec3{0, 0, -kEndless}}) {
    EXPECT_EQ(tilt_of_axis(axis), std::nullopt);
  }
  // The squares underflow to 0 or overflow to infinity, but the axis still has a direction.
  EXPECT_EQ(tilt_of_axis({1e-300, 0, 1e-300}), 45.0);
  EXPECT_EQ(tilt_of_axis({1e300, 0, 1e300}), 45.0);
}

TEST(Tilt, OfTiltsIsThatOfTheAxisWithTheseShadows) {
  EXPECT_EQ(tilt_of_xy(0, 0), 0.0);
  EXPECT_EQ(tilt_of_xy(30, 0), 30.0);
  EXPECT_EQ(tilt_of_xy(0, -60), 60.0);
  EXPECT_EQ(tilt_of_xy(45, 45), 54.7);  // atan(sqrt 2) = 54.7356
  EXPECT_EQ(tilt_of_xy(90, 0), 90.0);
  EXPECT_EQ(tilt_of_xy(-90, 90), 90.0);
  const unsigned seed = 20261121;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angle(-89.0, 89.0);
  for (int i = 0; i < 1000; ++i) {
    const double x = angle(random), y = angle(random), to_rad = std::acos(-1.0) / 180.0;
    const double expected = std::atan(std::hypot(std::tan(x * to_rad), std::tan(y * to_rad)));
    ASSERT_NEAR(tilt_of_xy(x, y).value(), expected / to_rad, 0.0501) << "seed " << seed;
  }
}

TEST(Tilt, OfTiltsThatNoPenHasIsNone) {
  EXPECT_EQ(tilt_of_xy(kNan, 0), std::nullopt);
  EXPECT_EQ(tilt_of_xy(0, kEndless), std::nullopt);
  EXPECT_EQ(tilt_of_xy(90.5, 0), std::nullopt);
}

TEST(Tilt, IsHeldToWhatAPenCanDo) {
  EXPECT_EQ(checked_tilt({}), std::nullopt);
  EXPECT_EQ(checked_tilt(kNan), std::nullopt);
  EXPECT_EQ(checked_tilt(-3.0), 0.0);
  EXPECT_EQ(checked_tilt(32.5), 32.5);
  EXPECT_EQ(checked_tilt(kEndless), 90.0);
}

}  // namespace
}  // namespace felt::tilt_test
