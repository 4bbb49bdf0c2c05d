#include "felt/tools/pressing.h"

#include <algorithm>
#include <cmath>

#include "felt/haptics/drawing_feel.h"

namespace felt {
namespace {

constexpr double kShareOfContinuous = 1.2;

double full_force(double continuous) noexcept {
  if (!(continuous > 0.0)) return Pressing::kMostN;
  // A device that hardly pushes still needs a range to press in.
  return std::clamp(kShareOfContinuous * continuous, 2.0 * Pressing::kLeastN, Pressing::kMostN);
}

}  // namespace

Pressing::Pressing(const SurfaceMaterial& surface, const Capabilities& device) noexcept
    : stiffness_n_per_m_(plane_for(surface, device).stiffness_n_per_m),
      most_n_(full_force(device.continuous_force_n)),
      senses_depth_(device.sensed_axes >= 3) {}

double Pressing::of_force(double spring_n) const noexcept {
  return std::clamp((spring_n - kLeastN) / (most_n_ - kLeastN), 0.0, 1.0);
}

std::optional<double> Pressing::of(const PenSample& sample) const noexcept {
  if (sample.pressure && !std::isnan(*sample.pressure)) {
    return std::clamp(*sample.pressure, 0.0, 1.0);
  }
  if (!senses_depth_) return std::nullopt;
  return of_force(0.001 * stiffness_n_per_m_ * depth_mm(sample));
}

}  // namespace felt
