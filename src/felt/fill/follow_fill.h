#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "felt/fill/fill_map.h"

namespace felt {

/// What happens to a fill whose boundary an edit has opened.
enum class WhenOpened : std::uint8_t {
  kClose,   ///< a straight line closes the new gap
  kRemove,  ///< the fill is removed
};

/// How an edit changed one stroke of the boundary of fills.
struct LineEdit {
  StrokeId id;
  StrokePtr before;             ///< may be null if unknown
  std::vector<StrokeId> after;  ///< the strokes in its place; empty: it was removed
};

/// Returns the fill with its shape after an edit, or nullopt if it has none any more. `map` has the
/// strokes after the edit. Strokes without an entry in `edits` keep their id; if such an id has
/// disappeared, its parts are looked for by their shape.
///
/// 1. If the pieces are as before, the fill is returned bit for bit.
/// 2. If the pieces still meet at the same parameters, or all of them moved by one affine map, the
///    loops consist of the same pieces: after a transform, the fill has moved with its strokes.
/// 3. Otherwise the ends of each piece move to the meeting or link of the two strokes that is
///    nearest to where the strokes now have the old parameters.
/// 4. If there is none, the fill takes the face that covers most of its area, if these two agree by
///    at least half (matching faces as in Asente, Schuster, Pettit, "Dynamic planar map
///    illustration", SIGGRAPH 2007).
/// 5. If there is no such face, the boundary has been opened, and `when_opened` applies.
/// A hole that has disappeared, or that is no longer inside, is left out.
std::optional<Fill> follow_fill(const Fill& fill, FillMap& map, std::span<const LineEdit> edits,
                                WhenOpened when_opened);

}  // namespace felt
