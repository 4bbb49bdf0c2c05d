#pragma once

#include <cstdint>
#include <optional>

#include "felt/haptics/capabilities.h"
#include "felt/haptics/force.h"
#include "felt/haptics/safety/safety_guards.h"

namespace felt {

/// The last bound of a driver, in its own write(), behind the safety chain: whatever calls the
/// driver, and whenever, the device is asked for no more than its model's row allows, and the force
/// rises by at most kRiseNPerMs.
///
///   const ForceGate::Passed passed = gate_.pass(asked, now_ns);      // now of the last read()
///   send(passed.force);
///   if (!passed.was_finite) return tl::unexpected(DeviceFault::kBadData);
///
/// The bounds lie above those of the chain (limits_for takes the same figures, the user's 3 N and
/// 80 % of the continuous force), so that a chain that works never meets them: a force that comes
/// from one passes as it is, to the bit. They bind when the driver does what the chain cannot see:
/// it holds a force because the other side answers late, or sends none for a while.
///
/// Haptic thread; real-time safe. A copy is a snapshot: assign it back when sending failed.
class ForceGate {
 public:
  /// Of docs/safety.md, "rise". A call is credited with the time since the last one, two periods of
  /// the device at most.
  static constexpr double kRiseNPerMs = 0.3;

  /// Of a device. One that says nonsense about its force gets none; one without a continuous force
  /// has no bound of that kind.
  explicit ForceGate(const Capabilities& device) noexcept;

  struct Passed {
    Force force;             ///< what to send
    bool was_finite = true;  ///< false: NaN or infinity was asked, and the force is zero
    bool was_cut = false;    ///< more was asked than is allowed, or it rose too fast
  };
  /// The force that may be sent at `now_ns`, which then is taken as held until the next call. A
  /// clock that stands still or runs backwards counts as no time.
  Passed pass(const Force& asked, std::int64_t now_ns) noexcept;
  /// The driver sent this instead of what pass() returned last. Requires that it is no longer.
  void sent_less(const Force& force) noexcept { held_ = force; }
  /// The device was stopped, or let go by itself: no force holds any more.
  void let_go() noexcept { held_ = {}; }

  /// The force that the device was last told to hold.
  [[nodiscard]] const Force& held() const noexcept { return held_; }
  /// No force is ever longer, N: min(advised, 0.9 of the nominal maximum).
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
