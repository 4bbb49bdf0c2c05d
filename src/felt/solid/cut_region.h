#pragma once

#include <optional>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/point.h"
#include "felt/solid/solid.h"
#include "felt/solid/view_frame.h"

namespace felt {

/// The part of a picture that a stroke across a body cuts off: a simple polygon that turns from +x
/// to +y.
struct CutRegion {
  std::vector<Point> ring;
  /// The first points lie on the stroke; the others lead back to its start beside the body.
  std::size_t stroke_points = 0;
};

/// Returns the region at the left of a stroke (in its direction, y up) whose border is the stroke
/// and a path around the part of the body there. The path does not touch the body, so that nothing
/// else of the body is cut: a stroke across the ear of a cat cuts off the ear only. Found on a grid
/// of kCutCells cells: a part of the picture that is nearer to the body than a cell counts as body.
///
/// `step_mm` is the distance of the points on the stroke. Returns nullopt if the stroke does not
/// touch the body. Fails if an end of the stroke lies on the body, if the stroke crosses itself, or
/// if no path leads around the part at the left, for example because the stroke ends in a hole. The
/// message says where: positions are those of the picture.
Result<std::optional<CutRegion>> find_cut_region(const SolidBody& body, const ViewFrame& frame,
                                                 const std::vector<Point>& stroke, double step_mm);

/// A stroke may have this many points at `step_mm`, or cells along it. A longer one is refused.
inline constexpr double kMaxCutPoints = 5000.0;
/// The number of cells of the grid along the longer side of the picture.
inline constexpr int kCutCells = 400;

}  // namespace felt
