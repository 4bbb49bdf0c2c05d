#pragma once

#include <span>
#include <vector>

#include "felt/document/fill.h"
#include "felt/fill/planar_map.h"

namespace felt {

/// A piece of a loop, and the points where it begins and ends. These may differ from the stroke's
/// own points by the tolerance of the map.
struct LoopStep {
  FillPiece piece;
  Point start, end;
};

/// Returns the loop made of the steps. Requires that each step starts where the one before it ends,
/// the first where the last ends, and that the strokes exist.
FillLoop loop_of_steps(std::span<const LoopStep> steps, const LineMeetings& meetings);

/// Returns a loop of a planar map. Neighbouring edges of one stroke become one piece.
FillLoop loop_of_map(const PlanarMap& map, const MapLoop& loop, const LineMeetings& meetings);

/// Returns the cubics of a step.
std::vector<Cubic> cubics_of_step(const LoopStep& step, const LineMeetings& meetings);

/// Returns the steps of a loop with the points from which the loop was made, and the number of
/// cubics of each. Empty if pieces and points do not fit each other.
struct OldStep {
  FillPiece piece;
  std::span<const Point> points;  ///< 3n + 1 control points
};
std::vector<OldStep> old_steps(const FillLoop& loop);

/// Returns the signed area of a loop in mm^2.
double area_of(const FillLoop& loop) noexcept;

/// Returns true if the even-odd rule puts p inside the fill.
bool is_in_fill(const Fill& fill, Point p) noexcept;

}  // namespace felt
