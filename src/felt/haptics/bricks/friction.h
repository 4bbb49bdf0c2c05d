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
  /// f: friction of the device itself, which is not rendered again up to mu0 Fn.
  double own_friction_n = 0.0;
  double own_coefficient = 0.0;      ///< mu0
  double viscosity_n_s_per_m = 0.0;  ///< b, in addition (matched_viscosity_n_s_per_m)
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
/// The hand already feels the friction f of the device. Up to mu0 Fn, that of a pencil on paper, f
/// counts as the friction of the surface. So mu Fn above is what the surface has beyond it, with
/// the grain in any case: max(mu Fn - min(f, mu0 Fn), g mu Fn), where g is memory.friction_grain, 0
/// without a grain that can be felt. What rubs more than a pencil therefore does so on every
/// device. The viscous friction, -b v, is added to F while the pen presses. It has no limit of
/// friction, so v counts only as far as the positions bear it out (PageMotion): a device whose
/// velocity has the wrong sign, or stands still, is not driven.
///
/// memory.scale.friction scales k and d. memory.friction_factor, set by a texture before this
/// brick, multiplies mu for one tick; the resulting change of the force is reported as the term
/// "texture", and -b v as "viscosity".
class Friction {
 public:
  explicit Friction(const FrictionOptions& options = {}) noexcept : options_(options) {}

  /// Largest viscous force, N, so that a fast pen does not feel a wall.
  static constexpr double kMaxViscousN = 0.3;
  /// Push from which on the whole viscosity acts, N, so that a landing pen feels no step.
  static constexpr double kWholeViscosityN = 0.1;

  /// Returns the largest dry friction of this tick, N: what the material has beyond the device, and
  /// at least the grain.
  static double limit_n(const FrictionOptions& options, const ForceMemory& memory) noexcept;

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  [[nodiscard]] Slopes slopes() const noexcept;
  [[nodiscard]] const FrictionOptions& options() const noexcept { return options_; }

 private:
  [[nodiscard]] Force dry_n(const PenSample& sample, double limit_n,
                            ForceMemory& memory) const noexcept;
  [[nodiscard]] Force viscous_n(const PenSample& sample, ForceMemory& memory) const noexcept;

  FrictionOptions options_;
};

}  // namespace felt
