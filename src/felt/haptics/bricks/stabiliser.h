#pragma once

#include "felt/geometry/point.h"
#include "felt/haptics/force.h"
#include "felt/haptics/force_law.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// A nib on a short rope behind the pen: towed (drag) drawing, which steadies curves where friction
/// alone does not (Keefe 2007, by peers.md).
struct TowOptions {
  double rope_mm = 4.0;             ///< slack within which nothing is felt and the nib rests
  double time_constant_s = 0.020;   ///< how the nib gives way to a taut rope
  ForceLaw law{.spread_mm = 10.0};  ///< pull of the rope by its stretch
  double damping_n_s_per_m = 1.0;   ///< while taut
};

/// Where the nib is a tick later: it moves along the rope when that is taut, by e dt/(tau + dt)
/// with e = |pen - nib| - rope (backward Euler). Tool and force call the same function, so the line
/// that is drawn and the pull that is felt agree.
Point towed_nib(const TowOptions& options, Point nib, Point pen, double dt_s) noexcept;

/// The pull of the rope: none while it is slack, then F = -phi(e), e the stretch beyond the rope.
/// The nib gives way like a dashpot, so pen and nib form a Maxwell element (see SweepSpring): the
/// force depends on the speed of the drawing, not on the rate of the loop, and is passive. The nib
/// starts under the pen at each landing.
class Towed {
 public:
  explicit Towed(const TowOptions& options = {}) noexcept : options_(options) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  [[nodiscard]] Slopes slopes() const noexcept;

 private:
  TowOptions options_;
};

/// A heavier nib: a mass that the pen pulls along by a spring and a damper.
struct InertiaOptions {
  double mass_kg = 0.05;
  double stiffness_n_per_m = 300.0;  ///< of the coupling, 300..800
  double damping_n_s_per_m = 2.0;    ///< of the coupling
  double drag_n_s_per_m = 1.5;       ///< on the mass: it comes to rest without ringing
  double max_force_n = 1.0;          ///< the coupling slips above
};

/// One tick of the mass, moved in place; returns the pull of the coupling on the mass, N.
///
///   m u' = K (p - q) + B (v - u) - c u,   q' = u
///
/// by backward Euler, which takes energy at every period and never adds any. The coupling slips
/// for mass and hand alike, so what one does not feel the other does not get.
Vec move_mass(const InertiaOptions& options, Follower& mass, Point pen, Vec pen_velocity_mm_per_s,
              double dt_s) noexcept;

/// Virtual inertia by a virtual coupling. Never F = m a: on an impedance device the measured
/// acceleration is noise and delay (devices.md 10.1). The mass starts under the pen, at its speed,
/// at each landing.
class Inertia {
 public:
  explicit Inertia(const InertiaOptions& options = {}) noexcept : options_(options) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  [[nodiscard]] Slopes slopes() const noexcept;

 private:
  InertiaOptions options_;
};

}  // namespace felt
