#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "felt/base/result.h"

namespace felt::bench {

/// Simulated people of all models draw slowly over 20 pictures of five kinds (silhouettes, pencil
/// lines, shaded areas, textured pictures with a second shape, hatched drawings), without and with
/// the contours that find_contours() finds in them (UseEdges). Prints for these devices the change
/// of the distance from the shape in the picture, and for which share of the length another contour
/// holds the pen. Returns false if a bar is missed: 0.65 times the error, 2 % of the length.
Result<bool> compare_contours(const std::vector<std::string>& devices, std::size_t people);

}  // namespace felt::bench
