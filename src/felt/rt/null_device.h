#pragma once

#include <optional>
#include <string_view>

#include "felt/haptics/pen_sample.h"
#include "felt/rt/device.h"
#include "felt/rt/latest_value.h"

namespace felt {

/// A device without hardware: a mouse, a tablet or a script sets the position of the pen, and
/// forces are ignored (R51, R55). Drawing with it gives the same document as drawing with forces
/// off.
///
/// Call aim() on the edit thread and everything else on the haptic thread.
class NullDevice final : public Device, public HandInput {
 public:
  /// Uses the workspace and period of `capabilities`; the forces in it are ignored and set to 0.
  explicit NullDevice(const Capabilities& capabilities = {}) noexcept;

  [[nodiscard]] std::string_view name() const noexcept override { return "none"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override { return capabilities_; }
  /// Returns the pose of the last aim(). Before the first aim() the pen is 10 mm above the origin.
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  tl::expected<void, DeviceFault> write(const Force&) noexcept override { return {}; }
  void stop() noexcept override {}

  using HandInput::aim;
  void aim(const Aim& aim) noexcept override { aimed_.publish(aim); }

 private:
  Capabilities capabilities_;
  LatestValue<Aim> aimed_{Aim{{0.0, 0.0, 10.0}}};
  VelocityFilter velocity_;
  std::optional<std::int64_t> last_ns_;
};

}  // namespace felt
