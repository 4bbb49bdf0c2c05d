#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/geometry/point.h"

namespace felt {

/// The shapes that a drawn line may resemble.
enum class ShapeForm : std::uint8_t {
  kLine,
  kArc,  ///< a part of a circle
  kCircle,
  kEllipse,
  kTriangle,
  kRectangle,
  kPolygon,  ///< any other closed shape with four to kMaxCorners straight sides
};

/// A shape near a path.
struct ShapeGuess {
  ShapeForm form = ShapeForm::kLine;
  /// How far the path is from the shape: the root mean square of the distances, relative to the
  /// limit for this form. At most 1.
  double misfit = 0.0;
  std::vector<Point> corners = {};       ///< of a polygon; both ends of a line
  Point center = {};                     ///< of an arc, circle or ellipse
  double long_mm = 0.0, short_mm = 0.0;  ///< radii; equal for arc and circle
  double angle = 0.0;                    ///< of the long axis, radians
  double from = 0.0;   ///< angle of the start about the centre, relative to the long axis
  double sweep = 0.0;  ///< from start to end, positive from +x to +y; +-2 pi if closed
};

/// Limits of guess_shapes(). They are relative to the size of the shape, so that they do not depend
/// on the zoom, except those in mm. Measured by `./dev bench gestures` on simulated people.
struct ShapeLimits {
  static constexpr double kMinSizeMm = 6.0;  ///< diagonal of the smallest path
  static constexpr double kLineRms = 0.025;  ///< of the length
  /// Sum of all returns along a line, and of the motion to both sides, of its length.
  static constexpr double kMaxReturn = 0.25, kMaxSideways = 0.3;
  /// A motion along a line or to its sides counts if it is at least so long, and at least this
  /// share of the length of the line. Sideways motion is at most 0.74 mm in a straight line drawn
  /// with a mouse, whose positions are whole pixels: 0.52 mm apart at half the usual zoom.
  static constexpr double kMinMotionMm = 0.75, kMinMotion = 0.01;
  static constexpr double kArcRms = 0.025;      ///< of the length of the path
  static constexpr double kRoundRms = 0.05;     ///< of the sum of both radii
  static constexpr double kPolygonRms = 0.035;  ///< of the diagonal
  static constexpr double kMinCornerShare = 0.62;
  static constexpr double kMaxSquareDeg = 17.0;
  static constexpr double kMaxGap = 0.2;  ///< between the ends of a closed path, of its length
  /// An arc bends by at least this share of its chord; a flatter one is a line.
  static constexpr double kMinBend = 0.04;
  /// Ratio of the radii from which an ellipse may be a circle, and from which it is one.
  static constexpr double kCircleFrom = 0.72, kCircleOnlyFrom = 0.93;
};

/// The most shapes that guess_shapes() returns.
inline constexpr std::size_t kMaxGuesses = 3;

/// Returns the shapes that a path resembles, the best one first. Shapes that fit nearly as well as
/// the best one are included, because a user may have meant any of them; besides a polygon with any
/// corners, also simpler ones that fit less well. Returns none if the path resembles nothing or is
/// smaller than kMinSizeMm. A pure function; takes less than a millisecond.
std::vector<ShapeGuess> guess_shapes(std::span<const Point> path);

}  // namespace felt
