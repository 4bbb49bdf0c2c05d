#pragma once

#include <cstdint>
#include <optional>

#include "felt/haptics/pen_sample.h"
#include "felt/haptics/safety_clock.h"
#include "felt/haptics/safety_motion.h"

namespace felt {

/// Keeps positions that an arm cannot have reached out of the ink, whether forces are on or off:
/// the safety chain believes every position while no force can flow.
///
/// A single leap is left out. When a leap lasts (JumpGuard) that would draw a line, because the pen
/// touches before and after it, the stroke ends where the pen was last believed, and nothing is ink
/// until positions have been steady for kSteadyNs and the pen has left the surface. The same if the
/// position leaps again and again. A lasting leap in the air draws nothing and is believed.
///
/// Haptic thread; real-time safe.
class LeapFilter {
 public:
  static constexpr std::int64_t kSteadyNs = 100'000'000;
  static constexpr double kLiftMm = 1.0;  ///< above the surface: more than a bounce (Contact)

  explicit LeapFilter(const SafetyLimits& limits) noexcept
      : clock_(limits), leaps_(limits), steady_(limits) {}

  /// Takes the next finite sample of an arm. Returns the sample to hand on: the same one, or once,
  /// when leaps have lasted too long, the last believed one lifted off the surface. Nullopt: none.
  std::optional<PenSample> pass(const PenSample& sample, std::int64_t now_ns) noexcept;

 private:
  [[nodiscard]] PenSample lifted(std::int64_t time_ns) const noexcept;
  [[nodiscard]] bool is_back(const PenSample& sample, const TickTime& time) noexcept;

  TickClock clock_;
  JumpGuard leaps_, steady_;
  PenSample last_;  // believed
  bool is_lost_ = false;
  bool was_held_ = false;  // the sample before
  double steady_s_ = 0.0;  // while lost
};

}  // namespace felt
