#pragma once

#include <cstdint>

#include "felt/geometry/point.h"
#include "felt/haptics/force.h"
#include "felt/haptics/force_law.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// What an edit feels like while its gesture lasts.
struct EditOptions {
  ForceLaw law = kEditLaw;
  double damping_n_s_per_m = 1.0;  ///< Bed, on the known velocity (known_velocity.h)
};

/// Draws the pen back to where it took hold (R29, R30; specification 5d, "grab"):
///
///   F = -phi(|V|) V/|V| - Bed v,   V = pen - origin, in the sheet
///
/// V is the total displacement: the force is conservative but for the damping, hence passive, and
/// does not depend on the loop's rate. Publish it while the gesture lasts and only then.
class EditSpring {
 public:
  explicit EditSpring(Point origin, const EditOptions& options = {}) noexcept
      : origin_(origin), options_(options) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  [[nodiscard]] Slopes slopes() const noexcept;

 private:
  Point origin_;
  EditOptions options_;
};

/// Draws the pen back to a curve that follows it (specification 5d, "sweep"): the curve point c
/// gives way with a time constant, c' = V/tau, V = pen - c.
///
/// A nonlinear Maxwell element: F v = dU/dt + phi(d) d/tau with both d and tau positive, so the
/// hand gets back less than it gave. Implicit Euler makes V = v tau exact in steady motion at any
/// rate (R30: rate-free); per-tick displacements would make the force fall with the rate (decision
/// 3). Another `gesture` starts with c under the pen.
class SweepSpring {
 public:
  SweepSpring(std::uint32_t gesture, const EditOptions& options = {},
              double time_constant_s = 0.050) noexcept
      : options_(options), time_constant_s_(time_constant_s), gesture_(gesture) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  [[nodiscard]] Slopes slopes() const noexcept;

 private:
  EditOptions options_;
  double time_constant_s_;
  std::uint32_t gesture_;
};

/// -gain phi(|V|) V/|V| - gain b v: what the springs here and in the stabiliser share. N.
Force pull_back(const ForceLaw& law, Vec displacement_mm, double damping_n_s_per_m,
                Vec velocity_mm_per_s, double gain) noexcept;

}  // namespace felt
