#pragma once

#include <cstdint>
#include <optional>

#include "felt/haptics/capabilities.h"
#include "felt/haptics/force.h"
#include "felt/haptics/safety_motors.h"

namespace felt {

/// The last bound of a driver, in its own write(), behind the safety chain: whatever calls the
/// driver, and however, the device is asked for no more than its model's row allows.
///
///   const ForceGate::Passed passed = gate_.pass(asked, now_ns);      // now of the last read()
///   send(passed.force);
///   if (!passed.was_finite) return tl::unexpected(DeviceFault::kBadData);
///
/// The bounds lie above those of the chain (limits_for takes the same figures, the user's 3 N and
/// 80 % of the continuous force), so that a chain that works never meets them: a force that comes
/// from one passes as it is, to the bit.
///
/// Haptic thread; real-time safe.
class ForceGate {
 public:
  /// Of a device. One that says nonsense about its force gets none; one without a continuous force
  /// has no bound of that kind.
  explicit ForceGate(const Capabilities& device) noexcept;

  struct Passed {
    Force force;             ///< what to send
    bool was_finite = true;  ///< false: NaN or infinity was asked, and the force is zero
    bool was_cut = false;    ///< more was asked than is allowed; the direction is kept
  };
  /// The force that may be sent at `now_ns`, which then is taken as held until the next call. A
  /// clock that stands still or runs backwards counts as no time.
  Passed pass(const Force& asked, std::int64_t now_ns) noexcept;
  /// The device was stopped, or let go by itself: no force holds any more.
  void let_go() noexcept { held_n_ = 0.0; }

  /// No force is ever longer, N: min(advised, 0.9 of the nominal maximum).
  [[nodiscard]] double most_n() const noexcept { return most_n_; }

 private:
  double most_n_;
  MotorGuard motors_;
  double held_n_ = 0.0;
  std::optional<std::int64_t> held_since_ns_;
};

}  // namespace felt
