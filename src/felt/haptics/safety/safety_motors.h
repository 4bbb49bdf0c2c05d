#pragma once

#include "felt/haptics/safety/safety_limits.h"

namespace felt {

/// The force that the motors may hold for as long as one likes, N: all that MotorGuard lets through
/// in the end. Infinite without a rating.
double sustained_force_n(const SafetyLimits& limits) noexcept;

/// Keeps the motors cool (architecture section 10: RMS over 10 s at most 80 % of the rating, then a
/// fade over 1 s with a notice).
///
/// The mean square m of the force is a low-pass with half the window as time constant, as a motor
/// warms. Its bound is set so that the plain RMS over any whole window stays under the limit L: the
/// energy of a window W is at most tau m + W m, so m <= L^2 W/(W + tau). The force that may be sent
/// depends on m alone: the more room is left, the more; it reaches the sustainable force sqrt(m) as
/// the room is used up, along a fade that takes about fade_s from the peak. So a hand that keeps on
/// pressing feels the plane become softer, once, and never a cut or a swing.
class MotorGuard {
 public:
  explicit MotorGuard(const SafetyLimits& limits) noexcept;

  /// The device held force_n for duration_s.
  void heat(double force_n, double duration_s) noexcept;
  /// The force that may be sent now, N; infinite without a rating.
  [[nodiscard]] double allowed_n() const noexcept;
  /// Root of the mean square, N.
  [[nodiscard]] double rms_n() const noexcept;
  /// Call with whether the limit was met on this tick; true from then until the motors have cooled
  /// to half the heat (hysteresis of the notice, not of the force).
  bool is_warm(bool limited) noexcept;

 private:
  double tau_s_;
  double sustained_n_;  // 0 = no bound
  double gain_;         // of the fade, N^2 per N^2
  double mean_square_ = 0.0;
  bool warm_ = false;
};

}  // namespace felt
