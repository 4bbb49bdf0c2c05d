#pragma once

#include <optional>
#include <vector>

#include "felt/io/svg/svg_path.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// A contour as the centre line of a stroke: its cubics as they are, wherever the invariants of
/// strokes allow it.
struct SvgCenterLine {
  std::vector<Point> points;
  std::vector<JointKind> joints;  ///< smooth where both handles are in line to kSmoothJointMaxDeg
  bool closed = false;
  /// Where each joint of the contour came to lie, as u of the stroke; n + 1 of them.
  std::vector<double> places;
  bool joined_short = false;  ///< segments shorter than kMinSegmentMm went into their neighbours
  bool is_dot = false;        ///< all of it was that short

  [[nodiscard]] std::size_t segment_count() const noexcept { return points.size() / 3; }
  /// u of the stroke for u of the contour.
  [[nodiscard]] double place(double u) const noexcept;
};

/// Requires a contour in mm. Segments that are too short (I5) are joined to the next one, or to a
/// straight one with more of them; no place moves by more than kMinSegmentMm. What has no length at
/// all becomes the shortest stroke there is.
SvgCenterLine svg_center_line(const SvgContour& contour);

/// Kinds of the joints of a centre line: 3 n + 1 points.
std::vector<JointKind> svg_joints(const std::vector<Point>& points, bool closed);

/// Angle in degrees between the tangents at the joint behind segment i.
double svg_joint_angle_deg(const std::vector<Point>& points, std::size_t i);

}  // namespace felt
