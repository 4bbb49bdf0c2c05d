#pragma once

#include <vector>

#include "felt/gather/line_sections.h"
#include "felt/tools/gather/brush_path.h"

namespace felt {

/// A part of a stroke that the brush gathers, or leaves.
struct StrokePart {
  double u0 = 0.0, u1 = 0.0;        ///< as in sub_stroke()
  bool is_whole = false;            ///< the whole stroke, closed if the stroke is
  std::vector<std::size_t> points;  ///< indices in BrushedStroke::points, in order along the part
};

/// Returns the parts of a stroke that the brush gathers, in order along the stroke:
///
/// 1. A point is brushed if the brush moved along it for at least half of its radius. A crossing
///    line has no such points.
/// 2. Brushed points in a row make a run. A gap shorter than the radius does not end it; turning
///    back does, so the strokes of a zigzag without lifts are runs of their own. Runs shorter than
///    the radius, and than half of the stroke, are left out.
/// 3. If the runs cover at least half of the stroke, all of the stroke is gathered, cut only where
///    it turns back. Otherwise only the runs are cut out; a remainder at an end that is shorter
///    than the radius is gathered, too.
std::vector<StrokePart> brushed_parts(const BrushedStroke& brushed, double radius_mm);

/// Returns the points of a part.
RoughLine line_of(const BrushedStroke& brushed, const StrokePart& part);

/// Returns what remains of a stroke when these parts, in order, are cut out. The remainders have no
/// points.
std::vector<StrokePart> remainders(const Stroke& stroke, const std::vector<StrokePart>& parts);

}  // namespace felt
