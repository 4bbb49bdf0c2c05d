#include "felt/validate/validator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>

#include "felt/devices/simulated/faulty_device.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/validate/simulated_subject.h"

namespace felt::validator_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

ValidationOptions quick(std::uint64_t seed = 1) {
  ValidationOptions options;
  options.program = "test";
  options.seed = seed;
  options.rate_s = 2.0;
  options.soak_s = 10.0;
  return options;
}

DeviceDescriptor descriptor_of(const StylusPreset& preset) {
  DeviceDescriptor descriptor;
  descriptor.id = "simulated:" + std::string(preset.name);
  descriptor.driver = "simulated";
  descriptor.label = preset.label;
  descriptor.capabilities = preset.capabilities;
  return descriptor;
}

/// A device that does one thing wrong.
class BadDevice final : public Device {
 public:
  explicit BadDevice(Device& device) : device_(device), capabilities_(device.capabilities()) {}

  [[nodiscard]] std::string_view name() const noexcept override { return device_.name(); }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override { return capabilities_; }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    if (off_after_ns > 0 && has_read_ && now_ns - last_ns_ > off_after_ns) gap_ns_ = now_ns;
    is_off_ = is_off_ || (gap_ns_ && now_ns - *gap_ns_ >= off_late_ns);
    has_read_ = true;
    last_ns_ = now_ns;
    auto sample = device_.read(now_ns);
    if (is_off_) device_.stop();
    if (is_off_) return tl::unexpected(DeviceFault::kNotCalibrated);
    if (sample && bend_sample) bend_sample(*sample);
    return sample;
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    waiting_.push_back(bend_force ? bend_force(force) : force);
    if (waiting_.size() <= late_ticks) return device_.write({});
    const Force now = waiting_.front();
    waiting_.pop_front();
    return device_.write(now);
  }
  void stop() noexcept override {
    waiting_.clear();
    device_.stop();
  }

  std::function<Force(const Force&)> bend_force;
  std::function<void(PenSample&)> bend_sample;
  std::size_t late_ticks = 0;
  std::int64_t off_after_ns = 0;  // without a read(), it is switched off; 0: never
  std::int64_t off_late_ns = 0;   // this long after the next read()
  Capabilities& bend_capabilities() { return capabilities_; }

 private:
  Device& device_;
  Capabilities capabilities_;
  std::deque<Force> waiting_;
  bool is_off_ = false, has_read_ = false;
  std::int64_t last_ns_ = 0;
  std::optional<std::int64_t> gap_ns_;
};

struct Setting {
  const char* preset = "premium";  // has hardly any friction
  std::vector<FaultWindow> faults = {};
  std::function<void(BadDevice&)> plant = {};
  SimulatedSubjectOptions subject = {};
  std::vector<std::int64_t> lateness_ns = {};
};

ValidationReport test(const Setting& setting, const ValidationOptions& options = quick()) {
  const StylusPreset& preset = *find_stylus_preset(setting.preset);
  SimulatedStylus stylus(preset);
  FaultyDevice faulty(stylus, setting.faults);
  BadDevice device(faulty);
  if (setting.plant) setting.plant(device);
  SimulatedSubject subject(device, stylus, descriptor_of(preset), setting.subject);
  VirtualTestLoop loop([&subject](std::int64_t now_ns) { subject.before_tick(now_ns); },
                       setting.lateness_ns);
  return validate(subject, loop, subject, options);
}

std::vector<FaultWindow> always(InjectedFault fault, double amount = 1.0) {
  return {{fault, 0, std::numeric_limits<std::int64_t>::max(), amount}};
}

std::vector<std::string> ids_with(const ValidationReport& report, Verdict verdict) {
  std::vector<std::string> ids;
  for (const CheckResult& check : report.checks) {
    if (check.verdict == verdict) ids.push_back(check.id);
  }
  return ids;
}

