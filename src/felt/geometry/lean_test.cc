#include "felt/geometry/lean.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "felt/base/constants.h"

namespace felt::lean_test {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

TEST(Lean, OfAnAxisIsItsAngleToTheUpright) {
  EXPECT_EQ(lean_of_axis({0, 0, 1}), 0.0);
  EXPECT_EQ(lean_of_axis({1, 0, 1}), 45.0);
  EXPECT_EQ(lean_of_axis({0, -3, 3}), 45.0);
  EXPECT_EQ(lean_of_axis({0.3, 0.4, 0}), 90.0);
  EXPECT_EQ(lean_of_axis({1, 0, std::sqrt(3.0)}), 30.0);
}

TEST(Lean, KnowsNoEndOfThePenFromTheOther) {
  EXPECT_EQ(lean_of_axis({1, 2, -3}), lean_of_axis({-1, -2, 3}));
  EXPECT_EQ(lean_of_axis({0, 0, -1}), 0.0);
}

TEST(Lean, OfNoDirectionIsNone) {
  for (const Vec3& axis : {Vec3{0, 0, 0}, Vec3{kNan, 0, 1}, Vec3{0, kNan, 1}, Vec3{0, 0, kNan},
                           Vec3{kEndless, 0, 1}, Vec3{0, 0, -kEndless}}) {
    EXPECT_EQ(lean_of_axis(axis), std::nullopt);
  }
  // The squares underflow to 0 or overflow to infinity, but the axis still has a direction.
  EXPECT_EQ(lean_of_axis({1e-300, 0, 1e-300}), 45.0);
  EXPECT_EQ(lean_of_axis({1e300, 0, 1e300}), 45.0);
}

TEST(Lean, OfTiltsIsThatOfTheAxisWithTheseShadows) {
  EXPECT_EQ(lean_of_tilt(0, 0), 0.0);
  EXPECT_EQ(lean_of_tilt(30, 0), 30.0);
  EXPECT_EQ(lean_of_tilt(0, -60), 60.0);
  EXPECT_EQ(lean_of_tilt(45, 45), 54.7);  // atan(sqrt 2) = 54.7356
  EXPECT_EQ(lean_of_tilt(90, 0), 90.0);
  EXPECT_EQ(lean_of_tilt(-90, 90), 90.0);
  const unsigned seed = 20261121;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angle(-89.0, 89.0);
  for (int i = 0; i < 1000; ++i) {
    const double x = angle(random), y = angle(random), to_rad = std::acos(-1.0) / 180.0;
    const double expected = std::atan(std::hypot(std::tan(x * to_rad), std::tan(y * to_rad)));
    ASSERT_NEAR(lean_of_tilt(x, y).value(), expected / to_rad, 0.0501) << "seed " << seed;
  }
}

TEST(Lean, OfTiltsThatNoPenHasIsNone) {
  EXPECT_EQ(lean_of_tilt(kNan, 0), std::nullopt);
  EXPECT_EQ(lean_of_tilt(0, kEndless), std::nullopt);
  EXPECT_EQ(lean_of_tilt(90.5, 0), std::nullopt);
}

TEST(Lean, IsHeldToWhatAPenCanDo) {
  EXPECT_EQ(clean_lean({}), std::nullopt);
  EXPECT_EQ(clean_lean(kNan), std::nullopt);
  EXPECT_EQ(clean_lean(-3.0), 0.0);
  EXPECT_EQ(clean_lean(32.5), 32.5);
  EXPECT_EQ(clean_lean(kEndless), 90.0);
}

}  // namespace
}  // namespace felt::lean_test
