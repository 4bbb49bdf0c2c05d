#pragma once

#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// Where the pen must be for the damping to act.
enum class DampingWhere { kInAir, kOnSurface, kEverywhere };

struct DampingOptions {
  double damping_n_s_per_m = 0.5;
  double max_force_n = 0.3;  ///< small, so that a fast pen does not feel a wall
  DampingWhere where = DampingWhere::kInAir;
};

/// Damps the pen: F = -b v, shortened to max_force_n. Above the surface it acts along all three
/// axes, which calms a light hand. While the pen touches the surface, it acts only along the
/// surface, because Plane computes the force in z then.
class Damping {
 public:
  explicit Damping(const DampingOptions& options = {}) noexcept : options_(options) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  /// Returns zero, because damping has no stiffness.
  [[nodiscard]] Slopes slopes() const noexcept { return {}; }

 private:
  DampingOptions options_;
};

}  // namespace felt
