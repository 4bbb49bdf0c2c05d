#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "felt/rt/device.h"

namespace felt {

/// A fault of a device (docs/design/devices.md#faults).
enum class InjectedFault : std::uint8_t {
  kReadError,      ///< read() returns kDisconnected
  kWriteError,     ///< write() returns kDisconnected; the last force stays in effect
  kUnplugged,      ///< read() and write() return kDisconnected, and no force acts
  kNotFinite,      ///< the position contains a NaN
  kInfinite,       ///< the velocity contains an infinity
  kJump,           ///< the position is shifted by `amount` mm along x
  kFrozen,         ///< every read() returns the same sample with a new time
  kStuckAxis,      ///< z does not change
  kSignFlip,       ///< the position is mirrored in all axes
  kNoise,          ///< uniform noise within +- `amount` mm is added on each axis
  kCoarse,         ///< the position is rounded to steps of `amount` mm
  kTimeBackwards,  ///< samples have a time that is `amount` ms too early
  kForceIgnored,   ///< write() succeeds but has no effect
  kButtonBounce,   ///< button 0 flips at each read
  kForcesOff,      ///< write() returns kForcesOff, and no force acts
  kWarmMotors,     ///< write() returns kOverheated, and no force acts
  kUncalibrated,   ///< read() returns kNotCalibrated: the device lost its reference position
  kButtonStuck,    ///< button 0 is always down
  kDenormal,       ///< z and the velocity are the smallest denormal numbers
  kNoAnswer,       ///< read() repeats the last sample with its old time; writes are lost
  kJumpOften,      ///< every second sample is shifted by `amount` mm along x
  kSlowAnswers,    ///< a service needs `amount` ms for each answer
  kLostAnswers,    ///< a service answers only every second message
  kBurstAnswers,   ///< a service handles all waiting messages every `amount` ms
  kLateAnswer,     ///< a service answers one message `amount` ms late
};

/// Returns true for faults that only a device can have that is used through a service of its maker.
/// FaultyDevice ignores these faults.
constexpr bool is_of_a_service(InjectedFault fault) noexcept {
  return fault >= InjectedFault::kSlowAnswers && fault <= InjectedFault::kLateAnswer;
}

/// Returns all faults, in the order of the enumeration.
std::span<const InjectedFault> injected_faults() noexcept;
/// Returns "read-error" and so on, for reports and command lines.
std::string_view name_of(InjectedFault fault) noexcept;

/// A fault and the time in which it is active.
struct FaultWindow {
  InjectedFault fault = InjectedFault::kReadError;
  std::int64_t from_ns = 0;
  std::int64_t until_ns = 0;  ///< end of the time; not included
  double amount = 1.0;
};

/// Wraps any device and adds faults according to a schedule, to test the code that uses the device.
/// Several faults may be active at the same time; they are applied in the order of the schedule.
/// Deterministic; real-time safe after construction.
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
  PenSample last_;  // the last sample that was returned
};

}  // namespace felt
