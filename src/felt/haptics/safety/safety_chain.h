#pragma once

#include <array>
#include <cstdint>

#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"
#include "felt/haptics/safety/safety_guards.h"
#include "felt/haptics/safety/safety_limits.h"

namespace felt {

/// The state of the chain, which decides which force it sends.
enum class SafetyState : std::uint8_t {
  kOff,       ///< not armed; no force
  kWaiting,   ///< armed; waits until the commanded force has been small for some ticks
  kEngaging,  ///< the force ramps up after kWaiting
  kActive,    ///< forces as commanded, limited
  kSilent,    ///< no heartbeats of the edit thread: damping only
  kFalling,   ///< after a soft fault: the force falls to zero, then kWaiting
  kLatched,   ///< after a hard fault: no force until the user arms again
};

/// Why the chain last reduced or removed the force.
enum class SafetyFault : std::uint8_t {
  kNone,
  kLateTick,       ///< soft
  kTooFast,        ///< soft
  kEditSilent,     ///< soft
  kVeryLateTick,   ///< soft, but the force is zero immediately
  kNotFinite,      ///< hard: NaN or infinity in a sample or a force
  kDeviceError,    ///< hard: the device could not be read or written
  kPositionJump,   ///< hard, if positions do not return in time or jump again and again
  kTooManyFaults,  ///< hard: too many soft faults
  kSelfTest,       ///< hard: invalid limits, or calls in the wrong order
};

/// Which stages limited the force on a tick; bits of SafetyReport::limited_by.
enum SafetyStage : std::uint32_t {
  kLimitedByBudget = 1u << 0,
  kLimitedByRise = 1u << 1,
  kLimitedByPeak = 1u << 2,
  kLimitedByContinuous = 1u << 3,
  kLimitedBySpeed = 1u << 4,
  kLimitedByEngaging = 1u << 5,
};

struct SafetyReport {
  SafetyState state = SafetyState::kOff;
  SafetyFault fault = SafetyFault::kNone;
  std::uint32_t limited_by = 0;
  std::uint32_t soft_faults = 0;  ///< number since the chain was made
  std::uint32_t hard_faults = 0;
  /// RMS of the force: the root of its low-pass filtered square, which follows the heat of the
  /// motors (MotorGuard).
  double rms_force_n = 0.0;
  double energy_mj = 0.0;  ///< work done on the hand since the contact began; passive if <= 0
  /// True while the continuous limit reduces the force, and afterwards until the motors have cooled
  /// (MotorGuard::is_warm()). Programs then show a notice.
  bool motors_are_warm = false;

  friend bool operator==(const SafetyReport&, const SafetyReport&) = default;
};

/// The last stage before a device. For any request of a force model, the output is finite and
/// bounded, rises slowly, and is zero within one tick of a hard fault (R49, R55, R56). Nothing
/// bypasses the chain, because the loop has no other access to a device. The table in
/// docs/safety.md has the numbers.
///
/// One tick, in this order:
///   begin(now)          measures dt; checks the time since the last tick and the heartbeats
///   admit(sample)       returns true if the sample is plausible (false: do not evaluate the model)
///   budget(slopes)      returns the fractions of the model's stiffness that are allowed
///   limit(asked)        applies the stages in order: finite, peak, speed, continuous, engaging or
///                       falling, rise
/// If the device could not be read, call begin(now) and device_failed(); if it could not be
/// written, call device_failed() after limit(). Calling limit() without begin() and admit() before
/// it is a hard fault.
///
/// Engaging: the chain waits until the models ask for less than engage_below_n for some ticks. If
/// the pen is already below the plane when the user arms the chain or a fault ends, the force stays
/// zero until the pen is lifted. The ramp ends when its time has passed and the force has reached
/// the target.
///
/// Call all functions on the haptic thread. They take bounded time, do not allocate or lock, and
/// are deterministic.
class SafetyChain {
 public:
  explicit SafetyChain(const SafetyLimits& limits) noexcept;

  /// Enables forces: changes from kOff or kLatched to kWaiting; has no effect in other states.
  /// Nothing else ends kLatched.
  void arm() noexcept;
  /// Disables forces, for the user's force-off key or at the end. The force is zero immediately.
  /// Changes to kOff, except from kLatched.
  void disarm() noexcept;
  /// Reports that the edit thread was alive at this time. A second call with the same time has no
  /// effect.
  void heartbeat(std::int64_t made_ns) noexcept;

  /// Starts a tick. Returns the measured dt in s, clamped to 0.2..5 ms; the first call returns the
  /// period.
  double begin(std::int64_t now_ns) noexcept;
  /// Reports that the device could not be read or written. This is a hard fault unless forces are
  /// off anyway.
  void device_failed() noexcept;
  /// Returns true if the sample is accepted. If it returns false, do not evaluate the model; pass
  /// any force to limit(), which returns the force to send. In kOff and kLatched every finite
  /// sample is accepted, because it may come from a mouse, which may jump. A sample that repeats
  /// the previous one (repeats()) is accepted but not used: jump and speed are measured from the
  /// last new sample.
  bool admit(const PenSample& sample) noexcept;
  /// Returns the factors by which the bricks must scale their stiffness so that the slopes stay
  /// within the budget; friction is reduced first.
  [[nodiscard]] StiffnessScale budget(const Slopes& slopes) noexcept;
  /// Returns the force to send. Its magnitude is at most limits().peak_force_n.
  Force limit(const Force& asked, const PenSample& sample) noexcept;

  [[nodiscard]] const SafetyReport& report() const noexcept { return report_; }
  [[nodiscard]] const SafetyLimits& limits() const noexcept { return limits_; }

 private:
  enum class Call : std::uint8_t { kNone, kBegun, kBelieved, kHeld };

  void forget_motion() noexcept;
  [[nodiscard]] bool is_armed() const noexcept;
  [[nodiscard]] bool carries_force() const noexcept;
  void go_to(SafetyState state) noexcept;
  void soft_fault(SafetyFault fault, SafetyState next) noexcept;
  void hard_fault(SafetyFault fault) noexcept;
  void watch_lateness() noexcept;
  void watch_silence() noexcept;

  [[nodiscard]] bool wants_damping_only() const noexcept;
  [[nodiscard]] Force damping(const Vec3& velocity_mm_per_s) const noexcept;
  [[nodiscard]] double credit_n(double rate_n_per_ms) const noexcept;
  Force wanted(const Force& asked) noexcept;
  void wait(const Force& asked) noexcept;
  Force engage(const Force& wanted) noexcept;
  Force fall(const Force& wanted) noexcept;
  Force by_state(const Force& wanted) noexcept;
  Force send(const Force& force) noexcept;
  Force clamp(const Force& force, double max_n, SafetyStage stage) noexcept;

  SafetyLimits limits_;
  SafetyReport report_;
  TickClock clock_;
  HeartbeatWatch heartbeats_;
  JumpGuard jumps_;
  SpeedGuard speed_;
  MotorGuard motors_;
  PassivityObserver passivity_;

  TickTime time_;
  Call call_ = Call::kNone;
  PenSample seen_;  // the last finite sample
  bool has_seen_ = false;
  double silence_s_ = 0.0;
  Force sent_;          // the force that the device holds
  int calm_ticks_ = 0;  // ticks in a row with a small commanded force, while kWaiting
  double ramp_ = 0.0;   // progress of the ramp of kEngaging, 0..1
  double credited_s_ =
      0;  // sum of TickTime::credited_s since the start; the time stamps of soft faults use it
  std::array<double, 8> soft_fault_at_s_{};
  std::uint32_t recent_soft_faults_ = 0;
};

}  // namespace felt
