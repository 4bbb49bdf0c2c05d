#pragma once

#include <vector>

#include "felt/geometry/point.h"
#include "felt/trial/study.h"

namespace felt {

/// The longer side of a built-in shape without a size.
inline constexpr double kDefaultShapeMm = 80.0;

/// Returns the path of a built-in shape as a polyline, in the order in which it is drawn. The
/// longer side of its bounding box is `size_mm` long, and the centre of the box is the origin. The
/// curves are so finely divided that the polyline is at most 1e-4 times `size_mm` away from them.
///
/// The line is horizontal. The circle starts at the top and is drawn clockwise. The wave has two
/// periods of a sine. The spiral has three turns, from the inside to the outside. The star has five
/// points. Requires a kind other than kFile and a positive size.
std::vector<Point> shape_path(StudyShapeKind kind, double size_mm);

}  // namespace felt
