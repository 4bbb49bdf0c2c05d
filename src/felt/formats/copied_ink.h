#pragma once

#include <functional>

#include "felt/document/drawing.h"
#include "felt/document/visible_strokes.h"
#include "felt/geometry/point.h"
#include "felt/session/session.h"

namespace felt {

/// Returns what a copy command puts on the clipboard: a drawing of one layer, with the visible
/// strokes for which `is_copied` is true and the fills between them. If nothing is selected, fills
/// without strokes are copied, too. The drawing contains the present texts of media that Feltline
/// does not ship, because the user may change them before the paste, or paste elsewhere.
Drawing copied_drawing(const Session& session, const std::function<bool(StrokeId)>& is_copied);

/// Returns strokes and fills moved by `by_mm`. A stroke that leaves the range of coordinates stays
/// where it is.
VisibleInk moved_ink(VisibleInk ink, Vec by_mm);

}  // namespace felt
