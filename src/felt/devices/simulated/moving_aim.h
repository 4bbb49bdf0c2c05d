#pragma once

#include <cstdint>

#include "felt/geometry/vec3.h"
#include "felt/rt/device.h"

namespace felt {

/// Returns true if the change from `a` to `b` starts or ends a contact or a button press.
bool changes_contact(const Aim& a, const Aim& b) noexcept;

/// Moves a hand's aim evenly between the reported aims. A tablet reports its position 133 times a
/// second, but the loop reads it 1000 times or more. The aim moves to a new position in the time
/// that passed between the last two reports, at most 10 ms. Otherwise it would move in steps, which
/// the hand would feel and the safety chain would treat as jumps.
///
/// The aim of a hand with mass moves at most at 500 mm/s. That is faster than writing
/// (docs/design/limits.md#speed) and slower than the speed at which the safety chain brakes.
///
/// Pressure, buttons and tilt change when the aim arrives at its position, so that a pen that is
/// put down starts to draw there and not at its earlier position. If the next aim comes first, they
/// change at that moment, so that no change is lost. A caller that calls shown() after each set()
/// receives the values of every aim.
class MovingAim {
 public:
  static constexpr std::int64_t kLongestNs = 10'000'000;
  static constexpr double kHandSpeedMmPerS = 500.0;

  /// The speed of the aim is at most `top_speed_mm_per_s`; 0 means unlimited.
  explicit MovingAim(double top_speed_mm_per_s = kHandSpeedMmPerS) noexcept
      : top_speed_mm_per_s_(top_speed_mm_per_s) {}

  /// Sets a new aim from now on. `least_ns` is the time until the next read, and the aim moves for
  /// at least that time. The first aim is reached immediately.
  void set(const Aim& aim, std::int64_t now_ns, std::int64_t least_ns) noexcept;
  /// Handles a clock that was set back to `now_ns`: the aim counts as arrived.
  void restart(std::int64_t now_ns) noexcept { start_ns_ = end_ns_ = now_ns; }
  /// Returns the position of the aim.
  [[nodiscard]] Vec3 at(std::int64_t time_ns) const noexcept;
  /// Returns the aim with the current pressure, buttons and tilt.
  [[nodiscard]] const Aim& shown(std::int64_t time_ns) noexcept;
  [[nodiscard]] bool is_set() const noexcept { return is_set_; }
  [[nodiscard]] const Aim& newest() const noexcept { return to_; }

 private:
  double top_speed_mm_per_s_;
  bool is_set_ = false;
  bool newest_is_shown_ = false;  // the values of the newest aim have been returned
  bool owes_one_ = false;         // shown_ must still be returned once
  Vec3 from_mm_;
  Aim to_, shown_;
  std::int64_t start_ns_ = 0, end_ns_ = 0;
};

}  // namespace felt
