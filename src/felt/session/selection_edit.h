#pragma once

#include <optional>
#include <string>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/document/selection.h"
#include "felt/session/event.h"

namespace felt {

/// How far a duplicate lies from its original, to the right and down.
inline constexpr double kDuplicateShiftMm = 5.0;

/// The selection that a select event makes of another. Strokes of visible, unlocked layers only.
Selection selected(const Document& document, const Selection& before, SelectStrokes::What what);

/// Removes the strokes that are wholly selected; of those selected in part nothing goes, for what a
/// stroke would be without some of its control points nobody can see beforehand. Empty where there
/// are none.
Edit delete_edit(const Document& document, const Selection& selection);

/// Copies of the strokes that are wholly selected, shifted, on top of their layers in drawing
/// order. Empty where there are none. Error: a shifted stroke breaks an invariant, so far out that
/// its joints are lost to rounding; the message names the stroke.
Result<Edit> duplicate_edit(const Document& document, const Selection& selection);

/// The strokes that are selected, wholly or in part, in another colour or of another medium ("" is
/// none). Empty if they are so already.
Result<Edit> restyle_edit(const Document& document, const Selection& selection,
                          std::optional<Rgba> color, const std::string& medium);

/// All strokes that an edit makes, whole.
Selection made_by(const Edit& edit);

}  // namespace felt
