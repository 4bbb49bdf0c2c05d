#pragma once

#include <optional>
#include <string_view>

#include "felt/haptics/velocity_filter.h"
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

  void aim(const Vec3& target_mm, std::optional<double> pressure,
           std::uint32_t buttons) noexcept override;

 private:
  struct Pose {
    Vec3 position{0.0, 0.0, 10.0};
    std::optional<double> pressure;
    std::uint32_t buttons = 0;
  };

  Capabilities capabilities_;
  LatestValue<Pose> aimed_;
  VelocityFilter velocity_;
  std::optional<std::int64_t> last_ns_;
};

}  // namespace felt
