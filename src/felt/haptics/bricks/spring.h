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
  double damping_n_s_per_m = 1.0;  ///< Bed, on the known velocity (pen_sample.h)
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

/// Where a curve is that gives way to the pen, as a tool saw it at its last sample.
struct CurveNear {
  Point pen{};               ///< the pen at that sample
  Point curve{};             ///< the point of the curve nearest to it
  Vec normal{};              ///< unit, across the curve there; unused if is_end
  bool is_end = false;       ///< an end or a corner: the pen may be off it in any direction
  std::int64_t time_ns = 0;  ///< of that sample
};

/// Draws the pen to a curve that gives way with a time constant (R29, eq. 8; specification 5d,
/// "sweep"): F = -phi(|V|) V/|V| - Bed v_n, with V from the curve to the pen and v_n the velocity
/// across the curve. Moving along a curve that does not change gives no force.
///
/// The tool publishes the curve every few milliseconds. Between two publications the curve goes on
/// giving way as the tool will see it, V' = v - V/tau, solved for a pen that moved straight from
/// there to here; so the force depends on neither rate (R30), and nothing is remembered. Samples
/// must be in session time, as `curve.time_ns` is (Servo::set_session_offset). A
/// nonlinear Maxwell element: F v = dU/dt + phi(d) d/tau, so the hand gets back less than it gave.
class SweepSpring {
 public:
  explicit SweepSpring(const CurveNear& curve, const EditOptions& options = {},
                       double time_constant_s = 0.050) noexcept
      : curve_(curve), options_(options), time_constant_s_(time_constant_s) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  [[nodiscard]] Slopes slopes() const noexcept;

 private:
  CurveNear curve_;
  EditOptions options_;
  double time_constant_s_;
};

/// A line under a nib that pushes it, as a tool saw it at its last sample.
struct LineUnderNib {
  Point pen{};                   ///< the pen at that sample
  Vec normal{};                  ///< unit, from the line to the pen; zero if nothing is near
  double gap_mm = 0.0;           ///< between the nib and the line
  double displacement_mm = 0.0;  ///< how far the line has been pushed there
  double share = 1.0;            ///< 0..1, less where lines push from opposite sides
};

/// Resists a nib that pushes lines (R29, eq. 8): by phi(d) against the normal, with d the
/// displacement of the pushed line. A line stays where it was pushed, so the force holds while the
/// nib rests on it, and falls to zero within phi(d)/Kcap when the nib leaves: work done on the line
/// is not given back but for that last bit.
class PushSpring {
 public:
  explicit PushSpring(const LineUnderNib& line, const EditOptions& options = {}) noexcept
      : line_(line), options_(options) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  [[nodiscard]] Slopes slopes() const noexcept;

 private:
  LineUnderNib line_;
  EditOptions options_;
};

/// -phi(|V|) V/|V| - share b v: what the springs here and in the stabiliser share, N. A share of
/// the stiffness budget below 1 (R56) makes the spring at the start softer and leaves the level of
/// the law as it is, so that a slow loop resists as much as a quick one (R30).
Force pull_back(const ForceLaw& law, Vec displacement_mm, double damping_n_s_per_m,
                Vec velocity_mm_per_s, double share) noexcept;

}  // namespace felt
