#include "felt/tools/pressing.h"

#include <algorithm>
#include <cmath>

#include "felt/haptics/bricks/drawing_feel.h"

namespace felt {
Pressing::Pressing(const SurfaceMaterial& surface, const Capabilities& device) noexcept
    : stiffness_n_per_m_(plane_for(surface, device).stiffness_n_per_m),
      max_n_(firm_push_n(device)),
      senses_depth_(device.sensed_axes >= 3),
      is_felt_(senses_depth_ && !device.senses_pressure && device.max_force_n > 0.0) {}

double Pressing::of_force(double spring_n) const noexcept {
  return std::clamp((spring_n - kMinN) / (max_n_ - kMinN), 0.0, 1.0);
}

double Pressing::depth_mm_at(double pressure) const noexcept {
  return 1000.0 * (kMinN + pressure * (max_n_ - kMinN)) / stiffness_n_per_m_;
}

std::optional<double> Pressing::of(const PenSample& sample) const noexcept {
  if (sample.pressure && !std::isnan(*sample.pressure)) {
    return std::clamp(*sample.pressure, 0.0, 1.0);
  }
  if (!senses_depth_) return std::nullopt;
  return of_force(0.001 * stiffness_n_per_m_ * depth_mm(sample));
}

}  // namespace felt
