#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "felt/driver/device_models.h"
#include "felt/driver/driver.h"

namespace felt {

/// The state of an arm that a test controls: whether it is plugged in, its position and its faults.
/// Of these members, ScriptedDriver::find() reads only `is_plugged_in` and `descriptor`.
struct ScriptedArm {
  ScriptedArm() {
    descriptor.id = "scripted:1";
    descriptor.driver = "scripted";
    descriptor.label = "Scripted arm";
    descriptor.serial = "S1";
    descriptor.capabilities = find_device_model("touch")->capabilities;
  }

  DeviceDescriptor descriptor;
  std::atomic<bool> is_plugged_in{true};
  Homing homing = Homing::kNone;
  bool home_is_found = true;  ///< find_home() succeeds
  std::string open_error = {};
  PenSample at = {};  ///< in the device's frame
  std::optional<DeviceFault> read_fault = {};
  std::optional<DeviceFault> write_fault = {};  ///< only for forces that are not zero
  std::string vendor_words = {};
  std::string notice = {};
  int opened = 0, closed = 0, homed = 0;
  OpenOptions options = {};
  Force sent = {};
  double largest_n = 0.0;
  std::vector<Finding> findings = {};
};

/// A driver whose only device is a ScriptedArm.
class ScriptedDriver final : public Driver {
 public:
  explicit ScriptedDriver(std::shared_ptr<ScriptedArm> arm) : arm_(std::move(arm)) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "scripted"; }
  [[nodiscard]] std::string_view label() const noexcept override { return "Scripted arms"; }
  std::vector<DeviceDescriptor> find() override {
    if (!arm_->is_plugged_in) return {};
    return {arm_->descriptor};
  }
  Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor&,
                                             const OpenOptions& options) override {
    if (!arm_->open_error.empty()) return fail(ErrorCode::kIo, arm_->open_error);
    arm_->options = options;
    return std::make_unique<Arm>(arm_);
  }
  std::vector<Finding> diagnose(const SystemView&) override { return arm_->findings; }

 private:
  class Arm final : public DriverDevice {
   public:
    explicit Arm(std::shared_ptr<ScriptedArm> arm)
        : arm_(std::move(arm)), descriptor_(arm_->descriptor) {
      ++arm_->opened;
    }
    Arm(const Arm&) = delete;
    Arm& operator=(const Arm&) = delete;
    ~Arm() override { ++arm_->closed; }

    [[nodiscard]] std::string_view name() const noexcept override { return descriptor_.id; }
    [[nodiscard]] const Capabilities& capabilities() const noexcept override {
      return descriptor_.capabilities;
    }
    tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
      if (!arm_->is_plugged_in) return failed(DeviceFault::kDisconnected);
      if (arm_->homing != Homing::kNone) return failed(DeviceFault::kNotCalibrated);
      if (arm_->read_fault) return failed(*arm_->read_fault);
      if (!arm_->write_fault) status_.fault.reset();
      ++status_.reads;
      PenSample sample = arm_->at;
      sample.time_ns = now_ns;
      return sample;
    }
    tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
      if (norm(force) > 0.0 && arm_->write_fault) return failed(*arm_->write_fault);
      arm_->sent = force;
      arm_->largest_n = std::max(arm_->largest_n, norm(force));
      return {};
    }
    void stop() noexcept override { arm_->sent = {}; }
    [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override {
      return descriptor_;
    }
    [[nodiscard]] DeviceStatus status() noexcept override {
      status_.notice = ShortText(arm_->notice);
      return status_;
    }
    [[nodiscard]] Homing homing() noexcept override { return arm_->homing; }
    [[nodiscard]] std::string homing_words() override { return "It has a little brass hole."; }
    Result<void> find_home() override {
      ++arm_->homed;
      if (!arm_->home_is_found) return fail(ErrorCode::kIo, "error 7: axis 2 is blocked");
      arm_->homing = Homing::kNone;
      return {};
    }

   private:
    tl::unexpected<DeviceFault> failed(DeviceFault fault) noexcept {
      if (status_.fault != fault) ++status_.faults;
      status_.fault = status_.last_fault = fault;
      status_.vendor_words = ShortText(arm_->vendor_words);
      status_.vendor_code = 7;
      return tl::unexpected(fault);
    }

    std::shared_ptr<ScriptedArm> arm_;
    DeviceDescriptor descriptor_;
    DeviceStatus status_;
  };

  std::shared_ptr<ScriptedArm> arm_;
};

}  // namespace felt
