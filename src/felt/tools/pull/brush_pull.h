#pragma once

#include <array>
#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/tools/pull/brush_reach.h"

namespace felt {

/// A stroke pulled at one place by a brush: what is under the pen follows it exactly, the influence
/// falls off along the ink, nothing beyond moves (architecture section 10; decisions 1 and 2; R21,
/// R23, R24, R26, R28). With V the displacement of the pen since the touch and s the arc length in
/// the stroke at the touch,
///
///   g(t) = f(t) + V w(s(t)),   g' = f' + V w' |f'|
///
/// The stroke is cut once where the influence begins and ends, at the grab, and where w(s(t)) is
/// too crooked for one cubic; then each piece takes place and derivative of g at both its ends, its
/// Hermite interpolant. This is linear in V: every control point moves by its own number times V,
/// which is prepared at the touch, so a sample costs one multiplication per control point, and the
/// result depends on V only, not on the way or the rate of the samples. Derivatives on both sides
/// of a smooth joint stay parallel since both become f'(1 + V w' ...) of the same direction.
///
/// Pulled along the ink by more than radius/1.5 the ink folds back on itself, as a rope does that
/// is pushed: the pen is followed all the same, and all invariants hold. Widths stay with the ink.
class BrushPull {
 public:
  /// u0 is clamped to the stroke. Linear in the segments of the stroke.
  BrushPull(StrokePtr snapshot, double u0, const BrushOptions& options = {});

  /// The stroke with the grab displaced by that much, mm; the very snapshot at 0. Ink that is
  /// pushed together to less than I5 allows keeps handles of a hundredth of a millimetre or three.
  /// Error: not finite.
  [[nodiscard]] Result<Stroke> at(Vec displacement) const;
  /// The same with as few segments as the tolerance allows: what is committed. The curve goes
  /// through the pen still, exactly, whether there is a joint or not.
  [[nodiscard]] Result<Stroke> finished(Vec displacement) const;

  /// The place that was taken hold of, in the snapshot.
  [[nodiscard]] Point origin() const noexcept { return origin_; }
  /// The part of the snapshot that moves; on a closed stroke last <= first goes through the seam,
  /// and a stroke that moves as a whole is all of it.
  [[nodiscard]] double first_u() const noexcept { return first_u_; }
  [[nodiscard]] double last_u() const noexcept { return last_u_; }
  /// The same on strokes made by at(), as numbers of joints.
  [[nodiscard]] int first_joint() const noexcept { return joints_.first; }
  [[nodiscard]] int last_joint() const noexcept { return joints_.last; }

 private:
  /// Joints of base_, by number.
  struct Joints {
    int first = 0, held_first = 0, grab = 0, held_last = 0, last = 0;
  };
  /// How the influence runs over one segment: its values as a cubic in t, by control point.
  struct Run {
    int segment = 0;
    double sign = 1.0;                       ///< +1 when ways grow with t
    double start_mm = 0.0, radius_mm = 0.0;  ///< way to its near end, and where w is 0
    std::array<double, 4> weights{};         ///< from its near end to its far end
  };

  void cut(std::span<const double> places, std::span<const double> more);
  void plan(const BrushReach& reach);
  void add_runs(int count, const BrushSide& side, double sign);
  [[nodiscard]] std::vector<double> crooked(double most_error) const;
  void stand_up();
  void weigh(bool is_whole);
  void find_grab();
  [[nodiscard]] Result<Stroke> with_free_joints(const Stroke& pulled, int finer) const;
  void pull(StrokeData& data, Vec displacement) const;
  void keep_smooth(StrokeData& data, int joint) const;
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
  std::vector<Run> runs_;        // what falls off
  std::vector<double> weights_;  // of each control point
  int grab_segment_ = 0;         // place of the grab, usually one of its ends
  double grab_t_ = 0.0;
};

}  // namespace felt
