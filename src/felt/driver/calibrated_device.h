#pragma once

#include <optional>
#include <string_view>

#include "felt/driver/device_profile.h"
#include "felt/driver/plane_calibration.h"
#include "felt/rt/device.h"

namespace felt {

/// A device whose frame is not that of the sheet: places and velocities are mapped in, forces
/// mapped out by the inverse turn, so that whatever the plane's tilt, +z lifts the pen off it.
/// Pressure, buttons, times and faults pass as they are. A pen whose axis the device knows leans
/// against this plane, whichever way it stands in the room; what a device says of the lean by
/// itself is kept where it says nothing of the axis. Real-time safe as the device within is.
class CalibratedDevice final : public Device {
 public:
  /// `device` must outlive this.
  CalibratedDevice(Device& device, const PlaneCalibration& calibration) noexcept;
  /// As a person has set it: their plane, or `fallback` (Driver::default_plane) where they have
  /// shown none, and their limits.
  CalibratedDevice(Device& device, const DeviceProfile& profile, const PlaneCalibration& fallback);

  [[nodiscard]] std::string_view name() const noexcept override { return device_.name(); }
  /// Of the device; its workspace as it lies in the sheet's frame.
  [[nodiscard]] const Capabilities& capabilities() const noexcept override { return capabilities_; }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  std::optional<PenSample> between() noexcept override;
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  [[nodiscard]] std::optional<Force> held_force() const noexcept override;
  [[nodiscard]] bool is_arm() const noexcept override { return device_.is_arm(); }
  void stop() noexcept override { device_.stop(); }

  [[nodiscard]] const PlaneCalibration& calibration() const noexcept { return calibration_; }

 private:
  void map(PenSample& sample) const noexcept;

  Device& device_;
  PlaneCalibration calibration_;
  Capabilities capabilities_;
};

}  // namespace felt
