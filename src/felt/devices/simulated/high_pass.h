#pragma once

#include <cmath>

namespace felt {

/// A second-order Butterworth high-pass filter (bilinear transform, pre-warped).
class HighPass {
 public:
  HighPass(double cutoff_hz, double period_s) noexcept {
    const double k = std::tan(3.141592653589793 * cutoff_hz * period_s);
    const double q = 1.0 + 1.4142135623730951 * k + k * k;
    gain_ = 1.0 / q;
    a1_ = 2.0 * (k * k - 1.0) / q;
    a2_ = (1.0 - 1.4142135623730951 * k + k * k) / q;
  }

  double operator()(double x) noexcept {
    const double w = x - a1_ * w1_ - a2_ * w2_;
    const double y = gain_ * (w - 2.0 * w1_ + w2_);
    w2_ = w1_;
    w1_ = w;
    return y;
  }

 private:
  double gain_, a1_, a2_;
  double w1_ = 0.0, w2_ = 0.0;
};

}  // namespace felt
