#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "felt/devices/simulated/felt_stroke.h"

namespace felt {

/// What a stroke feels like, from its forces alone, in units of a just noticeable difference (JND):
/// two strokes whose feature differs by 1 are told apart by it three times out of four.
struct FeelFeatures {
  static constexpr std::size_t kCount = 6;
  std::array<double, kCount> jnd{};
};
/// "friction", "hardness", ...
std::string_view name_of_feature(std::size_t feature) noexcept;

/// From the forces of one stroke and a clock. `leg_mm`: the length of both halves of the path,
/// which all strokes share; how fast the pen was follows from how long it took.
///
/// JNDs: force 10 % (8 to 13 %: docs/design/simulation.md#perception), stiffness 22 % (Jones and
/// Hunter 1990), strength of a vibration 20 % and its coarseness 25 % (round figures), of which
/// nothing is felt far below 0.04 N peak.
FeelFeatures features_of(const StrokeForces& forces, double leg_mm);

/// A texture in a row of forces.
struct Texturing {
  double peak_n = 0.0;         ///< sqrt 2 times the rms of what varies in the sheet
  double wavelength_mm = 0.0;  ///< its middle one
};
/// What of it has a wavelength of `shortest_mm` to `longest_mm`, at that speed.
Texturing texture_of(const std::vector<Force>& forces, double period_s, double speed_mm_per_s,
                     double shortest_mm, double longest_mm);

/// What a hand makes of it: each feature with the error of a sense that has that JND.
FeelFeatures blurred(const FeelFeatures& features, std::uint32_t seed);

}  // namespace felt
