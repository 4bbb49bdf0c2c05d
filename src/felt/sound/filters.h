#pragma once

#include <algorithm>

#include "felt/sound/plain_math.h"

/// The filters of the sound; not public. Each filter has one channel, is for one thread, and does
/// not allocate.
namespace felt {

/// Returns the coefficient of a first-order low-pass filter with this time constant: the share of
/// the difference between input and output that the output covers in one sample.
constexpr double follow_share(double time_s, double rate_hz) noexcept {
  return 1.0 - plain::exp(-1.0 / (time_s * rate_hz));
}

/// Two first-order low-pass filters in series, which fall by 12 dB per octave above the corner.
class LowPass {
 public:
  void set(double corner_hz, double rate_hz) noexcept {
    share_ = 1.0 - plain::exp(-2.0 * plain::kPi * std::min(corner_hz / rate_hz, 0.45));
  }
  double operator()(double in) noexcept {
    low_ += share_ * (in - low_);
    lower_ += share_ * (low_ - lower_);
    return lower_;
  }
  void clear() noexcept { low_ = lower_ = 0.0; }

 private:
  double share_ = 1.0, low_ = 0.0, lower_ = 0.0;
};

/// A first-order high-pass filter, which removes inaudibly low frequencies.
class LowCut {
 public:
  void set(double corner_hz, double rate_hz) noexcept {
    share_ = 1.0 - plain::exp(-2.0 * plain::kPi * corner_hz / rate_hz);
  }
  double operator()(double in) noexcept {
    low_ += share_ * (in - low_);
    return in - low_;
  }
  void clear() noexcept { low_ = 0.0; }

 private:
  double share_ = 0.0, low_ = 0.0;
};

/// One mode of a body: a band-pass filter with gain 1 at its frequency. (Robert Bristow-Johnson's
/// cookbook.)
class Resonator {
 public:
  void set(double frequency_hz, double q, double rate_hz) noexcept {
    const double w = 2.0 * plain::kPi * std::clamp(frequency_hz / rate_hz, 1e-4, 0.45);
    const double alpha = plain::sin(w) / (2.0 * q);
    b_ = alpha / (1.0 + alpha);
    a1_ = -2.0 * plain::cos(w) / (1.0 + alpha);
    a2_ = (1.0 - alpha) / (1.0 + alpha);
  }
  double operator()(double in) noexcept {
    const double out = b_ * in + s1_;
    s1_ = s2_ - a1_ * out;
    s2_ = -b_ * in - a2_ * out;
    return out;
  }
  void clear() noexcept { s1_ = s2_ = 0.0; }

 private:
  double b_ = 0.0, a1_ = 0.0, a2_ = 0.0;
  double s1_ = 0.0, s2_ = 0.0;
};

}  // namespace felt
