#pragma once

#include <cstddef>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/geometry/cubic.h"
#include "felt/geometry/rect.h"
#include "felt/stroke/outline/outline.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// A part of the boundary of a fill: a stroke between two of its parameters (segment index + t), or
/// a straight bridge across a gap.
struct FillPiece {
  StrokeId stroke;    ///< zero for a bridge
  double from = 0.0;  ///< where the boundary enters the stroke; not used for a bridge
  double to = 0.0;    ///< where it leaves the stroke; smaller than `from` against its direction

  friend bool operator==(const FillPiece&, const FillPiece&) noexcept = default;
};

/// One closed loop of the boundary of a fill.
struct FillLoop {
  /// The 3n + 1 control points of n joined cubics; the last point repeats the first, bit for bit.
  std::vector<Point> points;
  /// The pieces that the points were made of, in the same order. Empty if the loop comes from a
  /// file without references: such a loop follows no stroke.
  std::vector<FillPiece> pieces;

  friend bool operator==(const FillLoop&, const FillLoop&) = default;
};

/// A coloured area. The loops are the area's shape by the even-odd rule, so a fill can be painted
/// and saved without its strokes; the pieces say how to find the shape again after the strokes have
/// changed. Fills are painted below all strokes of their layer. Immutable, like a stroke.
struct Fill {
  std::vector<FillLoop> loops;  ///< the outer boundary, then the holes
  Rgba color{};
  /// The largest gap of the boundary that a bridge closes, in mm. 0: none.
  double max_gap_mm = 0.0;

  friend bool operator==(const Fill&, const Fill&) = default;
};

/// Limits of a fill.
inline constexpr std::size_t kMaxFillLoops = 100'000;
inline constexpr std::size_t kMaxFillSegments = 1'000'000;  ///< in all its loops

/// Checks the invariants of a fill: it has at least one loop; each loop is closed and has 3n + 1
/// points, n > 0, and either no piece or 1 to n of them; a bridge has no parameters; every number
/// is finite, and parameters and the gap are not negative; the fill is within the limits above. All
/// readers call this. The message names the loop and the reason.
Result<void> check_fill(const Fill& fill);

/// Returns segment i of a loop. Requires 0 <= i < number of segments.
Cubic fill_segment(const FillLoop& loop, std::size_t i) noexcept;

/// Returns the bounds of the area; empty if it has no loop.
Rect fill_bounds(const Fill& fill) noexcept;

/// Replaces `out` by closed polygons, one for each loop, that are within the tolerance of the
/// loops. A segment that needs more than kMaxFlattenSteps is divided into that many steps. The
/// polygons depend only on the fill and the tolerance. They are meant for the even-odd rule.
void flatten_fill(const Fill& fill, double tolerance_mm, Outline& out);

}  // namespace felt
