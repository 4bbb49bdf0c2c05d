#pragma once

#include <cstdint>

#include "felt/geometry/point.h"
#include "felt/haptics/force.h"
#include "felt/haptics/force_law.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// Parameters of the force that an edit exerts during its gesture.
struct EditOptions {
  ForceLaw law = kEditLaw;
  double damping_n_s_per_m = 1.0;  ///< Bed, multiplied by known_velocity()
};

/// Pulls the pen back to `origin`, the point at which the gesture grabbed a line (R29, R30;
/// docs/design/forces.md#edit-springs):
///
///   F = -phi(|V|) V/|V| - Bed v,   V = pen - origin, along the surface
///
/// V is the total displacement, and phi is the force law. Apart from its damping, the force is
/// conservative; it is therefore passive. It does not depend on the loop's rate. Publish it only
/// while the gesture lasts.
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

/// The part of a yielding curve that is near the pen, as a tool saw it at its last sample.
struct CurveNear {
  Point pen{};               ///< the pen at that sample
  Point curve{};             ///< the point of the curve nearest to the pen
  Vec normal{};              ///< unit normal of the curve at that point; unused if is_end
  bool is_end = false;       ///< an end or a corner: the pen may deviate in any direction
  std::int64_t time_ns = 0;  ///< time of that sample
};

/// Pulls the pen towards a curve that yields with a time constant (R29, eq. 8;
/// docs/design/forces.md#edit-springs): F = -phi(|V|) V/|V| - Bed v_n, with V from the curve to the
/// pen and v_n the velocity across the curve. Moving along a curve that does not change causes no
/// force.
///
/// The tool publishes the curve every few milliseconds. Between two publications the force assumes
/// that the curve continues to yield as the tool will compute it: V' = v - V/tau, solved for a pen
/// that has moved in a straight line since the publication. So the force does not depend on the
/// rate of the loop or of the publications (R30), and it needs no memory. Samples must be in
/// session time, as `curve.time_ns` is (Servo::set_session_offset). This is a nonlinear Maxwell
/// element: F v = dU/dt + phi(d) d/tau, so the hand gets back less energy than it has put in.
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

/// A line that a nib pushes, as a tool saw it at its last sample.
struct LineUnderNib {
  Point pen{};                   ///< the pen at that sample
  Vec normal{};                  ///< unit vector from the line to the pen; zero if no line is near
  double gap_mm = 0.0;           ///< between the nib and the line
  double displacement_mm = 0.0;  ///< by how much the nearest point of the line was pushed
  double share = 1.0;            ///< factor of the force; below 1 if lines push from opposite sides
};

/// Resists a nib that pushes lines (R29, eq. 8). The force is phi(d) along the normal, where d is
/// the displacement of the pushed line. A pushed line does not move back, so the force remains
/// while the nib rests against it, and falls to zero within a distance of phi(d)/Kcap when the nib
/// leaves. So the line returns work to the hand only over that distance.
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

/// Returns -phi(|V|) V/|V| - share b v in N: the force that springs here and in the stabiliser have
/// in common. A share of the stiffness budget below 1 (R56) softens the spring near 0 and leaves
/// the level of the force law unchanged, so that a slow loop resists as strongly as a fast one
/// (R30).
Force pull_back(const ForceLaw& law, Vec displacement_mm, double damping_n_s_per_m,
                Vec velocity_mm_per_s, double share) noexcept;

}  // namespace felt
