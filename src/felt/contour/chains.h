#pragma once

#include <vector>

#include "felt/contour/edge_map.h"
#include "felt/geometry/point.h"

namespace felt::contour {

/// Connects the pixels of a map to lines, each in order: from a strong pixel both ways, to the
/// neighbour that is most straight on. A pixel belongs to one line. The last point of a closed line
/// is its first. In pixels; the middle of the top left pixel is (0, 0).
std::vector<std::vector<Point>> chains_of(const EdgeMap& map);

/// Returns a line with its points moved to the mean of their neighbours, weighted by a Gaussian of
/// `sigma` points. The ends of an open line stay.
std::vector<Point> smoothed(const std::vector<Point>& line, double sigma);

}  // namespace felt::contour
