#pragma once

#include <vector>

#include "felt/fill/document_map.h"
#include "felt/fill/follow_fill.h"

namespace felt {

/// Returns how an edit changed the strokes that are the boundary of fills: for each stroke that it
/// divided, joined or removed, the strokes that lie where it was.
std::vector<LineEdit> line_edits(const Edit& edit);

/// Returns the changes of the fills whose boundary the edit changes, so that they follow it as
/// follow_fill() says. `map` must have been made with kAllStrokes. Fills of locked layers, fills
/// that the edit itself changes, and layers in which it adds, removes or moves fills are left out,
/// and all fills if too many strokes are near (DocumentMap::kMaxNearStrokes).
std::vector<FillChange> following_fills(const Document& document, const Edit& edit,
                                        DocumentMap& map, WhenOpened when_opened);

}  // namespace felt
