#include "felt/devices/forcedimension/dhd_models.h"

#include <gtest/gtest.h>

#include "felt/driver/device_models.h"

namespace felt::dhd::dhd_models_test {
namespace {

TEST(DhdModels, EveryTypeHasARowInTheTableOfModels) {
  for (int number = -10; number < 300; ++number) {
    const SystemType type = system_type_of(number);
    EXPECT_EQ(type.number, number);
    ASSERT_NE(find_device_model(type.model), nullptr) << number;
  }
}

TEST(DhdModels, KnowsThoseOfTheMakersHeader) {
  EXPECT_EQ(system_type_of(33).model, "omega.3");
  EXPECT_EQ(system_type_of(63).model, "delta.3");
  EXPECT_EQ(system_type_of(60).model, "falcon");
  EXPECT_EQ(system_type_of(104).model, "sigma.7");
  EXPECT_EQ(system_type_of(109).model, "lambda.7");
  EXPECT_EQ(system_type_of(132).model, "lambda.6");
  EXPECT_EQ(system_type_of(203).model, "lambda.3");
  EXPECT_EQ(system_type_of(206).model, "sigma.3");
}

TEST(DhdModels, WhatHasMotorsInItsHandleIsToldSo) {
  EXPECT_EQ(system_type_of(33).call, ForceCall::kForce);
  EXPECT_EQ(system_type_of(34).call, ForceCall::kForce) << "the wrist of an omega.6 has no motors";
  EXPECT_EQ(system_type_of(37).call, ForceCall::kForceAndGripper);
  EXPECT_EQ(system_type_of(104).call, ForceCall::kForceTorqueAndGripper);
}

TEST(DhdModels, TheUnknownIsADeviceWithThreeAxesNeverRefused) {
  for (int number : {0, -1, 81, 91, 102, 103, 112, 130, 133, 209, 211, 9999}) {
    EXPECT_EQ(system_type_of(number).model, "generic-3dof") << number;
    EXPECT_TRUE(system_type_of(number).label.empty()) << "the library's own name is better";
  }
}

TEST(DhdModels, OnlyTheOneOmegaHasItsButtonInTheSecondPlace) {
  for (int number = 0; number < 300; ++number) {
    EXPECT_EQ(system_type_of(number).second_button_is_first, number == 110) << number;
  }
}

}  // namespace
}  // namespace felt::dhd::dhd_models_test
