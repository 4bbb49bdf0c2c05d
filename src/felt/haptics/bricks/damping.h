#pragma once

#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// Where a damping acts.
enum class DampingWhere { kInAir, kOnSheet, kEverywhere };

struct DampingOptions {
  double damping_n_s_per_m = 0.5;
  double max_force_n = 0.3;  ///< not felt as a wall, however fast the pen
  DampingWhere where = DampingWhere::kInAir;
};

/// F = -b v, shortened to max_force_n, in all three axes in the air and in the sheet's axes on the
/// sheet (z belongs to the plane there). Calms a light hand above the sheet.
class Damping {
 public:
  explicit Damping(const DampingOptions& options = {}) noexcept : options_(options) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  /// Damping has no stiffness.
  [[nodiscard]] Slopes slopes() const noexcept { return {}; }

 private:
  DampingOptions options_;
};

}  // namespace felt
