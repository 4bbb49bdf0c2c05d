#pragma once

#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// Friction of one material on another (specification 5f; figures in material.cc).
struct FrictionOptions {
  double coefficient = 0.25;         ///< mu, static = kinetic
  double stiffness_n_per_m = 600.0;  ///< k of the bristle
  double damping_n_s_per_m = 2.0;    ///< d of the bristle
};

/// Dry friction that depends on where the pen has been, not on the sign of its speed (R13, R41,
/// R42): the pen hangs on a bristle whose foot w stands on the sheet.
///
///   z = p - w,  kept to |z| <= mu Fn / k by moving w along
///   F = -k z - d v,  shortened to |F| <= mu Fn          (Fn = memory.normal_force_n)
///
/// Below the limit the foot stands still, hence no drift however long the hand leans on it; at the
/// limit it follows, hence F = mu Fn in every steady slide. Static friction equals kinetic: low
/// stiction helps aiming, high stiction hurts (Richard and Cutkosky 2000). A friction that is a
/// function of the speed buzzes at rest instead (0.17-0.58 N above 30 Hz; decision 6).
///
/// v is the known velocity (pen_sample.h).
///
/// The damper acts on the speed of the pen, not on dz/dt: where the foot is moved along, dz/dt
/// jumps and flips the force (devices.md 10.3: spikes of -1.2 N). While sliding, the shortening
/// takes the damper's part away again. No push of the plane: no friction, and the foot is lifted.
///
/// memory.scale.friction takes from k and d alike; memory.friction_factor (a texture before this
/// brick) multiplies mu for one tick and is reported as the term "texture".
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
