#pragma once

#include <cstdint>
#include <string_view>

#include "felt/haptics/velocity_filter.h"
#include "felt/rt/device.h"
#include "felt/session/pose_track.h"

namespace felt {

/// A device under a script: while hand events rule, the hand of the device below is told where to
/// go, and the device does the rest; while pen events rule, the pen is where the script says, and
/// forces do not move it. Velocities of the latter are made as drivers make them.
///
///   scripted.set(track.at(now_ns));
///   servo.step(now_ns);                // calls read() and write()
class ScriptedDevice final : public Device {
 public:
  /// Both must outlive this; `hand` may be null where the script has no hand events.
  ScriptedDevice(Device& below, HandInput* hand) noexcept : below_(below), hand_(hand) {}

  void set(const ScriptPose& pose) noexcept {
    pose_ = pose;
    if (pose_.by_hand)
      hand_->aim(Aim{pose_.position, pose_.pressure, pose_.buttons, pose_.lean_deg});
  }
  [[nodiscard]] bool by_hand() const noexcept { return pose_.by_hand; }

  [[nodiscard]] std::string_view name() const noexcept override { return below_.name(); }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return below_.capabilities();
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    if (pose_.by_hand) return below_.read(now_ns);
    const double dt_s = 1e-9 * static_cast<double>(now_ns - last_ns_);
    last_ns_ = now_ns;
    const Vec3 velocity = velocity_.update(pose_.position, dt_s);
    return PenSample{now_ns,         pose_.position, velocity,
                     pose_.pressure, pose_.buttons,  pose_.lean_deg};
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    if (pose_.by_hand) return below_.write(force);
    return {};
  }
  void stop() noexcept override { below_.stop(); }

 private:
  Device& below_;
  HandInput* hand_;
  ScriptPose pose_;
  VelocityFilter velocity_;
  std::int64_t last_ns_ = 0;
};

}  // namespace felt
