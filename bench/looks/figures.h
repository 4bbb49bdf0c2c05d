#pragma once

#include <array>

#include "artist.h"

namespace felt::bench {

/// What is measured of one medium. Darkness is 0 on white paper and 1 on solid ink. The core of a
/// line is the middle half of its width.
struct LookFigures {
  static constexpr std::array<double, 5> kPressures{0.1, 0.3, 0.5, 0.7, 0.9};

  double mid_share = 0.0;         ///< share of the core of the ramp with a darkness of 0.1 to 0.9
  double full_share = 0.0;        ///< share of the core of the ramp with a darkness above 0.9
  std::array<double, 5> tones{};  ///< mean darkness of the core at kPressures
  double thin_mm = 0.0, broad_mm = 0.0;  ///< width at half of the darkness, at both ends
  /// Of lines with pressure 0.5: the distance along the line after which the darkness is correlated
  /// by less than 1/e, the highest correlation at any lag of 1 to 12 mm, and its lag.
  double grain_mm = 0.0, second_peak = 0.0, second_mm = 0.0;
  double edge_mm = 0.0;     ///< distance over which the mean profile rises from 10 to 90 %
  double unevenness = 0.0;  ///< relative standard deviation of the ink along a light line at 96 dpi
  double once = 0.0, twice = 0.0,
         back = 0.0;  ///< mean darkness of the core if drawn once, twice, there and back
};

/// Draws the test pages with the artist, and measures the pictures.
Result<LookFigures> measure(const Artist& artist, double dpi);

}  // namespace felt::bench
