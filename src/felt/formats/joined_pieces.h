#pragma once

#include <cstddef>

#include "felt/base/result.h"
#include "felt/document/drawing.h"

namespace felt {

/// Many programs write one stroke of changing width as short lines that follow each other, each
/// with one width. Joins such lines of each layer to strokes: the lines follow each other in the
/// layer, each begins within 0.02 mm of the end of the one before, has one segment and constant
/// width, and all have the same colour and medium. Flat ends of broad lines go. Lines with tones of
/// their own, and those to which fills, key drawings or symmetry groups refer, stay. The curve
/// stays within kDrawnLineToleranceMm of the lines, and the width changes linearly from the middle
/// of one line to the middle of the next one. Returns the number of lines that became part of a
/// longer stroke. Fails if a line cannot be fitted.
Result<std::size_t> join_pieces(Drawing& drawing);

}  // namespace felt
