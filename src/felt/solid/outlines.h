#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/geometry/cubic.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Whether closed lines inside an outline are holes of the body.
enum class HoleChoice : std::uint8_t {
  kKeep,  ///< a closed line inside an outline is a hole, one inside a hole is another body
  kFill,  ///< closed lines inside an outline are ignored
};

/// What happens if some of the outlines cannot become bodies.
enum class FaultChoice : std::uint8_t {
  kRefuse,    ///< fails, and the message names the first fault
  kLeaveOut,  ///< leaves these outlines out, each with a note, if others remain
};

/// The outline of one body on the page: closed curves that do not meet.
struct SolidOutline {
  /// The outer curve, then the holes. The cubics of a curve join, and its last point is its first.
  std::vector<std::vector<Cubic>> loops;
  StrokeId stroke;  ///< the stroke with the largest share of the outer curve
  Rgba color{};     ///< of that stroke
};

/// The outlines of a drawing, and what was left out, as sentences.
struct FoundOutlines {
  std::vector<SolidOutline> outlines;
  std::vector<std::string> notes;
};

/// A closed line that is smaller than this in both directions is no outline.
inline constexpr double kMinOutlineMm = 1.0;
/// A closed line whose mean width (twice the area divided by the length) is smaller is none either.
inline constexpr double kMinMeanWidthMm = 0.2;

/// Finds the outlines of bodies in the visible strokes. Uses the planar map of the layer fill:
///  * Gaps of up to `max_gap_mm` are closed by bridges. Lines that enclose nothing are ignored.
///  * All areas that touch each other along a line are one body: its outline is that of their
///    union. So overlapping shapes join, and lines across a shape do not divide it.
///  * `holes` says what closed lines inside a body are, if they do not touch its outline.
///  * A closed line inside another one redraws its outline instead of making a hole if the ink of
///    both touches, on average. It is left out with a note.
///  * Loops that are too small, and small loops beside a larger one, are left out with a note.
///  * With FaultChoice::kLeaveOut, if areas meet in only one point, the smaller ones are left out
///    with a note.
/// Fails if there is no closed line (kNotFound; the message says where the smallest gap is), if all
/// are too small, if parts of an outline meet in only one point, as in a figure of eight (the
/// message names the stroke and the point), or if there are too many strokes or
/// check_line_density() fails (kLimitExceeded).
Result<FoundOutlines> find_outlines(const Document& document, double max_gap_mm, HoleChoice holes,
                                    FaultChoice faults = FaultChoice::kRefuse);

}  // namespace felt
