#pragma once

#include <vector>

#include "felt/document/edit.h"

namespace felt {

/// Returns true if the ends and the middle of `part` are on `whole`.
bool is_piece_of(const Stroke& part, const Stroke& whole);

/// Two strokes that an edit made into one.
struct StrokeJoin {
  StrokeId from;  ///< lost its ink to the other one, wholly or in part
  StrokeId into;  ///< exists after the edit
};

/// Returns the joins of an edit. They follow from what the edit does, because a joined line may be
/// bent, so that it is nowhere near the old one:
///   - a stroke that the edit removes without adding parts of it is joined into each stroke near it
///     that is added, or that is replaced by more than a part of itself (Connect, Gather, ink
///     between two lines);
///   - a stroke of which the edit leaves parts only is joined into each stroke near it that is
///     added and is not a part of another one (Gather).
std::vector<StrokeJoin> stroke_joins(const Edit& edit);

/// Returns the longest stroke that an edit left of a stroke which it changes: a part of it, or the
/// stroke into which it was joined. Returns no id if it left nothing.
StrokeId longest_remainder(const Edit& edit, StrokeId stroke);

}  // namespace felt
