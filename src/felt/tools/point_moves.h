#pragma once

#include <span>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/brush_reach.h"

namespace felt {

/// A point of a stroke and the position that it moves to.
struct PointMove {
  double u = 0.0;
  Point to;

  friend bool operator==(const PointMove&, const PointMove&) noexcept = default;
};

/// Returns a stroke with several of its points moved. One point moves as a brush pulls it
/// (BrushPull). If there are more, the ink between two neighbours moves by
///
///   d = (1 - w) d1 + w d2,   w = 3x^2 - 2x^3, x = the fraction of the arc length between them
///
/// with d1 and d2 their displacements, so that all points arrive exactly. Outside, and between
/// neighbours whose brushes do not reach each other, the influence falls off as that of a brush
/// with these options. If two points are nearer along the ink than kMinSegmentMm, the first one in
/// `moves` counts. The result depends only on the arguments. Fails if a target is not finite.
Result<Stroke> with_points_moved(const StrokePtr& stroke, std::span<const PointMove> moves,
                                 const BrushOptions& options);

}  // namespace felt
