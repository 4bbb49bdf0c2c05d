#pragma once

#include <array>
#include <cstdint>

#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"
#include "felt/haptics/safety_limits.h"

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
  kSelfTest,       ///< hard: the chain's own numbers make no sense
};

/// What limited the force on a tick; bits of SafetyReport::limited_by.
enum SafetyStage : std::uint32_t {
  kLimitedByBudget = 1u << 0,
  kLimitedByRise = 1u << 1,
  kLimitedByPeak = 1u << 2,
  kLimitedByContinuous = 1u << 3,
  kLimitedBySpeed = 1u << 4,
  kLimitedByEngaging = 1u << 5,
  kLimitedByPassivity = 1u << 6,
};

struct SafetyReport {
  SafetyState state = SafetyState::kOff;
  SafetyFault fault = SafetyFault::kNone;
  std::uint32_t limited_by = 0;
  std::uint32_t soft_faults = 0;  ///< since the start
  std::uint32_t hard_faults = 0;
  double rms_force_n = 0.0;  ///< over the window
  double energy_mj = 0.0;    ///< work done on the hand since the contact began; <= 0 is passive

  friend bool operator==(const SafetyReport&, const SafetyReport&) = default;
};

/// The last stage before a device: whatever a force model asks for, what leaves here is finite,
/// bounded, rises slowly, and is zero within one tick of a hard fault (R49, R55, R56). Nothing
/// bypasses it: the loop has no other way to a device.
///
/// One tick, in this order:
///   begin(now)          measured dt; is the tick late, is the edit side alive?
///   admit(sample)       is the sample believable? (false: evaluate no model)
///   budget(slopes)      how much of its stiffness the model may use
///   limit(asked)        the stages, in order: finite, passivity, peak, continuous, speed,
///                       engaging or falling, rise
/// or, when the device failed, begin(now) and device_failed().
///
/// Haptic thread, except where noted: bounded, no allocation, no lock. Deterministic.
class SafetyChain {
 public:
  explicit SafetyChain(const SafetyLimits& limits) noexcept;

  /// The user allows forces: from kOff and kLatched to kWaiting. Nothing else leaves kLatched.
  void arm() noexcept;
  /// The user's force-off key, or the end: zero at once, kOff.
  void disarm() noexcept;
  /// The edit side is alive at this time.
  void heartbeat(std::int64_t now_ns) noexcept;

  /// Starts a tick; returns the measured dt in s, clamped to 0.2..5 ms. The first one returns the
  /// period.
  double begin(std::int64_t now_ns) noexcept;
  /// The device could not be read or written: a hard fault.
  void device_failed() noexcept;
  /// True when the sample can be believed. Otherwise the model must not be asked; limit() with any
  /// force gives what is to be sent.
  bool admit(const PenSample& sample) noexcept;
  /// Scales for the bricks such that the slopes keep to the budget: friction gives way first.
  [[nodiscard]] StiffnessScale budget(const Slopes& slopes) noexcept;
  /// The force to send.
  Force limit(const Force& asked, const PenSample& sample) noexcept;

  [[nodiscard]] const SafetyReport& report() const noexcept { return report_; }
  [[nodiscard]] const SafetyLimits& limits() const noexcept { return limits_; }

 private:
  SafetyLimits limits_;
  SafetyReport report_;
};

}  // namespace felt
