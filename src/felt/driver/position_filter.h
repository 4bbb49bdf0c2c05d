#pragma once

#include "felt/geometry/vec3.h"

namespace felt {

/// Estimates position and velocity of a pen from measured positions that have steps of some
/// hundredths of a millimetre, for devices that do not report a velocity. Uses a critically damped
/// alpha-beta filter, which has no lag in steady movement (Brookner, Tracking and Kalman Filtering
/// Made Easy, 1998, section 1.2).
///
/// A position that a hand cannot reach in the time of one step is passed on unfiltered and with
/// zero velocity, so that the safety chain sees the jump. Used on the haptic thread; real-time
/// safe.
class PositionFilter {
 public:
  /// `bandwidth_hz` is the filter's bandwidth. A position that is farther than `jump_mm` from the
  /// expected one is a jump.
  PositionFilter(double bandwidth_hz, double jump_mm) noexcept;

  /// Handles a position that was measured `step_s` after the previous one. After more than 0.02 s,
  /// or if the time runs backwards, the filter starts again at `measured`.
  void update(const Vec3& measured, double step_s) noexcept;
  /// Forgets everything; the next position is the first one.
  void reset() noexcept { has_position_ = false; }

  [[nodiscard]] const Vec3& position() const noexcept { return position_; }  ///< mm
  [[nodiscard]] const Vec3& velocity() const noexcept { return velocity_; }  ///< mm/s

 private:
  double rad_per_s_;
  double jump_mm_;
  Vec3 position_, velocity_;
  bool has_position_ = false;
};

}  // namespace felt
