#pragma once

#include <algorithm>
#include <cmath>

namespace felt {

/// Limits the force while motors are warm, according to their own thermometers (0 cold .. 1 too
/// warm). When the temperature exceeds 0.7, the limit begins to fall by a thousandth per tick, down
/// to the continuous force. When the temperature is below 0.5, the limit rises again at the same
/// rate. The rule and the numbers come from the maker's own sample for motor temperature
/// (docs/design/devices.md#motor-temperature). At 1 kHz the limit halves in 0.7 s.
///
/// Used on the haptic thread; real-time safe.
class TemperatureGuard {
 public:
  static constexpr double kWarm = 0.7;
  static constexpr double kCool = 0.5;
  static constexpr double kDown = 0.999;  ///< per tick
  static constexpr double kUp = 1.001;

  /// The limit stays between `continuous_n` and `max_n`, in N. If `continuous_n` exceeds `max_n`,
  /// the limit is always `max_n`.
  TemperatureGuard(double max_n, double continuous_n) noexcept
      : max_n_(max_n), min_n_(std::min(max_n, continuous_n)), allowed_n_(max_n) {}

  /// Updates the limit for one tick and returns it in N. `temperature` is that of the warmest
  /// motor. A temperature of NaN counts as too warm.
  double allow(double temperature) noexcept {
    if (!(temperature <= kWarm)) is_warm_ = true;
    if (temperature < kCool) is_warm_ = false;
    allowed_n_ = std::clamp(allowed_n_ * (is_warm_ ? kDown : kUp), min_n_, max_n_);
    return allowed_n_;
  }
  [[nodiscard]] double allowed_n() const noexcept { return allowed_n_; }

 private:
  double max_n_;
  double min_n_;
  double allowed_n_;
  bool is_warm_ = false;
};

}  // namespace felt
