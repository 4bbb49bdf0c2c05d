#pragma once

#include <cstdint>

#include "felt/document/document.h"
#include "felt/document/selection.h"
#include "felt/document/stroke_index.h"
#include "felt/tools/lasso/lasso_area.h"

namespace felt {

/// What of the strokes a lasso takes.
enum class LassoTake : std::uint8_t {
  kPoints,   ///< each control point that is inside (the paper's way)
  kOnCurve,  ///< each joint and end that is inside, and the handles that belong to it
  kStrokes,  ///< the whole of each stroke of which any part is inside
};

/// What becomes of what was selected before.
enum class LassoCombine : std::uint8_t { kReplace, kAdd, kSubtract };

/// The marks that a lasso makes on a stroke, before close_marks (R31).
Selection::Marks marks_inside(const Stroke& stroke, const LassoArea& area, LassoTake take);

/// What the lasso takes of the strokes that may be edited, closed by close_marks (R32). kPoints
/// takes handles inside as well if all of the ink is outside.
Selection taken_by(const LassoArea& area, LassoTake take, const Document& document,
                   const StrokeIndex& index);

/// What is selected then. Marks are closed again; strokes that are in one of both only keep theirs.
Selection combined(const Document& document, const Selection& before, const Selection& taken,
                   LassoCombine combine);

}  // namespace felt
