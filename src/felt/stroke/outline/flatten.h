#pragma once

#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// A round dab of ink. A stroke inks the union of the dabs along its centre line.
struct Dab {
  Point center;
  double radius_mm = 0.0;
  double tone = 0.0;  ///< WidthKnot::tone

  friend constexpr bool operator==(const Dab&, const Dab&) noexcept = default;
};

/// Steps that one segment is divided into at most: bounds memory where a tolerance is absurdly
/// fine for the size of the segment.
inline constexpr int kMaxFlattenSteps = 1 << 14;

/// Steps that a stroke of many segments is divided into at most, shared evenly (but at least one
/// a segment): 2^24 dabs take 540 MB.
inline constexpr int kMaxStrokeSteps = 1 << 24;

/// Parameter steps, at least 1, so that straight lines between equal steps of t over a part of c
/// `span` of t long stay within the tolerance of the curve at the same t. By the bound
/// h^2 max|f''| / 8 (Wang, "The subdivision method for finding the intersection between two
/// Bezier curves", 1984), which holds through cusps and standing handles.
int flatten_steps(const Cubic& c, double span, double tolerance_mm) noexcept;

/// Replaces `out` by dabs along the stroke: radius and centre, taken linearly from each dab to
/// the next, stay within the tolerance of those of the stroke at the same parameter, unless that
/// would take more than the largest number of steps; tones are exact. Segment ends and width
/// breakpoints are hit exactly. A closed stroke's seam appears at both ends.
void flatten(const Stroke& stroke, double tolerance_mm, std::vector<Dab>& out);

/// Likewise along the segments from `first` up to, not including, `last`: the same dabs as those of
/// the whole stroke there. Requires 0 <= first < last <= segment_count().
void flatten(const Stroke& stroke, int first, int last, double tolerance_mm, std::vector<Dab>& out);

}  // namespace felt
