#pragma once

#include <cstddef>
#include <vector>

#include "felt/geometry/bvh.h"

namespace felt::bench {

/// Side of the square canvas that holds n segments at the density of all rows: 10^4 segments on
/// 2000 x 2000 units, a well filled page.
double canvas_side(std::size_t n);

/// n segments in smooth strokes of 1 to 8, each about 28 units long (the mean of performance
/// scenes: strokes of 4.5 segments and 125 units), placed evenly at random.
std::vector<BvhSegment> page(std::size_t n, unsigned seed);

/// A pen that wanders over the canvas: 0.4 units a tick, turning smoothly, kept inside.
std::vector<Point> pen_path(std::size_t ticks, double side, unsigned seed);

/// n arcs that together make a circle of this radius: from its centre all are equally near.
std::vector<BvhSegment> circle_of_arcs(std::size_t n, Point centre, double radius);

}  // namespace felt::bench
