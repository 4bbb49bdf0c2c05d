#pragma once

#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// The resistance of a surface (specification 5b; figures in material.cc).
struct PlaneOptions {
  double stiffness_n_per_m = 500.0;
  double damping_n_s_per_m = 2.0;
};

/// The sheet under the pen: a one-sided spring and damper in z (R11, R12).
///
///   F_z = max(0, K depth - B vz)   where depth > 0, else 0
///   K   = min(K of the material * memory.scale.normal, memory.material_cap_n_per_m)
///   vz  = difference of z, low-passed at 100 Hz; the pen goes in at vz < 0
///
/// It never pulls the pen in, neither by its spring nor by its damper. At rest F_z = K depth.
///
/// What is not in the formula, and why:
/// * the speed is followed in the air too, so that a landing pen is braked from the first tick;
/// * the first sample, and the first one after a gap of over 20 ms, start with vz = 0: the way made
///   meanwhile says nothing about the speed now;
/// * |vz| counts up to 500 mm/s, so the damper adds 1 N at most: what is faster belongs to the
///   safety chain, and a stale position must not become a blow;
/// * a smaller budget takes from K and leaves B: at a longer delay the damper is what keeps a soft
///   plane calm (specification 5b, table of clean stiffnesses).
///
/// Writes memory.normal_force_n (for the friction) and memory.spring_force_n (for the width).
class Plane {
 public:
  /// Time constant of the low-pass at 100 Hz.
  static constexpr double kSpeedFilterS = 1.0 / (6.283185307179586 * 100.0);

  explicit Plane(const PlaneOptions& options = {}) noexcept : options_(options) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  [[nodiscard]] Slopes slopes() const noexcept;
  [[nodiscard]] const PlaneOptions& options() const noexcept { return options_; }

 private:
  PlaneOptions options_;
};

}  // namespace felt
