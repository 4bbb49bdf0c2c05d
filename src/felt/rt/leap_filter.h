#pragma once

#include <cstdint>
#include <optional>

#include "felt/haptics/pen_sample.h"
#include "felt/haptics/safety/safety_guards.h"

namespace felt {

/// Rejects positions that an arm cannot have reached, so that they do not become ink, whether
/// forces are on or off. The filter is needed because the safety chain accepts every position while
/// no force can be output.
///
/// A single jump is dropped. If positions do not return from a jump in time, or jump again and
/// again, JumpGuard reports a fault: the stroke ends at the last accepted position, and a new one
/// may begin after positions have been steady for kSteadyNs. The only exception is a jump between
/// two samples that are clearly lifted: the new position is accepted as soon as JumpGuard reports
/// the fault. A sample just above the surface is not enough, because it may be a bounce within a
/// stroke (Contact).
///
/// If the loop stood still (Lateness::kVeryLate), the motion of the pen meanwhile is unknown. If
/// the pen is afterwards farther away than the longest distance that JumpGuard accepts
/// (kMaxReachS), the stroke ends and a new one begins at the new position.
///
/// Samples that repeat the last one (repeats()) are not passed on.
///
/// Haptic thread only; real-time safe.
class LeapFilter {
 public:
  static constexpr std::int64_t kSteadyNs = 100'000'000;
  static constexpr double kLiftMm =
      1.0;  ///< above the surface: more than noise and the bounce of a tip

  explicit LeapFilter(const SafetyLimits& limits) noexcept
      : clock_(limits), leaps_(limits), steady_(limits) {}

  /// Processes the next finite sample of an arm. Returns the sample to pass on, which is usually
  /// `sample`. To end the stroke, returns a sample that is lifted off the surface: at the last
  /// accepted position, or, if the loop stood still, at the new position. Returns nullopt if no
  /// sample is to be passed on.
  std::optional<PenSample> pass(const PenSample& sample, std::int64_t now_ns) noexcept;

  /// Returns the number of strokes that were ended by a jump.
  [[nodiscard]] std::uint32_t cuts() const noexcept { return cuts_; }

 private:
  PenSample believe(const PenSample& sample, const TickTime& time) noexcept;
  PenSample cut(std::int64_t time_ns) noexcept;
  [[nodiscard]] bool is_steady(const PenSample& sample, const TickTime& time) noexcept;

  TickClock clock_;
  JumpGuard leaps_, steady_;
  std::optional<PenSample> seen_;  // the previous sample
  PenSample last_;                 // the last sample passed on
  bool is_lost_ = false;
  bool was_held_ = false;  // the previous sample was too far away (PositionVerdict::kHeld)
  double steady_s_ = 0.0;  // how long positions have been steady, while is_lost_
  std::uint32_t cuts_ = 0;
};

}  // namespace felt