TEST(ValidatorTest, EverySimulatedStylusPasses) {
  for (const StylusPreset& preset : stylus_presets()) {
    const ValidationReport report = test({.preset = preset.name.data()});
    EXPECT_TRUE(report.passed()) << report_text(report);
    EXPECT_THAT(ids_with(report, Verdict::kNotRun), IsEmpty());
    EXPECT_EQ(report.checks.size(), 15U);
  }
}

TEST(ValidatorTest, AGoodDevicePassesEverything) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const ValidationReport report = test({}, quick(seed));
    EXPECT_EQ(ids_with(report, Verdict::kPassed).size(), 15U) << report_text(report);
  }
}

TEST(ValidatorTest, TheSameSeedGivesTheSameReport) {
  EXPECT_EQ(report_text(test({})), report_text(test({})));
}

TEST(ValidatorTest, WhatIsWithoutForceCannotBePushed) {
  const ValidationReport report = test({.preset = "tablet"});
  EXPECT_TRUE(report.passed());
  EXPECT_THAT(ids_with(report, Verdict::kNotPossible),
              ElementsAre("force_felt", "force_sign", "step", "limits", "engaging", "watchdog"));
}

TEST(ValidatorTest, LevelsEndWhereTheyAreAsked) {
  ValidationOptions options = quick();
  options.level = 2;
  const ValidationReport report = test({}, options);
  EXPECT_EQ(report.checks.size(), 3U);
  EXPECT_EQ(report.checks.back().id, "capabilities");
}

TEST(ValidatorTest, AWrongSignIsFound) {
  for (int axis = 0; axis < 3; ++axis) {
    const ValidationReport report = test({.plant = [axis](BadDevice& device) {
      device.bend_force = [axis](Force force) {
        (axis == 0 ? force.x : axis == 1 ? force.y : force.z) *= -1.0;
        return force;
      };
    }});
    EXPECT_THAT(ids_with(report, Verdict::kFailed), ElementsAre("force_sign"))
        << axis << report_text(report);
  }
}

TEST(ValidatorTest, SwappedAxesAreFound) {
  const ValidationReport report = test({.plant = [](BadDevice& device) {
    device.bend_force = [](const Force& force) { return Force{force.y, force.x, force.z}; };
  }});
  EXPECT_THAT(ids_with(report, Verdict::kFailed), ElementsAre("force_sign")) << report_text(report);
}

TEST(ValidatorTest, NoiseIsFound) {
  const ValidationReport report = test({.faults = always(InjectedFault::kNoise, 0.3)});
  EXPECT_THAT(ids_with(report, Verdict::kFailed), ElementsAre("noise")) << report_text(report);
}

TEST(ValidatorTest, AMissingWatchdogIsFound) {
  const ValidationReport report = test({.subject = {.watchdog_ns = 0}});
  EXPECT_THAT(ids_with(report, Verdict::kFailed), ElementsAre("watchdog")) << report_text(report);
}

// Like a HapticMASTER, whose guard switches it off: it must be prepared again.
TEST(ValidatorTest, ADeviceThatIsSwitchedOffWithoutCommandsPasses) {
  ValidationOptions options = quick();
  options.level = 8;
  const ValidationReport report =
      test({.plant = [](BadDevice& device) { device.off_after_ns = 50'000'000; }}, options);
  EXPECT_TRUE(report.passed()) << report_text(report);
  EXPECT_EQ(report.checks.back().id, "watchdog");
  EXPECT_EQ(report.checks.back().verdict, Verdict::kPassed);
  EXPECT_THAT(report_text(report), HasSubstr("it was switched off"));
}

// A device that works after the stall, and fails then, was not switched off meanwhile.
TEST(ValidatorTest, ADeviceThatFailsAfterTheStallIsNotSwitchedOff) {
  ValidationOptions options = quick();
  options.level = 8;
  const auto plant = [](BadDevice& device) {
    device.off_after_ns = 50'000'000;
    device.off_late_ns = 20'000'000;
  };
  const ValidationReport report = test({.plant = plant}, options);
  EXPECT_THAT(ids_with(report, Verdict::kNotPossible), ElementsAre("watchdog"))
      << report_text(report);
  EXPECT_THAT(report_text(report), Not(HasSubstr("it was switched off")));
}

