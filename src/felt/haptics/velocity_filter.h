#pragma once

#include "felt/geometry/vec3.h"

namespace felt {

/// Velocity from positions as a driver makes it: first differences through a first-order low-pass
/// (specification decision 3.5: 100 Hz). Backward Euler, v += (dx/dt - v) dt / (tau + dt): stable
/// and without overshoot for every dt, and without a transcendental function.
///
/// Real-time safe, trivially copyable.
class VelocityFilter {
 public:
  static constexpr double kDefaultCutoffHz = 100.0;

  /// A cut-off of 0 or less, or NaN, switches the low-pass off.
  explicit constexpr VelocityFilter(double cutoff_hz = kDefaultCutoffHz) noexcept
      : time_constant_s_(cutoff_hz > 0.0 ? 1.0 / (6.283185307179586 * cutoff_hz) : 0.0) {}

  /// Forgets everything; the next position starts at rest.
  constexpr void reset() noexcept { has_last_ = false; }
  /// The next position (mm), dt_s after the last one. Returns the velocity in mm/s. Where no time
  /// has passed, the last one stays.
  constexpr Vec3 update(const Vec3& position_mm, double dt_s) noexcept {
    if (!has_last_) {
      velocity_ = {};
      last_ = position_mm;
      has_last_ = true;
    } else if (dt_s > 0.0) {
      velocity_ += ((position_mm - last_) - dt_s * velocity_) * (1.0 / (time_constant_s_ + dt_s));
      last_ = position_mm;
    }
    return velocity_;
  }
  [[nodiscard]] constexpr const Vec3& velocity() const noexcept { return velocity_; }

 private:
  double time_constant_s_;
  Vec3 last_;
  Vec3 velocity_;
  bool has_last_ = false;
};

}  // namespace felt
