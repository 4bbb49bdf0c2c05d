#pragma once

#include <span>

#include "felt/geometry/point.h"

namespace felt {

/// A straight line through points: the line with the least sum of squared distances, cut at the
/// projections of the first and the last point.
struct LineFit {
  Point from, to;
  double rms_mm = 0.0;  ///< of the distances of the points
};
LineFit fit_line(std::span<const Point> points) noexcept;

/// A circle with the least sum of squared distances: the algebraic fit of Kasa (DOI
/// 10.1109/TIM.1976.6312298), then at most kFitSteps steps of Levenberg and Marquardt. The radius
/// is 0 if the points are on a line.
struct CircleFit {
  Point center;
  double radius_mm = 0.0;
  double rms_mm = 0.0;
};
CircleFit fit_circle(std::span<const Point> points) noexcept;

/// An ellipse with the least sum of squared first-order distances (Sampson, DOI
/// 10.1016/0146-664X(82)90101-0). Starts from the second moments of the points and makes at most
/// kFitSteps steps of Levenberg and Marquardt. Meant for points that go once around. The radii are
/// 0 if the points are on a line.
struct EllipseFit {
  Point center;
  double long_mm = 0.0, short_mm = 0.0;  ///< radii
  double angle = 0.0;                    ///< of the long axis, radians from +x to +y
  double rms_mm = 0.0;
};
EllipseFit fit_ellipse(std::span<const Point> points) noexcept;

inline constexpr int kFitSteps = 20;

}  // namespace felt
