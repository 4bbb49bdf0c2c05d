#pragma once

#include "felt/geometry/point.h"
#include "felt/stroke/outline/outline.h"

namespace felt {

/// The largest circle inside an area.
struct InnerCircle {
  Point center{};
  double diameter_mm = 0.0;
};

/// Returns the largest circle inside the polygons by the even-odd rule; its diameter is exact
/// within `tolerance_mm`. The diameter is 0 if the polygons contain no point. Searches a quadtree,
/// best cell first, as in "polylabel" (Agafonkin 2016, https://github.com/mapbox/polylabel); a cell
/// can contain no better centre than the distance of its middle plus its radius. With more than
/// about 10,000 points the search may end early, with a smaller circle. Requires tolerance_mm > 0.
InnerCircle largest_inner_circle(const Outline& polygons, double tolerance_mm);

}  // namespace felt
