#include "felt/driver/calibrated_device.h"

#include "felt/geometry/lean.h"

namespace felt {

CalibratedDevice::CalibratedDevice(Device& device, const PlaneCalibration& calibration) noexcept
    : device_(device),
      calibration_(calibration),
      capabilities_(calibration.to_sheet(device.capabilities())) {}

CalibratedDevice::CalibratedDevice(Device& device, const DeviceProfile& profile,
                                   const PlaneCalibration& fallback)
    : device_(device),
      calibration_(profile.plane.value_or(fallback)),
      capabilities_(calibration_.to_sheet(limited_by(profile, device.capabilities()))) {}

void CalibratedDevice::map(PenSample& sample) const noexcept {
  sample.position = calibration_.to_sheet(sample.position);
  sample.velocity = calibration_.turn_to_sheet(sample.velocity);
}

tl::expected<PenSample, DeviceFault> CalibratedDevice::read(std::int64_t now_ns) noexcept {
  tl::expected<PenSample, DeviceFault> sample = device_.read(now_ns);
  if (!sample) return sample;
  map(*sample);
  if (const std::optional<Vec3> axis = device_.pen_axis()) {
    sample->lean_deg = lean_of_axis(calibration_.turn_to_sheet(*axis));
  }
  return sample;
}

std::optional<PenSample> CalibratedDevice::between() noexcept {
  std::optional<PenSample> sample = device_.between();
  if (sample) map(*sample);
  return sample;
}

tl::expected<void, DeviceFault> CalibratedDevice::write(const Force& force) noexcept {
  return device_.write(calibration_.turn_to_device(force));
}

std::optional<Force> CalibratedDevice::held_force() const noexcept {
  std::optional<Force> held = device_.held_force();
  if (held) held = calibration_.turn_to_sheet(*held);
  return held;
}

}  // namespace felt
