#pragma once

#include <vector>

#include "felt/base/random.h"
#include "felt/geometry/point.h"
#include "felt/trial/ink_metrics.h"

namespace felt {

/// The ink of the task `erase` is this wide, mm.
inline constexpr double kErasedInkMm = 1.0;

/// Returns the page of the task `erase`: a line of `length_mm` through `middle`, two lines that
/// cross it 9 to 16 mm on either side of the middle, and on each side of the line a neighbour that
/// is 0.3 to 1.2 mm from the eraser if its middle is on the line (`others`: first the two that
/// cross, then the two neighbours). `along` is the unit vector of the line. Distances and slants
/// are random. Requires a length of at least kMinErasedLineMm.
ErasedPage erased_page(Point middle, Vec along, double length_mm, Random& random);

/// Returns the points through which a simulated person leads the eraser: from the middle to and
/// fro between the two lines that cross, each time to where the eraser touches one of them, with a
/// standard deviation of 1 mm along the line and 0.5 mm across it (chosen). A point given twice is
/// a corner, as plan_movement() expects it.
std::vector<Point> erasing_path(const ErasedPage& page, Random& random);

}  // namespace felt
