#include "felt/devices/calibrated/calibrated_device.h"

namespace felt {

CalibratedDevice::CalibratedDevice(Device& device, const PlaneCalibration& calibration) noexcept
    : device_(device),
      calibration_(calibration),
      capabilities_(calibration.to_sheet(device.capabilities())) {}

tl::expected<PenSample, DeviceFault> CalibratedDevice::read(std::int64_t now_ns) noexcept {
  tl::expected<PenSample, DeviceFault> sample = device_.read(now_ns);
  if (!sample) return sample;
  sample->position = calibration_.to_sheet(sample->position);
  sample->velocity = calibration_.turn_to_sheet(sample->velocity);
  return sample;
}

tl::expected<void, DeviceFault> CalibratedDevice::write(const Force& force) noexcept {
  return device_.write(calibration_.turn_to_device(force));
}

}  // namespace felt
