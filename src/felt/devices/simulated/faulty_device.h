#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "felt/rt/device.h"

namespace felt {

/// What can go wrong with a device (reliability section 3.5).
enum class InjectedFault : std::uint8_t {
  kReadError,      ///< read() says kDisconnected
  kWriteError,     ///< write() says kDisconnected; the force in effect stays
  kUnplugged,      ///< both, and no force
  kNotFinite,      ///< NaN in the position
  kInfinite,       ///< infinity in the velocity
  kJump,           ///< the position is `amount` mm away, along x
  kFrozen,         ///< the same sample again and again, but its time
  kStuckAxis,      ///< z stays
  kSignFlip,       ///< the position mirrored in all axes
  kNoise,          ///< evenly distributed within +- `amount` mm, on each axis
  kCoarse,         ///< the position in steps of `amount` mm
  kTimeBackwards,  ///< sample times `amount` ms early
  kForceIgnored,   ///< write() says yes and does nothing
  kButtonBounce,   ///< button 0 flips at each read
  kForcesOff,      ///< write() says kForcesOff (its own button, guard, watchdog), and none holds
  kWarmMotors,     ///< write() says kOverheated, and no force holds
  kUncalibrated,   ///< read() says kNotCalibrated: it lost where it is
  kButtonStuck,    ///< button 0 is down, whatever the hand does
  kDenormal,       ///< z and the velocity are the smallest numbers that there are
  kNoAnswer,       ///< nothing new comes: the last sample, with its old time; writes are lost
  kJumpOften,      ///< the position is `amount` mm away, along x, in every second sample
  kSlowAnswers,    ///< a service needs `amount` ms for each answer
  kLostAnswers,    ///< a service answers every second message only
  kBurstAnswers,   ///< a service takes and answers what waits each `amount` ms
  kLateAnswer,     ///< a service answers one message `amount` ms late
};

/// True for faults that only a device behind a service can have. FaultyDevice ignores them.
constexpr bool is_of_a_service(InjectedFault fault) noexcept {
  return fault >= InjectedFault::kSlowAnswers && fault <= InjectedFault::kLateAnswer;
}

/// All of them, in this order.
std::span<const InjectedFault> injected_faults() noexcept;
/// "read-error": for reports and command lines.
std::string_view name_of(InjectedFault fault) noexcept;

/// One fault for some time.
struct FaultWindow {
  InjectedFault fault = InjectedFault::kReadError;
  std::int64_t from_ns = 0;
  std::int64_t until_ns = 0;  ///< not included
  double amount = 1.0;
};

/// A device that fails on schedule, around any other: for tests of everything above. Several faults
/// may act at once; they act in the order of the list. Deterministic; real-time safe after the
/// construction.
class FaultyDevice final : public Device {
 public:
  /// `device` must outlive this.
  FaultyDevice(Device& device, std::vector<FaultWindow> schedule)
      : device_(device), schedule_(std::move(schedule)) {}

  [[nodiscard]] std::string_view name() const noexcept override { return device_.name(); }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return device_.capabilities();
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  std::optional<Vec3> pen_axis() noexcept override { return device_.pen_axis(); }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  void stop() noexcept override { device_.stop(); }

 private:
  [[nodiscard]] const FaultWindow* active(InjectedFault fault) const noexcept;
  void distort(PenSample& sample, const FaultWindow& window) noexcept;

  Device& device_;
  std::vector<FaultWindow> schedule_;
  std::int64_t now_ns_ = 0;
  std::uint64_t reads_ = 0;
  PenSample last_;  // as it was given out
};

}  // namespace felt
