#pragma once

#include <cstddef>
#include <vector>

#include "felt/document/document.h"
#include "felt/geometry/rect.h"

namespace felt {

/// The largest difference of a channel, of 255, at which ink counts as not seen on the paper: 5 %,
/// Feltline's own choice. What is not seen is not raised.
inline constexpr double kUnseenLevels = 0.05 * 255.0;

/// Returns true if ink of this colour and with this opacity (0..1) is seen on the paper.
/// Transparent paper counts as white.
bool is_seen(Rgba ink, double opacity, Rgba paper) noexcept;

/// Returns the opacity of a layer together with that of its group, 0..1.
double layer_opacity(const Layer& layer) noexcept;

/// The ink of visible layers that is not seen on the paper.
struct UnseenInk {
  std::vector<StrokeId> strokes;  ///< in drawing order
  std::vector<FillId> fills;      ///< in drawing order
};

/// Finds the unseen ink: white lines on white paper, lines of 2 % opacity. Ink on a fill of another
/// colour is compared with the paper, because a gap in a raised area cannot be felt as a line.
UnseenInk unseen_ink(const Document& document, Rgba paper);

/// Returns the bounds of the ink of visible layers that is seen on the paper, mm; empty if there is
/// none.
Rect seen_bounds(const Document& document, Rgba paper);

}  // namespace felt
