#pragma once

#include <variant>
#include <vector>

#include "felt/geometry/point.h"

namespace felt {

/// A straight line, or a part of one.
struct GuideStraight {
  /// How far a line without ends is followed from where the pen touches, mm.
  static constexpr double kEndlessMm = 1500.0;

  Point at{};                    ///< a point of the line
  Vec along{1.0, 0.0};           ///< its direction; length 1
  double from_mm = -kEndlessMm;  ///< the ends, measured from `at`
  double to_mm = kEndlessMm;
  friend bool operator==(const GuideStraight&, const GuideStraight&) = default;
};

/// An ellipse or circle.
struct GuideEllipse {
  Point centre{};
  double angle_rad = 0.0;  ///< direction of the first semi-axis
  double a_mm = 10.0;      ///< the semi-axes, positive
  double b_mm = 10.0;
  friend bool operator==(const GuideEllipse&, const GuideEllipse&) = default;
};

/// A shape of a guide that is known exactly.
using GuideShape = std::variant<GuideStraight, GuideEllipse>;

/// The nearest point of a shape.
struct ShapeNearest {
  Point point{};
  Vec along{};               ///< direction of the shape there, length 1
  double distance_mm = 0.0;  ///< positive on the side to which perp(along) points
  /// The position on the shape: mm from GuideStraight::at, or the parameter t of an ellipse, -pi to
  /// pi, with the point centre + a cos(t) + b sin(t).
  double at = 0.0;
};

/// Returns the direction at an angle, which counts from +x towards +y; length 1.
Vec direction_of(double angle_rad) noexcept;
/// Returns the point at a position of the shape; for a straight line also beyond its ends.
Point point_at(const GuideShape& shape, double at) noexcept;
/// Returns the direction of the shape at a position, length 1.
Vec direction_at(const GuideShape& shape, double at) noexcept;
/// Returns the nearest point. Of a straight line, that is the foot of the perpendicular, also
/// beyond its ends. For an ellipse, the algorithm is the bisection of D. Eberly, "Distance from a
/// Point to an Ellipse, an Ellipsoid, or a Hyperellipsoid", https://www.geometrictools.com; at most
/// 100 steps.
ShapeNearest nearest_on(const GuideShape& shape, Point p) noexcept;
/// Returns the length of an ellipse, mm (Ramanujan's approximation, relative error below 1e-3).
double ellipse_mm(const GuideEllipse& ellipse) noexcept;
/// Returns points of the shape, close enough for a GuideTrack: both ends of a straight line, cut to
/// kEndlessMm before and after the position of `near`; a closed polygon for an ellipse.
std::vector<Point> guide_points(const GuideShape& shape, Point near);

}  // namespace felt
