#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "felt/io/svg/svg_path_builder.h"
#include "felt/io/svg/svg_style.h"

namespace felt {

/// Lines of these widths keep their flat ends and their pointed or cut corners (sharp_line()). On
/// thinner lines, round ends and corners look almost the same and are easier to edit.
inline constexpr double kMinSharpWidthMm = 1.2, kMaxSharpWidthMm = 1000.0;
/// Longer lines get round ends and corners.
inline constexpr std::size_t kMaxSharpSegments = 10'000;

/// The part of a segment, in u, in which the width changes if it differs before and after a joint.
inline constexpr double kSvgJumpU = 1e-4;

/// How a line ends and turns. All sharp forms are drawn exactly for straight segments.
struct SvgSharpForm {
  double width_mm = 0.0;
  SvgCap cap = SvgCap::kButt;
  SvgJoin join = SvgJoin::kMiter;
  double miter_limit = 4.0;
};

/// The widths of a line just before and just after a joint.
struct SvgSharpWidth {
  double before_mm = 0.0, after_mm = 0.0;
};

/// The centre line and the widths of ink that looks like a line with flat ends and sharp corners.
struct SvgSharpLine {
  SvgContour contour;
  std::vector<SvgSharpWidth> widths;  ///< at each joint of the contour; linear in between
  /// False if an end or a corner stayed round because it is too close to another one.
  bool is_exact = true;
};

/// Converts a contour in mm. Ink is the union of discs along its centre line, so the ink that
/// narrows from a disc to a point fills the cone around both: the centre line makes a short trip
/// into each sharp corner and back. It returns as a thin line, so that no edge is drawn twice. A
/// mitre is the cone from the disc at the joint to its tip. A flat end is two such cones from the
/// disc that touches the end.
SvgSharpLine sharp_line(const SvgContour& contour, const SvgSharpForm& form);

/// Converts a straight line from `a` to `b` with flat ends that a transform has made slanted: the
/// corners of both ends are `half_end` from the end points. Returns nullopt if the line is too
/// short or too thin for such ends.
std::optional<SvgSharpLine> slanted_line(Point a, Point b, Vec half_end);

}  // namespace felt
