#include "felt/rt/null_device.h"

namespace felt {

NullDevice::NullDevice(const Capabilities& capabilities) noexcept : capabilities_(capabilities) {
  capabilities_.actuated_axes = 0;
  capabilities_.max_force_n = 0.0;
  capabilities_.continuous_force_n = 0.0;
}

tl::expected<PenSample, DeviceFault> NullDevice::read(std::int64_t now_ns) noexcept {
  aimed_.update();
  const Aim& pose = aimed_.get();
  const double dt_s = last_ns_ ? 1e-9 * static_cast<double>(now_ns - *last_ns_) : 0.0;
  last_ns_ = now_ns;
  return PenSample{now_ns,        pose.target_mm, velocity_.update(pose.target_mm, dt_s),
                   pose.pressure, pose.buttons,   pose.tilt_deg};
}

}  // namespace felt
