#pragma once

#include <array>
#include <cstdint>

#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"
#include "felt/haptics/safety/safety_guards.h"
#include "felt/haptics/safety/safety_limits.h"

namespace felt {

/// What the chain lets through at present.
enum class SafetyState : std::uint8_t {
  kOff,       ///< not armed: no force
  kWaiting,   ///< armed; waits until the commanded force has been small for some ticks
  kEngaging,  ///< the ramp after that
  kActive,    ///< forces as commanded, limited
  kSilent,    ///< the edit side says nothing: damping only
  kFalling,   ///< a soft fault: the force falls to zero, then it waits again
  kLatched,   ///< a hard fault: no force until the user arms again
};

/// Why the chain last took force away.
enum class SafetyFault : std::uint8_t {
  kNone,
  kLateTick,       ///< soft
  kTooFast,        ///< soft
  kEditSilent,     ///< soft
  kVeryLateTick,   ///< soft, zero at once
  kNotFinite,      ///< hard: NaN or infinity in a sample or a force
  kDeviceError,    ///< hard: the device could not be read or written
  kPositionJump,   ///< hard, once it lasts
  kTooManyFaults,  ///< hard: soft ones too often
  kSelfTest,       ///< hard: the chain's own numbers or the order of its calls make no sense
};

/// What limited the force on a tick; bits of SafetyReport::limited_by.
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
  std::uint32_t soft_faults = 0;  ///< since the start
  std::uint32_t hard_faults = 0;
  double rms_force_n = 0.0;      ///< as the motors feel it (MotorGuard)
  double energy_mj = 0.0;        ///< work done on the hand since the contact began; <= 0 is passive
  bool motors_are_warm = false;  ///< notice: forces are or were lately limited by the motors

  friend bool operator==(const SafetyReport&, const SafetyReport&) = default;
};

/// The last stage before a device: whatever a force model asks for, what leaves here is finite,
/// bounded, rises slowly, and is zero within one tick of a hard fault (R49, R55, R56). Nothing
/// bypasses it: the loop has no other way to a device. The table of docs/safety.md has the numbers.
///
/// One tick, in this order:
///   begin(now)          measured dt; is the tick late, is the edit side alive?
///   admit(sample)       is the sample believable? (false: evaluate no model)
///   budget(slopes)      how much of its stiffness the model may use
///   limit(asked)        the stages, in order: finite, peak, speed, continuous, engaging or
///                       falling, rise
/// or, when the device failed, begin(now) and device_failed(); the latter also after limit(), when
/// writing failed. limit() without begin() and admit() before it is a hard fault.
///
/// Engaging: the chain waits until the models ask for less than engage_below_n for some ticks. A
/// pen that already presses into the plane when the user arms, or after a fault, therefore feels
/// nothing until it is lifted. The ramp ends when its time is over and the force has caught up.
///
/// Haptic thread, except where noted: bounded, no allocation, no lock. Deterministic.
class SafetyChain {
 public:
  explicit SafetyChain(const SafetyLimits& limits) noexcept;

  /// The user allows forces: from kOff and kLatched to kWaiting. Nothing else leaves kLatched; no
  /// effect elsewhere.
  void arm() noexcept;
  /// The user's force-off key, or the end: zero at once, kOff (kLatched stays).
  void disarm() noexcept;
  /// The edit side was alive at this time. The same time again is not news.
  void heartbeat(std::int64_t made_ns) noexcept;

  /// Starts a tick; returns the measured dt in s, clamped to 0.2..5 ms. The first one returns the
  /// period.
  double begin(std::int64_t now_ns) noexcept;
  /// The device could not be read or written: a hard fault, unless forces are off anyway.
  void device_failed() noexcept;
  /// True when the sample can be believed. Otherwise the model must not be asked; limit() with any
  /// force gives what is to be sent. While no force can flow, every finite sample is believed: a
  /// mouse may leap. A sample that repeats the last one (repeats()) is believed and judges nothing:
  /// jump and speed are measured from the last new sample.
  bool admit(const PenSample& sample) noexcept;
  /// Scales for the bricks such that the slopes keep to the budget: friction gives way first.
  [[nodiscard]] StiffnessScale budget(const Slopes& slopes) noexcept;
  /// The force to send: at most limits().peak_force_n long.
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
  PenSample seen_;  // the last finite one
  bool has_seen_ = false;
  double silence_s_ = 0.0;
  Force sent_;             // what the device holds
  int calm_ticks_ = 0;     // in kWaiting
  double ramp_ = 0.0;      // in kEngaging, 0..1
  double credited_s_ = 0;  // since the start, of credited time: soft faults are dated with it
  std::array<double, 8> soft_fault_at_s_{};
  std::uint32_t recent_soft_faults_ = 0;
};

}  // namespace felt
