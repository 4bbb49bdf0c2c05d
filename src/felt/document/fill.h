#pragma once

#include <memory>
#include <vector>

#include "felt/document/edit.h"
#include "felt/geometry/rect.h"
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

using FillPtr = std::shared_ptr<const Fill>;

}  // namespace felt
