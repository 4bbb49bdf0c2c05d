#pragma once

#include <optional>

#include "felt/stroke/stroke.h"

namespace felt {

/// Moves one end of a stroke to other points, always from the stroke as it was: where the end has
/// been in between does not matter. Pure, except for what is prepared once per gesture.
///
/// The stroke stays one fair curve (specification 5g; R45). Of the shift, the part straight ahead
/// prolongs the stroke along its tangent. The rest bends it (with_tip_bent) over four times that
/// rest, at least 25 mm, and at most half of the stroke and what was prolonged; over 2.7 times that
/// rest where half of the stroke is not enough, up to 200 mm. If that is not enough either, the
/// stroke stays as it is and one cubic along its tangent, uncurved at its end, covers the gap. Up
/// to `small_gap_mm` the end keeps its tangent; beyond it turns gradually towards the target.
///
/// Of a stroke of many segments only a part at the end is changed; the rest stays bit for bit.
class TipLead {
 public:
  static constexpr double kMinFadeMm = 25.0;
  static constexpr double kMaxFadeMm = 200.0;
  static constexpr double kFadePerShift = 4.0;
  static constexpr double kMinFadePerShift = 2.7;
  static constexpr double kMaxSmallGapMm = 6.0;

  /// Requires an open stroke.
  TipLead(const Stroke& stroke, StrokeTip tip);

  /// Returns the stroke with its end exactly at `target`. Fails if the target is not finite, or if
  /// a segment would become too short (I5).
  [[nodiscard]] Result<Stroke> at(Point target) const;

  /// The same, for an end that is to go on in the direction `arrival` (a unit vector) at the
  /// target. Over more than small_gap_mm it arrives in this direction: along the bent stroke or, if
  /// that has less bending energy, along one cubic from the unchanged stroke.
  [[nodiscard]] Result<Stroke> at(Point target, Vec arrival) const;

  /// An eighth of the stroke, but not more than 6 mm.
  [[nodiscard]] double small_gap_mm() const { return small_gap_mm_; }

 private:
  [[nodiscard]] Result<Stroke> bent(Point target, std::optional<Vec> arrival) const;
  [[nodiscard]] Result<Stroke> whole(const Result<Stroke>& part) const;

  StrokeTip tip_;
  Stroke part_;                           // what may change: the stroke, or enough of it at the end
  StrokeData rest_;                       // without points when there is none
  JointKind joint_ = JointKind::kSmooth;  // between them
  double length_mm_;                      // of the part
  double small_gap_mm_;
};

}  // namespace felt
