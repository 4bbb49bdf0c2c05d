#pragma once

#include <algorithm>

#include "felt/haptics/bricks/guide.h"

namespace felt::guided_people_test {

/// A guide that also pulls a pen in the air below `height_mm`, with a share of its force that grows
/// from zero there to the whole force at half of that height. An experiment: the program has no
/// such force (docs/design/forces.md#guides-of-a-drawing says why).
struct HoveringGuide {
  Guide guide;
  double height_mm = 0.0;  ///< 0: the guide acts only on a pen that touches

  /// Returns true for a pen in the air that is pulled.
  [[nodiscard]] bool acts_in_air(const PenSample& sample) const noexcept {
    return !in_contact(sample) && sample.position.z < height_mm;
  }
  /// Returns the sample that the guide gets: a pen in the air that is pulled counts as touching.
  [[nodiscard]] PenSample lowered(PenSample sample) const noexcept {
    if (acts_in_air(sample)) sample.position.z = -1e-3;
    return sample;
  }
  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
    Force force = guide(lowered(sample), memory);
    if (!acts_in_air(sample)) return force;
    const double t = std::clamp(2.0 * (1.0 - sample.position.z / height_mm), 0.0, 1.0);
    const double share = t * t * (3.0 - 2.0 * t);
    force.x *= share;
    force.y *= share;
    return force;
  }
  [[nodiscard]] Slopes slopes() const noexcept { return guide.slopes(); }
};

}  // namespace felt::guided_people_test
