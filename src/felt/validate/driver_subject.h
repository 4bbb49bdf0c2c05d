#pragma once

#include <memory>
#include <optional>

#include "felt/driver/calibrated_device.h"
#include "felt/driver/device_profile.h"
#include "felt/driver/driver.h"
#include "felt/validate/test_subject.h"

namespace felt {

/// A driver's device under test, seen in the sheet's frame.
class DriverSubject final : public TestSubject {
 public:
  /// `driver` must outlive this. Seen as the profile's plane has it, where a person has shown one
  /// with this very device, whose serial is known once it is open; else with the driver's usual
  /// one.
  DriverSubject(Driver& driver, DeviceDescriptor found, const OpenOptions& options,
                DeviceProfile profile = {});

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
  DeviceProfile profile_;
  std::unique_ptr<DriverDevice> open_;
  std::optional<CalibratedDevice> calibrated_;
};

}  // namespace felt
