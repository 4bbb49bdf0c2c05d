#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "felt/base/result.h"
#include "felt/gather/line_sections.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// The width of a gathered stroke.
enum class GatheredWidth : std::uint8_t {
  kMedian,  ///< the median width of its strokes
  kStrip,   ///< the width of the strip that its strokes cover
};

/// Settings of gathered_stroke.
struct GatherOptions {
  GatheredWidth width = GatheredWidth::kMedian;
  /// Largest distance from the middle of the strip to the curve, in mm, as in CurveFitOptions.
  double tolerance_mm = kMinSegmentMm;
};

/// Returns points on a stroke, at most 1 mm and a 16th of a segment apart.
RoughLine rough_line(const Stroke& stroke);

/// Returns the median of the strokes' widths in their middle, in mm; 0 without strokes.
double usual_width_mm(std::span<const std::shared_ptr<const Stroke>> strokes);

/// Returns one stroke through the middle of the strip of `strokes` (bundle_path), with constant
/// width and the median tone of the strokes. It has the colour and medium of the longest stroke,
/// and is closed if the strip is. Dabs count only if there is nothing else. Fails with
/// kInvalidArgument if there are no strokes, or if all are dabs.
Result<Stroke> gathered_stroke(std::span<const std::shared_ptr<const Stroke>> strokes,
                               const GatherOptions& options);

}  // namespace felt
