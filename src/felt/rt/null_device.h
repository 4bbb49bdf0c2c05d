#pragma once

#include <optional>
#include <string_view>

#include "felt/haptics/pen_sample.h"
#include "felt/rt/device.h"
#include "felt/rt/latest_value.h"

namespace felt {

/// No device at all: the pen is where a mouse, a tablet or a script says, and forces are ignored
/// (R51, R55). Drawing with it gives the same document as with forces off.
///
/// aim() comes from the edit thread, everything else from the haptic thread.
class NullDevice final : public Device, public HandInput {
 public:
  /// `capabilities` says workspace and period; it never has forces, whatever stands there.
  explicit NullDevice(const Capabilities& capabilities = {}) noexcept;

  [[nodiscard]] std::string_view name() const noexcept override { return "none"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override { return capabilities_; }
  /// The pose aimed at last; before the first, 10 mm above the origin.
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
