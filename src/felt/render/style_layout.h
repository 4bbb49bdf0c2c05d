#pragma once

#include <vector>

#include "felt/render/style_spine.h"

namespace felt {

/// A part of a line, in widths from its start. On a closed line, `to` may be beyond the end, where
/// the line begins again.
struct StyleSpan {
  double from = 0.0, to = 0.0;

  friend bool operator==(const StyleSpan&, const StyleSpan&) = default;
};

/// How dashes or repeats are laid out, in widths of the line.
struct StyleRhythm {
  double length = 3.0;  ///< above 0
  double gap = 1.5;     ///< 0 or more
  /// Dashes have round ends of this diameter, which count as a part of the dash.
  double cap = 0.0;
  double max_count = 16'384;  ///< of spans; longer rhythms are used if there would be more
};

/// Returns the centre lines of dashes on the part `range` of a line. Each part between corners or
/// ends has a whole number of dashes: a whole dash at an end, half a dash at a corner, where it
/// meets the other half. Lengths and gaps are scaled by the same factor to fit. A dash shorter than
/// its cap is a dot (from = to).
std::vector<StyleSpan> dash_spans(const Spine& spine, StyleSpan range, const StyleRhythm& rhythm);

/// Returns the spans of repeated shapes on the part `range` of a line: a whole number on each part
/// between corners or ends, with gaps only in between. On a closed line without corners, a gap
/// follows every shape.
std::vector<StyleSpan> repeat_spans(const Spine& spine, StyleSpan range, const StyleRhythm& rhythm);

}  // namespace felt
