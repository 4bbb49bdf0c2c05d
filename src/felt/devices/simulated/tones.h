#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/geometry/point.h"

namespace felt {

/// Smooth noise in x and y: the sum of five sines with random phases, and with random frequencies
/// in a band. Each axis has the given RMS.
class Tones {
 public:
  Tones(Random& random, double low_hz, double high_hz, double rms) noexcept {
    for (Tone& tone : tones_) {
      tone.hz = random.between(low_hz, high_hz);
      tone.phase_x = random.between(0.0, kTau);
      tone.phase_y = random.between(0.0, kTau);
    }
    amplitude_ = rms * std::sqrt(2.0 / double(kCount));
  }

  [[nodiscard]] Vec at(double t_s) const noexcept {
    Vec sum;
    for (const Tone& tone : tones_) {
      const double a = kTau * tone.hz * t_s;
      sum += amplitude_ * Vec{std::sin(a + tone.phase_x), std::sin(a + tone.phase_y)};
    }
    return sum;
  }

 private:
  static constexpr std::size_t kCount = 5;
  struct Tone {
    double hz = 0.0, phase_x = 0.0, phase_y = 0.0;
  };
  std::array<Tone, kCount> tones_;
  double amplitude_ = 0.0;
};

}  // namespace felt
