// R55: every device fulfils the contract of felt/rt/device.h. Drivers of real devices are connected
// to fake hardware (tests/devices/drivers).
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "felt/base/constants.h"
#include "felt/devices/recorded/recorded_device.h"
#include "felt/devices/simulated/faulty_device.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/driver/open_device.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/rt/null_device.h"
#include "felt/rt/servo.h"
#include "felt/rt/virtual_clock.h"
#include "tests/devices/drivers/bench_device.h"

namespace felt::device_suite_test {
namespace {

// A device under test, and the function that moves its pen.
struct Subject {
  std::unique_ptr<Device> device;
  std::function<void(std::int64_t now_ns)> feed;  // call before each read
  std::string name{};  // the device's name, if it differs from the test parameter
  Vec shift{};         // added to the pen's positions, if the device cannot reach them
  bool is_driver = false;
};

// Returns the pen position for every subject. The pen is first above the surface, then draws a line
// on it.
Vec3 pen_at(std::int64_t now_ns) {
  const double t_s = 1e-9 * static_cast<double>(now_ns);
  const double height = std::clamp(4.0 - 12.0 * (t_s - 0.8), -0.8, 4.0);
  return {20.0 + 10.0 * std::max(0.0, t_s - 1.2), 30.0, height};
}

// A stylus with its hand. The frame of the stylus differs from the frame of the surface.
class LeaningDevice final : public Device {
 public:
  explicit LeaningDevice(const PlaneCalibration& table)
      : stylus_(*find_stylus_preset("touch")), device_(stylus_, table), table_(table) {}

  [[nodiscard]] std::string_view name() const noexcept override { return device_.name(); }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return device_.capabilities();
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    return device_.read(now_ns);
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    return device_.write(force);
  }
  void stop() noexcept override { device_.stop(); }
  void aim(const Vec3& page_mm) noexcept { stylus_.aim(table_.to_device(page_mm), {}, 0); }

 private:
  SimulatedStylus stylus_;
  OpenDevice device_;
  PlaneCalibration table_;
};

// Returns a device that is turned by 90 degrees in front of a table tilted by 25 degrees. The frame
// of the device is right-handed; its y axis is the x axis of the surface.
Subject on_a_leaning_table() {
  const double c = std::cos(0.436), s = std::sin(0.436);
  const PlaneCalibration table =
      *PlaneCalibration::from({Vec3{0, 1, 0}, Vec3{c, 0, s}, Vec3{-s, 0, c}}, {20, -10, 3});
  auto device = std::make_unique<LeaningDevice>(table);
  LeaningDevice* hand = device.get();
  return {std::move(device), [hand](std::int64_t t) { hand->aim(pen_at(t)); }, "touch"};
}

// A driver with its bench.
class DrivenDevice final : public Device {
 public:
  explicit DrivenDevice(std::string_view bench)
      : bench_(make_driver_bench(bench, {})), device_(*bench_) {}

  [[nodiscard]] std::string_view name() const noexcept override { return device_.name(); }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return device_.capabilities();
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    return device_.read(now_ns);
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    return device_.write(force);
  }
  void stop() noexcept override { device_.stop(); }
  HandInput& hand() noexcept { return bench_->hand(); }
  SimulatedStylus& stylus() noexcept { return bench_->world().stylus(); }

 private:
  std::unique_ptr<DriverBench> bench_;
  BenchDevice device_;
};

// Returns the device of a bench. Its pen starts at pen_at(0); all positions are shifted into the
// workspace if the device cannot reach them.
Subject on_a_bench(std::string_view bench) {
  auto device = std::make_unique<DrivenDevice>(bench);
  DrivenDevice* driven = device.get();
  const Capabilities& space = driven->stylus().capabilities();
  const Vec3 low = space.workspace_min, high = space.workspace_max;
  Vec shift;
  if (low.x > 10.0 || high.x < 40.0 || low.y > 20.0 || high.y < 40.0) {
    shift = {0.5 * (low.x + high.x) - 24.0, 0.5 * (low.y + high.y) - 30.0};
  }
  driven->stylus().place(pen_at(0) + Vec3{shift.x, shift.y, 0.0});
  const auto feed = [driven, shift](std::int64_t t) {
    driven->hand().aim(pen_at(t) + Vec3{shift.x, shift.y, 0.0}, {}, 0);
  };
  return {std::move(device), feed, std::string(bench), shift, true};
}

