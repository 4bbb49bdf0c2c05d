#pragma once

#include <cstdint>
#include <optional>

#include "felt/haptics/capabilities.h"
#include "felt/haptics/force.h"
#include "felt/haptics/safety/safety_guards.h"

namespace felt {

/// Limits the force in a driver's write(), after the safety chain. Whatever the caller requests,
/// the force never exceeds the limits of the device in device_models() and rises by at most
/// kRiseNPerMs.
///
///   const ForceGate::Passed passed = gate_.pass(asked, now_ns);  // the time of the last read()
///   send(passed.force);
///   if (!passed.was_finite) return tl::unexpected(DeviceFault::kBadData);
///
/// The limits of the gate are higher than those of the safety chain. limits_for() derives the
/// chain's limits from the same capabilities, but also applies the user's limit (at most 3 N) and
/// uses only 80 % of the continuous force. A force from a working chain therefore passes exactly
/// unchanged. The gate matters if the driver does something that the chain cannot see, for example
/// if it holds a force because the device answers late, or sends no force for a while.
///
/// Used on the haptic thread; real-time safe. A copy of a ForceGate is a snapshot of its state;
/// assign it back if sending failed.
class ForceGate {
 public:
  /// The highest rate at which the force may rise (docs/safety.md, "rise"). One call of pass()
  /// allows a rise of this rate multiplied by the time since the last call. A time of more than two
  /// periods of the device, or of more than 5 ms, is shortened to the lesser of these two.
  static constexpr double kRiseNPerMs = 0.3;

  /// Sets the limits of a device. A device with an invalid force limit gets no force. If the
  /// continuous force of the device is unknown, only its maximum force is limited.
  explicit ForceGate(const Capabilities& device) noexcept;

  struct Passed {
    Force force;             ///< the force to send
    bool was_finite = true;  ///< false if NaN or infinity was requested; the force is then zero
    bool was_cut = false;    ///< the requested force was larger than allowed, or rose too fast
  };
  /// Returns the force that may be sent at `now_ns`, and assumes that the device holds it until the
  /// next call. If `now_ns` is not later than that of the last call, the force does not rise.
  Passed pass(const Force& asked, std::int64_t now_ns) noexcept;
  /// Records that the driver sent `force` instead of the force that pass() returned last. Requires
  /// that `force` is not larger than the one that pass() returned.
  void sent_less(const Force& force) noexcept { held_ = force; }
  /// Records that the device holds no force, because it was stopped or has stopped by itself.
  void release() noexcept { held_ = {}; }

  /// Returns the force that was last sent to the device.
  [[nodiscard]] const Force& held() const noexcept { return held_; }
  /// Returns the largest force that pass() allows, N: min(advised, 0.9 of the nominal maximum).
  [[nodiscard]] double max_n() const noexcept { return max_n_; }

 private:
  [[nodiscard]] double credit_ms(std::int64_t now_ns) noexcept;
  [[nodiscard]] Force shortened(const Force& asked) const noexcept;

  double max_n_;
  double longest_credit_ms_;
  MotorGuard motors_;
  Force held_;
  std::optional<std::int64_t> held_since_ns_;
};

}  // namespace felt
