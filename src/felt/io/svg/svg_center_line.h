#pragma once

#include <optional>
#include <vector>

#include "felt/io/svg/svg_path_builder.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// A contour, converted to the centre line of a stroke. A cubic of the contour is used unchanged if
/// the invariants of strokes allow that.
struct SvgCenterLine {
  std::vector<Point> points;
  std::vector<JointKind> joints;  ///< smooth if the tangents differ by at most kSmoothJointMaxDeg
  bool closed = false;
  /// For each of the n + 1 joints of the contour, its parameter u on the stroke.
  std::vector<double> places;
  bool joined_short = false;  ///< segments shorter than kMinSegmentMm were joined to others
  bool is_dot = false;        ///< the whole contour was shorter than kMinSegmentMm

  [[nodiscard]] std::size_t segment_count() const noexcept { return points.size() / 3; }
  /// Converts a parameter u of the contour to the parameter of the same position on the stroke.
  [[nodiscard]] double place(double u) const noexcept;
};

/// Converts a contour, which must be in mm. Segments that are too short (I5) are joined to the next
/// segment, or several of them become one straight segment; no point moves by more than
/// kMinSegmentMm. If the contour has no length, the result is the shortest valid stroke.
SvgCenterLine svg_center_line(const SvgContour& contour);

/// Returns the kinds of the joints of a centre line of 3 n + 1 points.
std::vector<JointKind> svg_joints(const std::vector<Point>& points, bool closed);

/// Returns the angle in degrees between the tangents at the joint after segment i.
double svg_joint_angle_deg(const std::vector<Point>& points, std::size_t i);

}  // namespace felt
