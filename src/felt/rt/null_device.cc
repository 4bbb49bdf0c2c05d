#include "felt/rt/null_device.h"

namespace felt {

NullDevice::NullDevice(const Capabilities& capabilities) noexcept : capabilities_(capabilities) {
  capabilities_.actuated_axes = 0;
  capabilities_.max_force_n = 0.0;
  capabilities_.continuous_force_n = 0.0;
}

tl::expected<PenSample, DeviceFault> NullDevice::read(std::int64_t now_ns) noexcept {
  aimed_.update();
  const Pose& pose = aimed_.get();
  const double dt_s = last_ns_ ? 1e-9 * static_cast<double>(now_ns - *last_ns_) : 0.0;
  last_ns_ = now_ns;
  return PenSample{now_ns, pose.position, velocity_.update(pose.position, dt_s), pose.pressure,
                   pose.buttons};
}

void NullDevice::aim(const Vec3& target_mm, std::optional<double> pressure,
                     std::uint32_t buttons) noexcept {
  aimed_.publish({target_mm, pressure, buttons});
}

}  // namespace felt
