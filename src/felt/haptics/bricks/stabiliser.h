#pragma once

#include "felt/geometry/point.h"
#include "felt/haptics/force.h"
#include "felt/haptics/force_law.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// Parameters of a nib on a short rope behind the pen: towed (drag) drawing. Towing steadies curves
/// that friction alone does not steady (Keefe 2007, docs/design/forces.md#stabilisers).
struct TowOptions {
  /// Within this distance the rope is slack: no force, and the nib rests.
  double rope_mm = 4.0;
  /// Time constant of the motion of the nib towards the pen when the rope is taut.
  double time_constant_s = 0.020;
  ForceLaw law{.spread_mm = 10.0};  ///< pull of the rope as a function of its stretch
  double damping_n_s_per_m = 1.0;   ///< acts only while the rope is taut
};

/// Returns the position of the nib one tick later. If the rope is taut, the nib moves along it by e
/// dt/(tau + dt) with e = |pen - nib| - rope (backward Euler). The tool and the force call the same
/// function, so that the drawn line and the pull on the hand agree.
Point towed_nib(const TowOptions& options, Point nib, Point pen, double dt_s) noexcept;

/// The pull of the rope: zero while the rope is slack, otherwise F = -phi(e), where e is the
/// stretch of the rope. The nib yields like a dashpot, so pen and nib form a Maxwell element (see
/// SweepSpring): the force depends on the speed of drawing and not on the rate of the loop, and is
/// passive. At each landing the nib starts under the pen.
class Towed {
 public:
  explicit Towed(const TowOptions& options = {}) noexcept : options_(options) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  [[nodiscard]] Slopes slopes() const noexcept;

 private:
  TowOptions options_;
};

/// Parameters of a heavier nib: a mass that the pen pulls by a spring and a damper.
struct InertiaOptions {
  double mass_kg = 0.05;
  double stiffness_n_per_m = 300.0;  ///< stiffness of the coupling, 300..800
  double damping_n_s_per_m = 2.0;    ///< damping of the coupling
  double drag_n_s_per_m = 1.5;       ///< drag on the mass, so that it comes to rest without ringing
  double max_force_n = 1.0;          ///< above this force the coupling slips
};

/// Moves the mass by one tick, in place. Returns the pull of the coupling on the mass, N.
///
///   m u' = K (p - q) + B (v - u) - c u,   q' = u
///
/// Here q and u are the position and velocity of the mass, p and v are those of the pen, K and B
/// belong to the coupling, and c is the drag. The function uses backward Euler, which may remove
/// energy in a tick but never adds any. When the coupling slips, its limited pull acts both on the
/// mass and on the hand.
Vec move_mass(const InertiaOptions& options, Follower& mass, Point pen, Vec pen_velocity_mm_per_s,
              double dt_s) noexcept;

/// Virtual inertia by a virtual coupling. The force is never computed as m a, because the
/// acceleration measured on an impedance device is noisy and delayed
/// (docs/design/forces.md#stabilisers). At each landing the mass starts under the pen, with the
/// pen's velocity.
class Inertia {
 public:
  explicit Inertia(const InertiaOptions& options = {}) noexcept : options_(options) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  [[nodiscard]] Slopes slopes() const noexcept;

 private:
  InertiaOptions options_;
};

}  // namespace felt
