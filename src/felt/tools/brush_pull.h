#pragma once

#include <array>
#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/tools/brush_reach.h"

namespace felt {

/// Pulls a stroke at one point with a brush: the grabbed point moves by a given displacement, the
/// influence falls off along the ink, and ink beyond the reach does not move
/// (docs/design/editing.md#brush; R21, R23, R24, R26, R28). The stroke f becomes g, with V the
/// displacement of the grabbed point since the touch, w the influence (brush_reach.h) and s the arc
/// length in the stroke at the touch:
///
///   g(t) = f(t) + V w(s(t)),   g' = f' + V w' |f'|
///
/// The stroke is cut once, by the constructor: at both ends of the influence, at the grab, and
/// within segments over which one cubic cannot approximate w(s(t)). Each piece of the result is the
/// cubic that has the position and derivative of g at both ends (Hermite interpolation). The result
/// is linear in V: every control point moves by V times a weight that is computed at the touch. So
/// at() does one multiplication per control point, and the result depends on V only, not on the
/// path of the pen or the sample rate. Derivatives on both sides of a smooth joint stay parallel
/// because both are multiplied by the same expression (1 + V w' ...).
///
/// If the stroke is pulled along itself by more than radius/1.5, the ink folds back like a rope
/// that is pushed. The ink still follows the pen, and all invariants hold. Each piece of ink keeps
/// its width.
class BrushPull {
 public:
  /// Prepares a pull at u0, clamped to the stroke. Takes time linear in the segments of the stroke.
  BrushPull(StrokePtr snapshot, double u0, const BrushOptions& options = {});

  /// Returns the stroke with the grabbed point displaced by this vector, in mm, or exactly the
  /// snapshot for 0. Ink that is compressed below the length that I5 requires keeps handles of at
  /// least 0.03 mm. Fails if the displacement is not finite.
  [[nodiscard]] Result<Stroke> at(Vec displacement) const;
  /// Returns the stroke to commit: the same stroke with as few segments as the tolerance allows.
  /// The curve still passes exactly through the pen.
  [[nodiscard]] Result<Stroke> finished(Vec displacement) const;

  /// Returns the grabbed point, in the snapshot.
  [[nodiscard]] Point origin() const noexcept { return origin_; }
  /// Return the start and the end of the moving part of the snapshot, as parameters; this part may
  /// be the whole stroke. On a closed stroke, last <= first means that the part crosses the seam.
  [[nodiscard]] double first_u() const noexcept { return first_u_; }
  [[nodiscard]] double last_u() const noexcept { return last_u_; }
  /// Return the joints at which the moving part begins and ends on strokes made by at().
  [[nodiscard]] int first_joint() const noexcept { return joints_.first; }
  [[nodiscard]] int last_joint() const noexcept { return joints_.last; }

 private:
  /// Joints of base_, by number.
  struct Joints {
    int first = 0, held_first = 0, grab = 0, held_last = 0, last = 0;
  };
  /// The influence over one segment as a cubic in t, by control point.
  struct Run {
    int segment = 0;
    double sign = 1.0;  ///< +1 if the distance from the grab grows with t
    /// Arc lengths from the grab to the near end of the segment, and to the point where w = 0.
    double start_mm = 0.0, radius_mm = 0.0;
    std::array<double, 4> weights{};  ///< w by control point, near end first
  };

  void cut(std::span<const double> places, std::span<const double> more);
  void plan(const BrushReach& reach);
  void add_runs(int count, const BrushSide& side, double sign);
  [[nodiscard]] std::vector<double> crooked(double largest_error) const;
  void weigh(bool is_whole);
  void find_grab();
  [[nodiscard]] Result<Stroke> with_free_joints(const Stroke& pulled, int finer) const;
  void pull(StrokeData& data, Vec displacement) const;
  void keep_all_smooth(StrokeData& data) const;
  bool keep_lengths(StrokeData& data) const;
  void follow_exactly(StrokeData& data, Point target) const;
  [[nodiscard]] int count() const noexcept { return static_cast<int>(base_.points.size() / 3); }
  [[nodiscard]] int wrapped(int i) const noexcept { return (i % count() + count()) % count(); }
  [[nodiscard]] Cubic segment(int i) const noexcept;

  StrokePtr snapshot_;
  Point origin_;
  double tolerance_mm_;
  double first_u_ = 0.0, last_u_ = 0.0;
  StrokeData base_;  // the snapshot with the cuts
  Joints joints_;
  std::vector<Run> runs_;        // segments over which the influence falls off
  std::vector<double> weights_;  // w of each control point
  int grab_segment_ = 0;         // parameter of the grab, usually an end of the segment
  double grab_t_ = 0.0;
};

}  // namespace felt
