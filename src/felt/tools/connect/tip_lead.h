#pragma once

#include <optional>

#include "felt/stroke/stroke.h"

namespace felt {

/// Moves one end of a stroke to other points, always starting from the original stroke, so that
/// intermediate positions do not matter. The constructor does the preparation, once per gesture;
/// all other functions are pure.
///
/// The stroke stays one fair curve (docs/design/editing.md#joining; R45). The part of the
/// shift straight ahead extends the stroke along its tangent. The remaining shift bends the stroke
/// (with_tip_bent) over a length of four times that shift, at least 25 mm and at most the extension
/// plus half of the stroke. If that maximum is less than 2.7 times the remaining shift, the length
/// is 2.7 times the remaining shift instead, but at most the extension plus 200 mm or 95 % of the
/// stroke. If that bend fails, the stroke does not change, and one cubic along its tangent, with
/// zero curvature at its end, bridges the gap. If the gap is at most `small_gap_mm`, the end keeps
/// its tangent; for wider gaps it turns gradually towards the target.
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

  /// Returns the same for an end that must continue in the direction `arrival` (a unit vector) at
  /// the target. If the gap is more than small_gap_mm, it arrives in this direction: along the bent
  /// stroke or, if that has less bending energy, along one cubic from the unchanged stroke.
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