constexpr std::string_view kDriver = "driver-";

Subject make_subject(const std::string& name) {
  if (name.starts_with(kDriver)) return on_a_bench(name.substr(kDriver.size()));
  if (name == "replay") {
    std::vector<PenSample> recording;
    for (std::int64_t ms = 0; ms < 4000; ms += 8) {
      PenSample& sample = recording.emplace_back();
      sample.time_ns = ms * kMs;
      sample.position = pen_at(ms * kMs);
    }
    const Capabilities& touch = find_stylus_preset("touch")->capabilities;
    return {std::make_unique<RecordedDevice>(std::move(recording), touch), [](std::int64_t) {}};
  }
  if (name == "none") {
    auto device = std::make_unique<NullDevice>();
    HandInput* hand = device.get();
    return {std::move(device), [hand](std::int64_t t) { hand->aim(pen_at(t), {}, 0); }};
  }
  if (name == "calibrated") return on_a_leaning_table();
  auto device = std::make_unique<SimulatedStylus>(*find_stylus_preset(name));
  HandInput* hand = device.get();
  return {std::move(device), [hand](std::int64_t t) { hand->aim(pen_at(t), {}, 0); }};
}

std::vector<std::string> subject_names() {
  std::vector<std::string> names{"replay", "none", "calibrated"};
  for (const StylusPreset& preset : stylus_presets()) names.emplace_back(preset.name);
  for (const std::string_view bench : driver_bench_names()) {
    names.push_back(std::string(kDriver).append(bench));
  }
  return names;
}

class DeviceSuite : public ::testing::TestWithParam<std::string> {
 protected:
  Subject subject_ = make_subject(GetParam());
  Device& device_ = *subject_.device;

  PenSample read(std::int64_t now_ns) {
    subject_.feed(now_ns);
    return device_.read(now_ns).value();
  }
};

