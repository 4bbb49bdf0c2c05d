#include "felt/devices/simulated/faulty_device.h"

#include <cmath>
#include <set>
#include <string_view>

#include <gtest/gtest.h>
#include <cstddef>

#include "felt/base/constants.h"
#include "felt/devices/simulated/simulated_stylus.h"

namespace felt::faulty_device_test {
namespace {

// Returns the samples of a pen that moves along x and downwards. The fault lasts from 10 to 20 ms.
std::vector<tl::expected<PenSample, DeviceFault>> with_fault(InjectedFault fault, double amount) {
  SimulatedStylus stylus(*find_stylus_preset("worst"), *find_hand("firm"));
  FaultyDevice device(
      stylus, {{.fault = fault, .from_ns = 10 * kMs, .until_ns = 20 * kMs, .amount = amount}});
  std::vector<tl::expected<PenSample, DeviceFault>> samples;
  for (int i = 0; i < 40; ++i) {
    stylus.aim({10.0 + 0.1 * i, 20, 8.0 - 0.1 * i}, {}, 0);
    samples.push_back(device.read(i * kMs));
    (void)device.write({0.1, 0, 0});
  }
  return samples;
}

TEST(FaultyDevice, FailsOnScheduleOnly) {
  const auto healthy = with_fault(InjectedFault::kReadError, 0.0);
  for (const InjectedFault fault :
       {InjectedFault::kReadError, InjectedFault::kUnplugged, InjectedFault::kNotFinite,
        InjectedFault::kInfinite, InjectedFault::kJump, InjectedFault::kJumpOften,
        InjectedFault::kFrozen, InjectedFault::kStuckAxis, InjectedFault::kSignFlip,
        InjectedFault::kNoise, InjectedFault::kCoarse, InjectedFault::kTimeBackwards,
        InjectedFault::kButtonBounce, InjectedFault::kUncalibrated, InjectedFault::kButtonStuck,
        InjectedFault::kDenormal, InjectedFault::kNoAnswer}) {
    const auto samples = with_fault(fault, 5.0);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const bool inside = i >= 10 && i < 20;
      if (!inside) {
        ASSERT_TRUE(samples[i].has_value());
        if (i < 10) {
          EXPECT_EQ(*samples[i], *healthy[i]);
        }
        continue;
      }
      switch (fault) {
        case InjectedFault::kReadError:
        case InjectedFault::kUnplugged:
          ASSERT_FALSE(samples[i].has_value());
          EXPECT_EQ(samples[i].error(), DeviceFault::kDisconnected);
          break;
        case InjectedFault::kUncalibrated:
          ASSERT_FALSE(samples[i].has_value());
          EXPECT_EQ(samples[i].error(), DeviceFault::kNotCalibrated);
          break;
        case InjectedFault::kNotFinite:
          EXPECT_FALSE(is_finite(samples[i]->position));
          break;
        case InjectedFault::kInfinite:
          EXPECT_FALSE(is_finite(samples[i]->velocity));
          break;
        case InjectedFault::kFrozen:
          EXPECT_EQ(samples[i]->position, samples[9]->position);
          break;
        case InjectedFault::kStuckAxis:
          EXPECT_EQ(samples[i]->position.z, samples[9]->position.z);
          EXPECT_TRUE(i < 15 || samples[i]->position.x != samples[9]->position.x);
          break;
        case InjectedFault::kSignFlip:
          EXPECT_LT(samples[i]->position.x, 0.0);
          break;
        case InjectedFault::kCoarse:
          EXPECT_EQ(std::fmod(samples[i]->position.x, 5.0), 0.0);
          break;
        case InjectedFault::kTimeBackwards:
          EXPECT_EQ(samples[i]->time_ns, static_cast<std::int64_t>(i) * kMs - 5 * kMs);
          break;
        case InjectedFault::kButtonBounce:
          EXPECT_NE(samples[i]->buttons, samples[i - 1]->buttons == 0 && i == 10 ? 2u : 3u);
          break;
        case InjectedFault::kJump:
          EXPECT_GT(samples[i]->position.x, 14.0);
          break;
        case InjectedFault::kJumpOften:
          EXPECT_EQ(samples[i]->position.x > 14.0, i % 2 == 1) << i;
          break;
        case InjectedFault::kButtonStuck:
          EXPECT_EQ(samples[i]->buttons & 1u, 1u);
          break;
        case InjectedFault::kDenormal:
          EXPECT_EQ(std::fpclassify(samples[i]->position.z), FP_SUBNORMAL);
          break;
        case InjectedFault::kNoAnswer:
          EXPECT_EQ(*samples[i], *samples[9]);
          break;
        case InjectedFault::kNoise:
        case InjectedFault::kWriteError:
        case InjectedFault::kForceIgnored:
        case InjectedFault::kForcesOff:
        case InjectedFault::kWarmMotors:
        case InjectedFault::kSlowAnswers:
        case InjectedFault::kLostAnswers:
        case InjectedFault::kBurstAnswers:
        case InjectedFault::kLateAnswer:
          break;
      }
    }
  }
}

TEST(FaultyDevice, WritesFailToo) {
  SimulatedStylus stylus(*find_stylus_preset("worst"));
  FaultyDevice device(stylus, {{InjectedFault::kWriteError, 0, 5 * kMs, 0},
                               {InjectedFault::kForceIgnored, 10 * kMs, 15 * kMs, 0}});
  for (int i = 0; i < 20; ++i) {
    ASSERT_TRUE(device.read(i * kMs).has_value());
    const auto written = device.write({0, 0, 0.01 * (i + 1)});
    EXPECT_EQ(written.has_value(), i >= 5);
    if (i == 12) {
      EXPECT_NEAR(stylus.acting_force().z, 0.10, 1e-12) << "the last one that got through";
    }
  }
}

TEST(FaultyDevice, EachFaultHasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (const InjectedFault fault : injected_faults()) names.insert(name_of(fault));
  EXPECT_EQ(names.size(), injected_faults().size());
  EXPECT_FALSE(names.contains("?"));
}

TEST(FaultyDevice, OneThatTakesNoForceIsStillRead) {
  for (const auto& [fault, said] :
       {std::pair(InjectedFault::kForcesOff, DeviceFault::kForcesOff),
        std::pair(InjectedFault::kWarmMotors, DeviceFault::kOverheated)}) {
    SimulatedStylus stylus(*find_stylus_preset("worst"));
    FaultyDevice device(stylus, {{fault, 5 * kMs, 10 * kMs, 0}});
    for (int i = 0; i < 20; ++i) {
      ASSERT_TRUE(device.read(i * kMs).has_value());
      const auto written = device.write({0, 0, 0.1});
      ASSERT_EQ(written.has_value(), i < 5 || i >= 10);
      if (i == 8) {
        EXPECT_EQ(written.error(), said);
        EXPECT_EQ(stylus.acting_force(), Force{}) << "and none holds";
      }
    }
  }
}

}  // namespace
}  // namespace felt::faulty_device_test
