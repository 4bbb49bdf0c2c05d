#pragma once

#include <cstddef>
#include <vector>

#include "felt/document/document.h"
#include "felt/document/drawing_guide.h"

namespace felt {

/// Returns the handles of a guide, the origin first. A perspective has its vanishing points
/// instead; a trace and a teacher's path have none.
std::vector<Point> guide_handles(const DrawingGuide& guide);

/// How a drag changes a direction.
enum class GuideTurn { kFree, kInSteps };

/// Returns the guide with one handle dragged to `to`; all numbers stay within the limits of
/// DrawingGuide. Requires handle < guide_handles(guide).size().
DrawingGuide with_guide_handle(const DrawingGuide& guide, std::size_t handle, Point to,
                               GuideTurn turn);

/// Returns the guide moved as a whole. A trace does not move.
DrawingGuide moved_guide(const DrawingGuide& guide, Vec by_mm);

/// Returns a new guide of the kind of `plain`, placed by a drag. If the drag is shorter than
/// kMinGuideDragMm, the guide has its usual direction and size.
inline constexpr double kMinGuideDragMm = 2.0;
DrawingGuide placed_guide(const DrawingGuide& plain, Point from, Point to, int vanishing_points,
                          GuideTurn turn);

/// Returns the distance from a point to the nearest line of the guide at which it can be grabbed,
/// in mm. Grids are grabbed by their handles only.
double distance_to_guide(const DrawingGuide& guide, const Document& document, Point p);

}  // namespace felt
