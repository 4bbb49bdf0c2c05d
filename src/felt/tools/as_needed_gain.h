#pragma once

#include <algorithm>

namespace felt {

/// The strength of guidance that is given as needed, 0 to 1: it grows with the error and decays
/// with time, so that it fades as the user does well. This is the assistance law of Emken, Benitez,
/// Sideris, Bobrow and Reinkensmeyer, "Motor adaptation as a greedy optimization of error and
/// effort", J Neurophysiol 97, 2007, DOI 10.1152/jn.01095.2006,
///
///   R[i+1] = f R[i] + g |e[i]|
///
/// in continuous time: f = 1 - dt/kMemoryS, g = dt/(kMemoryS kFullMm). For a constant error e the
/// gain approaches e/kFullMm, at most 1.
class AsNeededGain {
 public:
  static constexpr double kMemoryS = 2.0;  ///< without error, the gain falls to 37 % in this time
  static constexpr double kFullMm = 0.5;   ///< a lasting error of this size gives the full gain

  /// Adds an error that lasted dt_s. Ignores it if a number is negative or not finite.
  constexpr void update(double error_mm, double dt_s) noexcept {
    if (!(error_mm >= 0.0 && error_mm < 1e9 && dt_s > 0.0 && dt_s < 1e9)) return;
    const double step = dt_s / (kMemoryS + dt_s);  // backward Euler, stable for any dt
    gain_ = std::min(1.0, gain_ + step * (error_mm / kFullMm - gain_));
  }
  [[nodiscard]] constexpr double gain() const noexcept { return gain_; }

 private:
  double gain_ = 0.0;
};

}  // namespace felt
