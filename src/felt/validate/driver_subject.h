#pragma once

#include <memory>
#include <optional>

#include "felt/driver/calibrated_device.h"
#include "felt/driver/driver.h"
#include "felt/validate/test_subject.h"

namespace felt {

/// A driver's device under test, seen in the sheet's frame.
class DriverSubject final : public TestSubject {
 public:
  /// `driver` must outlive this. Without a plane that a person has shown, the driver's usual one.
  DriverSubject(Driver& driver, DeviceDescriptor found, const OpenOptions& options,
                const std::optional<PlaneCalibration>& plane);

  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override;
  Result<void> open() override;
  void close() noexcept override;
  [[nodiscard]] Device* device() noexcept override;
  [[nodiscard]] LoopHost* loop_host() noexcept override;
  [[nodiscard]] Homing homing() noexcept override;
  [[nodiscard]] std::string homing_words() override;
  Result<void> find_home() override;
  bool is_connected() override;
  [[nodiscard]] std::string vendor_words() override;

 private:
  Driver& driver_;
  DeviceDescriptor found_;
  bool was_seen_;  // find() can tell whether it is connected
  OpenOptions options_;
  std::optional<PlaneCalibration> plane_;
  std::unique_ptr<DriverDevice> open_;
  std::optional<CalibratedDevice> calibrated_;
};

}  // namespace felt
