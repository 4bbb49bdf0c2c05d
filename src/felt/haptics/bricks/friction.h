#pragma once

#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// Friction of one material on another (docs/design/forces.md#friction; values in
/// docs/materials.md).
struct FrictionOptions {
  double coefficient = 0.25;         ///< mu, static = kinetic
  double stiffness_n_per_m = 600.0;  ///< k of the bristle
  double damping_n_s_per_m = 2.0;    ///< d of the bristle
};

/// Dry friction that depends on the path of the pen, not on the sign of its velocity (R13, R41,
/// R42). The pen is attached to the surface by a bristle, a spring with its foot at w:
///   z = p - w,  kept to |z| <= mu Fn / k by moving w
///   F = -k z - d v,  shortened to |F| <= mu Fn          (Fn = memory.normal_force_n)
///
/// While |z| is below its limit, the foot does not move, so there is no drift however long the hand
/// presses. At the limit the foot follows the pen, so F = mu Fn in every steady slide. Static
/// friction equals kinetic friction, because low stiction helps aiming and high stiction hurts
/// (Richard and Cutkosky 2000). Friction that is a function of the speed would buzz at rest
/// (0.17-0.58 N above 30 Hz; docs/design/forces.md#friction).
///
/// v is known_velocity() (pen_sample.h): the measured velocity, shortened by 6 mm/s of uncertainty.
/// The damper acts on v and not on dz/dt, because dz/dt jumps when the foot starts to move, and
/// would reverse the force (docs/design/forces.md#friction: spikes of -1.2 N). In a steady slide,
/// clamping F to mu Fn removes the damper's contribution. If the normal force is zero, the friction
/// is zero, and the bristle is detached.
///
/// memory.scale.friction scales k and d. memory.friction_factor, set by a texture before this
/// brick, multiplies mu for one tick; the resulting change of the force is reported as the term
/// "texture".
class Friction {
 public:
  explicit Friction(const FrictionOptions& options = {}) noexcept : options_(options) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  [[nodiscard]] Slopes slopes() const noexcept;
  [[nodiscard]] const FrictionOptions& options() const noexcept { return options_; }

 private:
  FrictionOptions options_;
};

}  // namespace felt
