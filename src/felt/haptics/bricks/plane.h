#pragma once

#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// The resistance of a surface (docs/design/forces.md#surfaces; values in docs/materials.md).
struct PlaneOptions {
  double stiffness_n_per_m = 500.0;
  double damping_n_s_per_m = 2.0;
};

/// The surface under the pen: a one-sided spring and damper in z (R11, R12).
///
///   F_z = max(0, K depth - B vz)   if depth > 0, else 0
///   K   = min(K of the material * memory.scale.normal, memory.material_cap_n_per_m)
///   vz  = dz/dt, low-pass filtered at 100 Hz; negative while the pen goes in
///
/// Neither the spring nor the damper ever pulls the pen in. At rest F_z = K depth.
///
/// The formula does not show the following:
/// * The speed is also measured above the surface, so that a landing pen is braked from the first
///   tick.
/// * The first sample, and the first one after a gap of more than 20 ms, start with vz = 0, because
///   the displacement in between says nothing about the present speed.
/// * While the device repeats its sample, vz stays, for up to 20 ms. Then it is 0.
/// * |vz| is clamped to 500 mm/s, so the damper adds at most 1 N. Faster motion is left to the
///   safety chain, so that a stale position does not cause a kick.
/// * If the stiffness budget is less than K, K is reduced but B is not, because the damper keeps a
///   soft plane calm even at a longer delay (docs/design/forces.md#plane).
///
/// Writes memory.normal_force_n (for the friction) and memory.spring_force_n (for the width).
class Plane {
 public:
  /// Time constant of the low-pass filter at 100 Hz.
  static constexpr double kSpeedFilterS = 1.0 / (6.283185307179586 * 100.0);

  explicit Plane(const PlaneOptions& options = {}) noexcept : options_(options) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  [[nodiscard]] Slopes slopes() const noexcept;
  [[nodiscard]] const PlaneOptions& options() const noexcept { return options_; }

 private:
  PlaneOptions options_;
};

}  // namespace felt