TEST(ValidatorTest, ADeviceThatIgnoresForceIsFound) {
  for (const char* preset : {"premium", "touch", "falcon"}) {
    const ValidationReport report =
        test({.preset = preset, .faults = always(InjectedFault::kForceIgnored)});
    EXPECT_THAT(ids_with(report, Verdict::kFailed), ElementsAre("force_felt"))
        << report_text(report);
  }
}

TEST(ValidatorTest, OneDeadMotorIsFound) {
  const ValidationReport report = test({.plant = [](BadDevice& device) {
    device.bend_force = [](Force force) { return force.y = 0.0, force; };
  }});
  EXPECT_THAT(ids_with(report, Verdict::kFailed), ElementsAre("force_felt")) << report_text(report);
}

TEST(ValidatorTest, JitterIsFound) {
  std::vector<std::int64_t> lateness_ns(50, 0);
  lateness_ns[20] = 2'500'000;
  const ValidationReport report = test({.lateness_ns = lateness_ns});
  EXPECT_THAT(ids_with(report, Verdict::kFailed), ElementsAre("rate")) << report_text(report);
}

TEST(ValidatorTest, ALateForceIsFound) {
  const ValidationReport report =
      test({.plant = [](BadDevice& device) { device.late_ticks = 80; }});
  EXPECT_THAT(ids_with(report, Verdict::kFailed), ::testing::Contains("step"))
      << report_text(report);
}

TEST(ValidatorTest, SamplesThatAreNoNumbersOrOutOfTimeAreFound) {
  EXPECT_THAT(ids_with(test({.faults = always(InjectedFault::kNotFinite)}), Verdict::kFailed),
              ::testing::Contains("places"));
  const ValidationReport frozen = test({.plant = [](BadDevice& device) {
    device.bend_sample = [](PenSample& sample) { sample.time_ns = 7; };
  }});
  EXPECT_THAT(ids_with(frozen, Verdict::kFailed), ::testing::Contains("sample_times"));
}

TEST(ValidatorTest, FiguresThatMakeNoSenseAreFound) {
  const ValidationReport report = test(
      {.plant = [](BadDevice& device) { device.bend_capabilities().continuous_force_n = 99.0; }});
  EXPECT_THAT(ids_with(report, Verdict::kFailed), ElementsAre("capabilities"))
      << report_text(report);
}

/// A user who refuses some of the requested tasks.
class ShyPerson final : public TestPerson {
 public:
  ShyPerson(TestPerson& other, std::vector<PersonTask> refuses)
      : other_(other), refuses_(std::move(refuses)) {}
  bool does(PersonTask task, const std::string& words) override {
    EXPECT_FALSE(words.empty());
    if (std::find(refuses_.begin(), refuses_.end(), task) != refuses_.end()) return false;
    return other_.does(task, words);
  }

 private:
  TestPerson& other_;
  std::vector<PersonTask> refuses_;
};

/// Runs the test with a user who refuses the tasks in `refuses`. Stores the largest force that ever
/// reached the device in `largest_n`, in N.
ValidationReport test_with(std::vector<PersonTask> refuses, double& largest_n,
                           const ValidationOptions& options = quick()) {
  const StylusPreset& preset = *find_stylus_preset("premium");
  SimulatedStylus stylus(preset);
  BadDevice device(stylus);
  device.bend_force = [&largest_n](const Force& force) {
    largest_n = std::max(largest_n, norm(force));
    return force;
  };
  SimulatedSubject subject(device, stylus, descriptor_of(preset));
  ShyPerson person(subject, std::move(refuses));
  VirtualTestLoop loop([&subject](std::int64_t now_ns) { subject.before_tick(now_ns); });
  return validate(subject, loop, person, options);
}