TEST_P(DeviceSuite, R55_SaysWhatItCanDo) {
  const Capabilities& can = device_.capabilities();
  EXPECT_EQ(device_.name(), subject_.name.empty() ? GetParam() : subject_.name);
  EXPECT_GE(can.sensed_axes, 2);
  EXPECT_LE(can.actuated_axes, can.sensed_axes);
  EXPECT_GE(can.max_force_n, 0.0);
  EXPECT_LE(can.continuous_force_n, can.max_force_n);
  EXPECT_GE(can.period_ns, 200'000);
  EXPECT_LE(can.period_ns, 4'000'000);
  EXPECT_GE(can.delay_ticks, 0);
  EXPECT_LT(can.workspace_min.x, can.workspace_max.x);
  EXPECT_LT(can.workspace_min.y, can.workspace_max.y);
  if (can.sensed_axes > 2) {
    EXPECT_LT(can.workspace_min.z, can.workspace_max.z);
  } else {
    EXPECT_LE(can.workspace_min.z, can.workspace_max.z);
  }
}

TEST_P(DeviceSuite, R55_SamplesAreOfTheTimeThatIsAskedForAndFinite) {
  for (std::int64_t ms = 0; ms < 2000; ++ms) {
    const PenSample s = read(ms * kMs);
    ASSERT_EQ(s.time_ns, ms * kMs);
    ASSERT_TRUE(is_finite(s.position) && is_finite(s.velocity));
    ASSERT_TRUE(device_.write({0, 0, 1e-3 * depth_mm(s) * 300.0}).has_value());
  }
  EXPECT_NEAR(read(2000 * kMs).position.x - subject_.shift.x, pen_at(2000 * kMs).x, 3.0);
}

TEST_P(DeviceSuite, R55_GapsAndClocksThatRunBackwardsAreSurvived) {
  std::int64_t now_ns = 0;
  for (const std::int64_t gap : {1, 1, 29, 1, 10'000, 0, 1, -500, 1, 3'600'000, 1}) {
    now_ns += gap * kMs;
    const PenSample s = read(now_ns);
    EXPECT_TRUE(is_finite(s.position) && is_finite(s.velocity)) << "after " << gap << " ms";
    // A real device's watchdog may have released the motors in the gap; then write() may fail.
    ASSERT_TRUE(device_.write({}).has_value() || subject_.is_driver);
  }
}

TEST_P(DeviceSuite, R55_TakesAnyForceWithoutHarm) {
  read(0);
  std::int64_t now_ns = 0;
  for (const double f : {0.0, 1.0, -1.0, 1e9, -1e300, kNan, std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::denorm_min()}) {
    (void)device_.write({f, -f, f});  // may fail, but must not harm the device
    now_ns += kMs;
    const PenSample s = read(now_ns);
    EXPECT_TRUE(is_finite(s.position) && is_finite(s.velocity)) << f;
  }
  device_.stop();
  device_.stop();
  EXPECT_TRUE(is_finite(read(now_ns + kMs).position));
}

TEST_P(DeviceSuite, R55_TheSameCallsGiveTheSameSamples) {
  Subject other = make_subject(GetParam());
  for (std::int64_t ms = 0; ms < 1500; ++ms) {
    const PenSample a = read(ms * kMs);
    other.feed(ms * kMs);
    ASSERT_EQ(a, other.device->read(ms * kMs).value());
    const Force force{0, 0, 0.3 * depth_mm(a)};
    ASSERT_TRUE(device_.write(force).has_value());
    ASSERT_TRUE(other.device->write(force).has_value());
  }
}

// Surface, well and spring together, through the loop. The force stays within the limits of device
// and user, and the stiffness within 0.9 of the device's maximum.
TEST_P(DeviceSuite, R55_TheLoopKeepsToItsCapabilities) {
  const Capabilities& can = device_.capabilities();
  const auto servo = std::make_unique<Servo>(
      device_, ServoOptions{.period_ns = can.period_ns, .limits = limits_for(can)});
  const SurfaceMaterial& board = *find_surface("blackboard");
  const Point here = Point{20, 30} + subject_.shift;
  servo->publish(ForceModel(
      Compose(make_surface_force(board, media()[0], can), SnapWells(here), EditSpring(here))));
  servo->arm();
  VirtualClock clock(*servo);
  double max_n = 0.0, steepest = 0.0;
  while (clock.next_ns() < 2500 * kMs) {
    subject_.feed(clock.next_ns());
    const TickReport& tick = clock.tick();
    EXPECT_EQ(tick.safety.hard_faults, 0u);
    max_n = std::max(max_n, norm(tick.sent));
    const double depth = depth_mm(tick.sample);
    if (depth > 0.2 && std::fabs(tick.sample.velocity.z) < 0.5 && tick.terms.size() > 0) {
      steepest = std::max(steepest, 1e3 * tick.terms[0].force.z / depth);
    }
  }
  EXPECT_LE(max_n, std::min(3.0, 0.9 * can.max_force_n) + 1e-9);
  // A planar device cannot render the surface, and its depth only says whether the pen touches.
  if (can.max_stiffness_n_per_m > 0.0 && can.actuated_axes > 2) {
    EXPECT_LE(steepest, 0.9 * can.max_stiffness_n_per_m * 1.05 + 5.0);
  }
  if (can.has_force() && GetParam() != "replay") {
    EXPECT_GT(max_n, 0.05) << "it did push";
  }
  if (!can.has_force()) {
    EXPECT_EQ(max_n, 0.0);
  }
}

// Any failure of a device is detected, and no force remains.
TEST_P(DeviceSuite, R49_FailingTakesTheForceAway) {
  for (const InjectedFault fault : {InjectedFault::kReadError, InjectedFault::kUnplugged,
                                    InjectedFault::kNotFinite, InjectedFault::kInfinite}) {
    Subject subject = make_subject(GetParam());
    FaultyDevice device(*subject.device, {{fault, 1800 * kMs, 1820 * kMs, 1.0}});
    const Capabilities& can = device.capabilities();
    const auto servo = std::make_unique<Servo>(
        device, ServoOptions{.period_ns = can.period_ns, .limits = limits_for(can)});
    servo->publish(ForceModel(make_surface_force(surface_materials()[0], media()[0], can)));
    servo->arm();
    VirtualClock clock(*servo);
    while (clock.next_ns() < 2200 * kMs) {
      subject.feed(clock.next_ns());
      const TickReport& tick = clock.tick();
      if (clock.now_ns() < 1800 * kMs) continue;
      ASSERT_EQ(tick.sent, Force{}) << "fault " << static_cast<int>(fault);
      // The chain is never armed if the device has no force.
      ASSERT_EQ(tick.safety.state, can.has_force() ? SafetyState::kLatched : SafetyState::kOff);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, DeviceSuite, ::testing::ValuesIn(subject_names()),
                         [](const auto& device) {
                           std::string name = device.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace felt::device_suite_test
