#pragma once

#include <cstdint>
#include <optional>

#include "felt/haptics/capabilities.h"
#include "felt/haptics/force.h"
#include "felt/haptics/safety/safety_guards.h"

namespace felt {

/// The last limit of a force, in a driver's write(), behind the safety chain. It does not depend on
/// the caller: the force never exceeds the limits of the device in device_models(), and rises by at
/// most kRiseNPerMs.
///
///   const ForceGate::Passed passed = gate_.pass(asked, now_ns);      // now of the last read()
///   send(passed.force);
///   if (!passed.was_finite) return tl::unexpected(DeviceFault::kBadData);
///
/// The limits are above those of the chain (limits_for uses the same figures, the user's 3 N and 80
/// % of the continuous force), so a force from a working chain passes unchanged, to the bit. They
/// have an effect if the driver does something that the chain cannot see: if it holds a force
/// because the peer answers late, or does not send a force for a while.
///
/// Used on the haptic thread; real-time safe. A copy of a ForceGate is a snapshot of its state;
/// assign it back if sending failed.
class ForceGate {
 public:
  /// The largest rise (docs/safety.md, "rise"). A call may use the time since the last call, at
  /// most two periods of the device.
  static constexpr double kRiseNPerMs = 0.3;

  /// Sets the limits of a device. A device with an invalid force limit gets no force; one without a
  /// continuous force has no limit of that kind.
  explicit ForceGate(const Capabilities& device) noexcept;

  struct Passed {
    Force force;             ///< the force to send
    bool was_finite = true;  ///< false if NaN or infinity was requested; the force is then zero
    bool was_cut = false;    ///< the requested force was larger than allowed, or rose too fast
  };
  /// Returns the force that may be sent at `now_ns`, and assumes that it is held until the next
  /// call. If the clock stands still or goes back, no time is counted.
  Passed pass(const Force& asked, std::int64_t now_ns) noexcept;
  /// Sets the force that was sent instead of the one that pass() returned last. Requires that it is
  /// not larger.
  void sent_less(const Force& force) noexcept { held_ = force; }
  /// Records that the device holds no force, because it was stopped or has stopped by itself.
  void let_go() noexcept { held_ = {}; }

  /// Returns the force that was last sent to the device.
  [[nodiscard]] const Force& held() const noexcept { return held_; }
  /// Returns the largest force that pass() allows, N: min(advised, 0.9 of the nominal maximum).
  [[nodiscard]] double most_n() const noexcept { return most_n_; }

 private:
  [[nodiscard]] double credit_ms(std::int64_t now_ns) noexcept;
  [[nodiscard]] Force shortened(const Force& asked) const noexcept;

  double most_n_;
  double longest_credit_ms_;
  MotorGuard motors_;
  Force held_;
  std::optional<std::int64_t> held_since_ns_;
};

}  // namespace felt
