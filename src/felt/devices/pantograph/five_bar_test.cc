#include "felt/devices/pantograph/five_bar.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace felt::pantograph::five_bar_test {
namespace {

constexpr FiveBarSize kSizes[] = {{50, 70, 20}, {70, 90, 0}, {70, 90, 38}};

double between(double low, double high) {
  return low + (high - low) * (*rc::gen::inRange(0, 1'000'001)) * 1e-6;
}

struct Pose {
  FiveBarSize size;
  std::array<double, 2> angles{};
  FiveBar bar;
};

// Returns a random pose with an authority above 0.
Pose any_pose() {
  const FiveBarSize size = kSizes[*rc::gen::inRange(0, 3)];
  const Vec3 place{size.base_mm / 2 + between(-60, 60), between(20, 130), 0};
  const auto angles = angles_for(size, place);
  RC_PRE(angles.has_value());
  const auto bar = FiveBar::at(size, *angles);
  RC_PRE(bar.has_value() && bar->authority() > 0.0);
  return {size, *angles, *bar};
}

// Calculated by hand: the elbows are at (-50, 0) and (70, 0), 120 mm apart; the forearms are 70 mm
// long.
TEST(FiveBar, StretchedToBothSidesTheHandleIsBetween) {
  const auto bar = FiveBar::at(kSizes[0], {M_PI, 0.0});
  ASSERT_TRUE(bar.has_value());
  EXPECT_NEAR(bar->place().x, 10.0, 1e-9);
  EXPECT_NEAR(bar->place().y, std::sqrt(70.0 * 70 - 60.0 * 60), 1e-9);
  // If both arms turn forward (1 clockwise, 2 counter-clockwise), they push the handle away.
  EXPECT_GT(bar->velocity({-1.0, 1.0}).y, 0.0);
  EXPECT_NEAR(bar->velocity({-1.0, 1.0}).x, 0.0, 1e-9);
}

RC_GTEST_PROP(FiveBar, AnglesAndPlacesAreInverse, ()) {
  const Pose pose = any_pose();
  const auto again = angles_for(pose.size, pose.bar.place());
  RC_ASSERT(again.has_value());
  const auto bar = FiveBar::at(pose.size, *again);
  RC_ASSERT(bar.has_value());
  RC_ASSERT(norm(bar->place() - pose.bar.place()) < 1e-6);
}

RC_GTEST_PROP(FiveBar, TheJacobianIsThatOfThePlace, ()) {
  const Pose pose = any_pose();
  constexpr double kStep = 1e-6;
  for (std::size_t k = 0; k < 2; ++k) {
    auto more = pose.angles, less = pose.angles;
    more[k] += kStep;
    less[k] -= kStep;
    const auto ahead = FiveBar::at(pose.size, more), behind = FiveBar::at(pose.size, less);
    RC_PRE(ahead.has_value() && behind.has_value());
    const Vec3 slope = (0.5 / kStep) * (ahead->place() - behind->place());
    const double tolerance = 1e-4 * (1.0 + norm(slope));
    RC_ASSERT(std::abs(slope.x - pose.bar.jacobian()[0][k]) < tolerance);
    RC_ASSERT(std::abs(slope.y - pose.bar.jacobian()[1][k]) < tolerance);
  }
}

RC_GTEST_PROP(FiveBar, WhatTheMotorsDoTheHandFeels, ()) {
  const Pose pose = any_pose();
  const Force force{between(-3, 3), between(-3, 3), 0};
  const std::array<double, 2> omega{between(-5, 5), between(-5, 5)};
  const auto torques = pose.bar.torques(force);
  const double at_hand_mw = work_mj(force, pose.bar.velocity(omega));
  const double at_motors_mw = 1e3 * (torques[0] * omega[0] + torques[1] * omega[1]);
  RC_ASSERT(std::abs(at_hand_mw - at_motors_mw) < 1e-9 * (1.0 + std::abs(at_hand_mw)) + 1e-9);
}

TEST(FiveBar, AuthorityIsGoneBeforeTheForearmsComeIntoLine) {
  const FiveBarSize size = kSizes[1];
  double last = 1.0;
  bool was_zero = false;
  // The handle moves straight away from the motors. The elbows come closer to each other, and
  // the angle between the forearms goes to zero.
  for (double y = 60; y < 160; y += 0.25) {
    const auto angles = angles_for(size, {0, y, 0});
    if (!angles) break;
    const auto bar = FiveBar::at(size, *angles);
    if (!bar) break;
    EXPECT_LE(std::abs(bar->authority() - last), 0.2) << "no step at " << y;
    const auto torques = bar->torques({0, 1.5 * bar->authority(), 0});
    EXPECT_LT(std::abs(torques[0]) + std::abs(torques[1]), 0.5) << y;
    was_zero = was_zero || bar->authority() == 0.0;
    last = bar->authority();
  }
  EXPECT_TRUE(was_zero);
  const auto apart = FiveBar::at({50, 60.01, 20}, {M_PI, 0.0});  // the forearms are in one line
  ASSERT_TRUE(apart.has_value());
  EXPECT_EQ(apart->authority(), 0.0);
}

TEST(FiveBar, ImpossibleAnglesAreNoPlace) {
  EXPECT_FALSE(FiveBar::at({50, 59, 20}, {M_PI, 0.0}).has_value()) << "elbows too far apart";
  EXPECT_FALSE(FiveBar::at({70, 90, 0}, {1.0, 1.0}).has_value()) << "one elbow in the other";
  EXPECT_FALSE(FiveBar::at(kSizes[0], {std::nan(""), 0.0}).has_value());
  EXPECT_FALSE(FiveBar::at(kSizes[0], {HUGE_VAL, 0.0}).has_value());
}

}  // namespace
}  // namespace felt::pantograph::five_bar_test
