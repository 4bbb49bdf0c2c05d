#pragma once

#include <cstdint>

#include "felt/geometry/vec3.h"
#include "felt/rt/device.h"

namespace felt {

/// Whether going from one aim to the other begins or ends something: a touch, a button.
bool changes_contact(const Aim& a, const Aim& b) noexcept;

/// Where a hand's aim is between the aims that it is given. A tablet says 133 times a second where
/// it is, the loop asks 1000 times or more: the aim moves evenly to the new place, in the time that
/// passed since the last one was given, at most 10 ms. So it stands in no staircase, which the hand
/// would feel and the safety chain take for jumps.
///
/// A hand that has mass does not leap either: 500 mm/s at most, which is faster than writing
/// (reliability section 3.3) and slower than what the safety chain brakes.
///
/// Pressure, buttons and lean change when it arrives, so that a pen that is put down draws from
/// there and not from where it came; or with the next aim, where that comes first: nothing is lost.
/// Whoever asks after each set() sees what every aim said.
class MovingAim {
 public:
  static constexpr std::int64_t kLongestNs = 10'000'000;
  static constexpr double kHandSpeedMmPerS = 500.0;

  /// 0: as fast as it is told.
  explicit MovingAim(double top_speed_mm_per_s = kHandSpeedMmPerS) noexcept
      : top_speed_mm_per_s_(top_speed_mm_per_s) {}

  /// From now on; `least_ns` is the time until the loop asks next. The first one is there at once.
  void set(const Aim& aim, std::int64_t now_ns, std::int64_t least_ns) noexcept;
  /// The clock was set back to this: it has arrived.
  void restart(std::int64_t now_ns) noexcept { start_ns_ = end_ns_ = now_ns; }
  /// Where it is.
  [[nodiscard]] Vec3 at(std::int64_t time_ns) const noexcept;
  /// Pressure, buttons and lean.
  [[nodiscard]] const Aim& shown(std::int64_t time_ns) noexcept;
  [[nodiscard]] bool is_set() const noexcept { return is_set_; }
  [[nodiscard]] const Aim& newest() const noexcept { return to_; }

 private:
  double top_speed_mm_per_s_;
  bool is_set_ = false;
  bool newest_is_shown_ = false;  // someone has seen what the newest aim said
  bool owes_one_ = false;         // shown_ has not been seen yet
  Vec3 from_mm_;
  Aim to_, shown_;
  std::int64_t start_ns_ = 0, end_ns_ = 0;
};

}  // namespace felt
