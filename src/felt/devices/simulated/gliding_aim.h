#pragma once

#include <cstdint>

#include "felt/geometry/vec3.h"
#include "felt/rt/device.h"

namespace felt {

/// Returns true if the change from `a` to `b` starts or ends a contact or a button press.
bool changes_contact(const Aim& a, const Aim& b) noexcept;

/// Interpolates the position at which a simulated hand aims, at constant speed from one reported
/// pose (Aim, rt/device.h) to the next. A tablet reports its position 133 times a second, but the
/// loop reads the aim 1000 times a second or more often. The position moves to a new aim in the
/// time that passed between the last two reports, at most 10 ms. Without interpolation, it would
/// move in steps, which the hand would feel and the safety chain would treat as jumps.
///
/// By default, the position moves at most at 500 mm/s, and therefore may need more than 10 ms. A
/// hand that writes is slower than that (docs/design/limits.md#speed), and the safety chain brakes
/// only at higher speeds.
///
/// Pressure, buttons and tilt change when the position arrives, so that a pen that is put down
/// starts to draw at the new position and not at the earlier position. If the next aim is set
/// before the arrival, these values change at that moment, so that no change is lost. A caller that
/// calls shown() after each set() receives the values of every aim.
class GlidingAim {
 public:
  static constexpr std::int64_t kLongestNs = 10'000'000;
  static constexpr double kHandSpeedMmPerS = 500.0;

  /// The speed of the position is at most `top_speed_mm_per_s`; 0 means unlimited.
  explicit GlidingAim(double top_speed_mm_per_s = kHandSpeedMmPerS) noexcept
      : top_speed_mm_per_s_(top_speed_mm_per_s) {}

  /// Sets a new aim from now on. `min_ns` is the time until the next read. The position arrives no
  /// earlier than that, unless `min_ns` exceeds 10 ms. The first aim is reached immediately.
  void set(const Aim& aim, std::int64_t now_ns, std::int64_t min_ns) noexcept;
  /// Must be called if the clock was set back to `now_ns`. The position then counts as arrived at
  /// the newest aim.
  void restart(std::int64_t now_ns) noexcept { start_ns_ = end_ns_ = now_ns; }
  /// Returns the interpolated position at this time.
  [[nodiscard]] Vec3 at(std::int64_t time_ns) const noexcept;
  /// Returns the aim whose pressure, buttons and tilt are valid at this time.
  [[nodiscard]] const Aim& shown(std::int64_t time_ns) noexcept;
  [[nodiscard]] bool is_set() const noexcept { return is_set_; }
  /// Returns the time at which the position is at the newest aim.
  [[nodiscard]] std::int64_t arrives_ns() const noexcept { return end_ns_; }
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
