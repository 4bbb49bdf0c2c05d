#pragma once

#include <optional>

#include "felt/stroke/stroke.h"

namespace felt {

/// Moves one end of a stroke to other points, always starting from the original stroke, so that
/// intermediate positions do not matter. The constructor does the preparation, once per gesture;
/// all other functions are pure.
///
/// The stroke stays one fair curve (docs/design/editing.md#joining; R45). If the target lies ahead
/// of the end, the stroke is first extended straight along its tangent by the distance a, until the
/// target is beside the new end. The remaining shift s then bends the stroke (with_tip_bent) over
/// the length max(min(max(25, 4 s), a + 0.5 L), min(2.7 s, a + min(0.95 L, 200))), in mm, with L
/// the length of the stroke. If this bend fails, the stroke does not change, and one cubic that
/// begins along its tangent and ends with zero curvature bridges the gap. If the gap is at most
/// `small_gap_mm`, the end keeps its tangent. If the gap is wider, the end turns towards the
/// target, and it turns more for a wider gap.
///
/// If a stroke has many segments, only a part at the end is changed; the remaining stroke stays bit
/// for bit.
class TipLead {
 public:
  static constexpr double kMinFadeMm = 25.0;
  static constexpr double kMaxFadeMm = 200.0;
  static constexpr double kFadePerShift = 4.0;
  static constexpr double kMinFadePerShift = 2.7;
  static constexpr double kMaxSmallGapMm = 6.0;

  /// Prepares to move one end of a stroke. Requires an open stroke.
  TipLead(const Stroke& stroke, StrokeTip tip);

  /// Returns the stroke with its end exactly at `target`. Fails if the target is not finite, or if
  /// a segment would become too short (I5).
  [[nodiscard]] Result<Stroke> at(Point target) const;

  /// Like at(target), but if the gap is more than small_gap_mm, the end arrives at the target in
  /// the direction `arrival` (a unit vector). The result is then the unchanged stroke extended by
  /// one cubic. Exception: if `arrival` differs by less than kSmoothJoinBelowDeg from the direction
  /// of the end, and bending the stroke takes less bending energy, the result is the bent stroke.
  [[nodiscard]] Result<Stroke> at(Point target, Vec arrival) const;

  /// Returns an eighth of the length of the stroke, at most 6 mm.
  [[nodiscard]] double small_gap_mm() const { return small_gap_mm_; }

 private:
  [[nodiscard]] Result<Stroke> bent(Point target, std::optional<Vec> arrival) const;
  [[nodiscard]] Result<Stroke> whole(const Result<Stroke>& part) const;

  StrokeTip tip_;
  Stroke part_;      // the part that may change: the stroke, or enough of its end
  StrokeData rest_;  // the remaining stroke; empty if part_ is the whole stroke
  JointKind joint_ = JointKind::kSmooth;  // joint between part_ and rest_
  double length_mm_;                      // length of part_
  double small_gap_mm_;
};

}  // namespace felt
