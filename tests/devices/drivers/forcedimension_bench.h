#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tests/devices/drivers/driver_bench.h"
#include "tests/devices/drivers/forcedimension/fake_libdrd.h"

namespace felt {

/// The arm behind a faked device: a simulated stylus, reported in the device's axes and in metres.
class FakeArm final : public fake_dhd::Port {
 public:
  FakeArm(const StylusPreset& preset, std::vector<FaultWindow> faults);

  [[nodiscard]] FakeWorld& world() noexcept { return world_; }
  /// Returns the default plane of the driver, with the middle of the arm's reach in the middle of
  /// the preset's workspace.
  [[nodiscard]] const PlaneCalibration& plane() const noexcept { return plane_; }
  /// Moves the arm up to this time and reads its sample.
  void move_to(std::int64_t now_ns) noexcept;

  [[nodiscard]] std::int64_t now_ns() const noexcept override { return now_ns_; }
  [[nodiscard]] const Sense& sense() const noexcept override { return sense_; }
  int push(const std::array<double, 3>& force_n) noexcept override;
  void release() noexcept override { world_.device().stop(); }

 private:
  FakeWorld world_;
  PlaneCalibration plane_;
  std::int64_t now_ns_ = 0;
  Sense sense_;
};

/// Selects which of the two libraries is faked.
enum class FakeLibrary { kDrd, kDhd };

/// A Force Dimension device behind a fake of the vendor's library.
class ForceDimensionBench final : public DriverBench {
 public:
  /// `model` is a row of device_models(). If `is_opened`, the device is opened and homed; otherwise
  /// it is only plugged in.
  ForceDimensionBench(std::string_view model, std::vector<FaultWindow> faults,
                      const fake_dhd::Model& faked, FakeLibrary library, bool is_opened = true);
  explicit ForceDimensionBench(std::vector<FaultWindow> faults);
  ~ForceDimensionBench() override;

  [[nodiscard]] std::string_view name() const noexcept override { return "forcedimension"; }
  [[nodiscard]] DriverDevice* device() noexcept override { return device_.get(); }
  [[nodiscard]] PlaneCalibration plane() const noexcept override { return arm_->plane(); }
  [[nodiscard]] HandInput& hand() noexcept override { return world().stylus(); }
  [[nodiscard]] FakeWorld& world() noexcept override { return arm_->world(); }
  void before_tick(std::int64_t now_ns) noexcept override;
  [[nodiscard]] bool shows(InjectedFault fault) const noexcept override;
  Result<void> reconnect() override;
  [[nodiscard]] double largest_asked_n() const noexcept override;
  [[nodiscard]] std::string_view broken_rule() const noexcept override;
  [[nodiscard]] double tolerance_mm() const noexcept override;
  [[nodiscard]] PenSample as_said(const PenSample& pen) const noexcept override;
  /// The driver reads the controller's state at every second read.
  [[nodiscard]] std::int64_t notice_ns() const noexcept override;
  [[nodiscard]] std::int64_t watchdog_ns() const noexcept override { return 31'000'000; }
  [[nodiscard]] std::vector<std::string_view> other_models() const override;
  Result<void> reconnect_as(std::string_view model) override;

  // For the tests of this driver.
  [[nodiscard]] Driver& driver() noexcept { return *driver_; }
  [[nodiscard]] fake_dhd::State& state() const noexcept { return fake_->state(number_); }
  [[nodiscard]] fake_dhd::Bench& fake() noexcept { return *fake_; }
  [[nodiscard]] int number() const noexcept { return number_; }
  /// Returns the result of find() for this device.
  [[nodiscard]] DeviceDescriptor found();
  /// Opens the device without homing.
  Result<void> open();
  void close() { device_.reset(); }

 private:
  void plug(std::string_view model, const fake_dhd::Model& faked);
  void unplug();

  std::vector<FaultWindow> faults_;
  fake_dhd::Bench* fake_;
  std::unique_ptr<Driver> driver_;
  std::unique_ptr<FakeArm> arm_;
  int number_ = -1;
  double largest_before_n_ = 0.0;  // of the device that was unplugged
  std::string broken_before_;
  std::unique_ptr<DriverDevice> device_;
};

std::unique_ptr<DriverBench> make_forcedimension_bench(std::vector<FaultWindow> faults);

}  // namespace felt