TEST(ValidatorTest, WithoutConsentNoForceAtAll) {
  double largest_n = 0.0;
  const ValidationReport report = test_with({PersonTask::kAgreeToForces}, largest_n);
  EXPECT_EQ(largest_n, 0.0);
  EXPECT_TRUE(report.passed());
  EXPECT_THAT(ids_with(report, Verdict::kNotPossible), ::testing::Contains("force_felt"));
}

TEST(ValidatorTest, NeverMoreThanTheTestsForce) {
  double largest_n = 0.0;
  test_with({}, largest_n);
  EXPECT_GT(largest_n, 0.25);
  EXPECT_LE(largest_n, 0.3 + 1e-9);
}

TEST(ValidatorTest, NobodyToUnplugIt) {
  double largest_n = 0.0;
  const ValidationReport report = test_with({PersonTask::kUnplug}, largest_n);
  EXPECT_THAT(ids_with(report, Verdict::kNotPossible), ElementsAre("unplugging"));
  const ValidationReport left = test_with({PersonTask::kReplug}, largest_n);
  EXPECT_THAT(ids_with(left, Verdict::kNotPossible), ::testing::Contains("unplugging"));
}

TEST(ValidatorTest, InterruptedAtAnyMomentTheForceIsGone) {
  for (int moment = 0; moment < 12'000; moment += 331) {
    const StylusPreset& preset = *find_stylus_preset("premium");
    SimulatedStylus stylus(preset);
    BadDevice device(stylus);
    Force last;
    device.bend_force = [&last](const Force& force) { return last = force; };
    SimulatedSubject subject(device, stylus, descriptor_of(preset));
    VirtualTestLoop loop([&subject](std::int64_t now_ns) { subject.before_tick(now_ns); });
    ValidationOptions options = quick();
    int asked = 0;
    options.is_cancelled = [&asked, moment] { return ++asked > moment; };
    const ValidationReport report = validate(subject, loop, subject, options);
    ASSERT_TRUE(report.was_interrupted) << moment;
    EXPECT_FALSE(report.passed());
    EXPECT_EQ(norm(last), 0.0) << moment;
    EXPECT_EQ(report.checks.size(), 15U);
    EXPECT_THAT(report_text(report), HasSubstr("interrupted"));
  }
}

TEST(ValidatorTest, APenThatRunsAwayLosesItsForce) {
  double largest_n = 0.0;
  const StylusPreset& preset = *find_stylus_preset("premium");
  SimulatedStylus stylus(preset, std::nullopt);  // no hand holds it
  BadDevice device(stylus);
  Vec3 start{}, farthest{};
  bool pushed = false;
  device.bend_force = [&](const Force& force) {
    largest_n = std::max(largest_n, norm(force));
    pushed = pushed || norm(force) > 0.0;
    return force;
  };
  device.bend_sample = [&](PenSample& sample) {
    sample.position.z = 30.0;  // as if the pen did not fall
    if (!pushed) start = sample.position;
    if (norm(sample.position - start) > norm(farthest - start)) farthest = sample.position;
  };
  SimulatedSubject subject(device, stylus, descriptor_of(preset));
  VirtualTestLoop loop([&subject](std::int64_t now_ns) { subject.before_tick(now_ns); });
  ValidationOptions options = quick();
  options.level = 5;
  const ValidationReport report = validate(subject, loop, subject, options);
  EXPECT_THAT(report_text(report), HasSubstr("moved more than 15 mm"));
  EXPECT_GT(largest_n, 0.0);
}

TEST(ValidationReportTest, SaysWhatWasTestedAndWhatCameOfIt) {
  const std::string text = report_text(test({}));
  EXPECT_THAT(text, HasSubstr("Device test: Phantom Premium 1.5\n"));
  EXPECT_THAT(text, HasSubstr("seed     1, levels 1 to 10\n"));
  EXPECT_THAT(text, HasSubstr("15 passed.\n"));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace felt::validator_test
