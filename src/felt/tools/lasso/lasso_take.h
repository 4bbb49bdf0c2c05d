#pragma once

#include <cstdint>

#include "felt/document/document.h"
#include "felt/document/selection.h"
#include "felt/document/stroke_index.h"
#include "felt/tools/lasso/lasso_area.h"

namespace felt {

/// Which parts of strokes a lasso selects.
///
/// kParts is for people who see ink and not control points: a stroke that lies inside, or leaves
/// the area by at most kTailShare of its length, is selected whole. If more of a stroke is outside,
/// only its control points inside are selected, like kPoints; a stroke whose ink is all outside is
/// not selected.
enum class LassoTake : std::uint8_t {
  kParts,
  kStrokes,  ///< each whole stroke that is at least partly inside
  kPoints,   ///< each control point inside (as in the paper)
  kOnCurve,  ///< each joint and end inside, with its handles
};

/// The share of a stroke outside a loop that counts as drawn around (LassoTake::kParts). Loops
/// drawn by hand cut off the tips of lines that were meant; a line that leads out of the loop to
/// another part of the drawing has more of its length outside.
inline constexpr double kTailShare = 0.1;

/// How the lasso combines the previous selection with the new one.
enum class LassoCombine : std::uint8_t { kReplace, kAdd, kSubtract };

/// Returns the marks that a lasso sets on a stroke, before close_marks is applied (R31).
Selection::Marks marks_inside(const Stroke& stroke, const LassoArea& area, LassoTake take);

/// Returns the selection that the lasso makes among the editable strokes, after close_marks is
/// applied (R32). With kPoints, handles inside the area are selected even if all of the ink is
/// outside.
Selection taken_by(const LassoArea& area, LassoTake take, const Document& document,
                   const StrokeIndex& index);

/// Returns the combined selection, after close_marks is applied. With kAdd, a stroke that is in
/// only one of `before` and `taken` keeps its marks. With kSubtract, a stroke that is only in
/// `taken` is ignored.
Selection combined(const Document& document, const Selection& before, const Selection& taken,
                   LassoCombine combine);

}  // namespace felt
