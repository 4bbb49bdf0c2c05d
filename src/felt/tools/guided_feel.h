#pragma once

#include <algorithm>
#include <utility>

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/guide.h"
#include "felt/haptics/capabilities.h"
#include "felt/material/materials.h"

namespace felt {

/// Stiffness of the friction's bristle while a guide of the drawing or a retraced line acts, N/m.
/// With the usual 600 N/m, the sum of guide and bristle would exceed the stiffness budget. The
/// strength of the friction does not change.
inline constexpr double kGuidedBristleNPerM = 150.0;

/// Returns the medium with a bristle of at most kGuidedBristleNPerM.
inline Medium guided_medium(Medium medium) {
  medium.bristle_n_per_m = std::min(medium.bristle_n_per_m, kGuidedBristleNPerM);
  return medium;
}

/// Returns the spring of the guides of a drawing on a device (docs/design/forces.md#guides): the
/// default, or less stiffness if the delay of the loop leaves less of the stiffness budget beside
/// the bristle (450 N/m at 3 ms), and if the device can render less damping.
inline GuideSpring guide_spring_for(const Capabilities& device) noexcept {
  constexpr double kSofterPerS = 300.0;  // largest ratio of stiffness and damping, chosen
  constexpr double kSoftestNPerM = 300.0;
  GuideSpring spring;
  spring.damping_n_s_per_m =
      std::min(spring.damping_n_s_per_m, 0.5 * finite_positive(device.max_damping_n_s_per_m));
  const double left = stiffness_budget_n_per_m(device) - kGuidedBristleNPerM;
  spring.n_per_m = std::max(
      kSoftestNPerM, std::min({spring.n_per_m, left, kSofterPerS * spring.damping_n_s_per_m}));
  return spring;
}

}  // namespace felt
