#pragma once

#include "felt/stroke/stroke.h"
#include "felt/stroke/stroke_tip.h"

namespace felt {

/// Leads one end of a stroke to other places, always from the stroke as it was: where the end has
/// been in between does not matter. Pure but for what is prepared once a gesture.
///
/// The end bends the stroke as far as that looks natural, and the stroke grows the rest of the way:
///   - up to a quarter of the stroke, and 50 mm: with_tip_bent, the shift fading along four times
///     itself, at least 25 mm (architecture section 10), at most half of the stroke;
///   - what is missing is a straight piece of the width of the end, its joint as in `joined`.
///
/// Of a stroke of many segments only a part at the end is worked on; the rest stays bit for bit.
class TipLead {
 public:
  static constexpr double kLeastFadeMm = 25.0;
  static constexpr double kMostBendMm = 50.0;
  static constexpr double kFadePerShift = 4.0;

  /// Requires an open stroke.
  TipLead(const Stroke& stroke, StrokeTip tip);

  /// The stroke with its end exactly there. Error: the place is not finite, or a segment would
  /// become too short (I5).
  [[nodiscard]] Result<Stroke> at(Point target) const;

 private:
  [[nodiscard]] Result<Stroke> bent_and_grown(Point target) const;
  [[nodiscard]] Result<Stroke> whole(const Stroke& part) const;

  StrokeTip tip_;
  Stroke part_;                           // what may change: the stroke, or enough of it at the end
  StrokeData rest_;                       // without points when there is none
  JointKind joint_ = JointKind::kSmooth;  // between them
  double length_mm_;                      // of the part
  double most_bend_mm_;
};

}  // namespace felt
