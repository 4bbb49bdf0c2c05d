#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "felt/devices/simulated/stroke_forces.h"

namespace felt {

/// How a stroke feels, computed from its forces and the friction of the device alone, in units of a
/// just noticeable difference (JND): if a feature of two strokes differs by 1, a person notices it
/// in 75 % of the comparisons.
struct FeelFeatures {
  static constexpr std::size_t kCount = 6;
  std::array<double, kCount> jnd{};
};
/// Returns the name of a feature: "friction", "hardness", ...
std::string_view name_of_feature(std::size_t feature) noexcept;

/// Computes the features from the forces of one stroke and their times. `leg_mm` is the length of
/// each of the two halves of the path, the same for all strokes. The speed of the pen is computed
/// from it and the duration.
///
/// The JNDs are: force 10 % (8 to 13 %: docs/design/simulation.md#perception), stiffness 22 %
/// (Jones and Hunter 1990), strength of a vibration 20 % and its coarseness 25 % (round figures).
/// A vibration far below a peak of 0.04 N is not felt.
FeelFeatures features_of(const StrokeForces& forces, double leg_mm);

/// The texture found in a series of forces.
struct Texturing {
  double peak_n = 0.0;         ///< sqrt 2 times the rms of the varying force along the surface
  double wavelength_mm = 0.0;  ///< mean wavelength, weighted by power
};
/// Returns the texture in `forces` with wavelengths of `shortest_mm` to `longest_mm` at this speed.
Texturing texture_of(const std::vector<Force>& forces, double period_s, double speed_mm_per_s,
                     double shortest_mm, double longest_mm);

/// Returns the features as a person perceives them: with the random error that gives each sense
/// its JND.
FeelFeatures blurred(const FeelFeatures& features, std::uint32_t seed);

}  // namespace felt
