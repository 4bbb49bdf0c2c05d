#pragma once

#include <cstdint>
#include <optional>

#include "felt/haptics/pen_sample.h"
#include "felt/haptics/safety/safety_guards.h"

namespace felt {

/// Keeps positions that an arm cannot have reached out of the ink, whether forces are on or off:
/// the safety chain believes every position while no force can flow.
///
/// A single leap is left out. When a leap lasts (JumpGuard), or positions leap again and again, the
/// stroke ends where the pen was last believed, and a new one may begin after positions have been
/// steady for kSteadyNs. Only a leap between two samples that are clearly lifted is believed as
/// soon as it lasts: a sample just above the surface may be a bounce within a stroke (Contact).
///
/// A loop that stood still (Lateness::kVeryLate) does not know what the pen did meanwhile. If it is
/// then farther away than JumpGuard's longest reach, the stroke ends and a new one begins there.
///
/// Samples that repeat the last one (repeats()) are not passed on.
///
/// Haptic thread; real-time safe.
class LeapFilter {
 public:
  static constexpr std::int64_t kSteadyNs = 100'000'000;
  static constexpr double kLiftMm = 1.0;  ///< above the surface: more than a bounce (Contact)

  explicit LeapFilter(const SafetyLimits& limits) noexcept
      : clock_(limits), leaps_(limits), steady_(limits) {}

  /// Takes the next finite sample of an arm. Returns the sample to hand on: the same one, or the
  /// last believed one lifted off the surface, once, when leaps have lasted too long. Nullopt:
  /// none.
  std::optional<PenSample> pass(const PenSample& sample, std::int64_t now_ns) noexcept;

  /// How often a stroke was ended by a leap.
  [[nodiscard]] std::uint32_t cuts() const noexcept { return cuts_; }

 private:
  PenSample believe(const PenSample& sample, const TickTime& time) noexcept;
  PenSample cut(std::int64_t time_ns) noexcept;
  [[nodiscard]] bool is_steady(const PenSample& sample, const TickTime& time) noexcept;

  TickClock clock_;
  JumpGuard leaps_, steady_;
  std::optional<PenSample> seen_;  // the sample before
  PenSample last_;                 // handed on
  bool is_lost_ = false;
  bool was_held_ = false;  // the sample before
  double steady_s_ = 0.0;  // while lost
  std::uint32_t cuts_ = 0;
};

}  // namespace felt
