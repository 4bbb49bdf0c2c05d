#pragma once

#include <cstddef>
#include <vector>

#include "felt/geometry/bvh.h"

namespace felt::bench {

/// Returns the side of the square canvas for n segments. All rows have the same density, that of a
/// well filled page: 10^4 segments on 2000 x 2000 units.
double canvas_side(std::size_t n);

/// Returns n segments in smooth strokes of 1 to 8 segments, at uniformly random positions. A
/// segment is about 28 units long, because the strokes of the performance scenes have on average
/// 4.5 segments and 125 units.
std::vector<BvhSegment> page(std::size_t n, unsigned seed);

/// Returns the positions of a pen that wanders over the canvas: 0.4 units per tick, with smooth
/// turns, always inside the canvas.
std::vector<Point> pen_path(std::size_t ticks, double side, unsigned seed);

/// Returns n arcs that form a circle of this radius. All have the same distance from its centre.
std::vector<BvhSegment> circle_of_arcs(std::size_t n, Point centre, double radius);

}  // namespace felt::bench
