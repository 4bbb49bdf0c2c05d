#pragma once

#include <span>
#include <vector>

#include "felt/geometry/point.h"

namespace felt {

/// A point of a path and the time at which an unhurried hand reaches it.
struct TimedPoint {
  Point position;
  double t_s = 0.0;
};

/// Returns points a few hundredths of a millimetre apart on a smooth curve through `via`: the
/// centripetal Catmull-Rom spline, which adds neither cusps nor loops (Yuksel, Schaefer, Keyser,
/// "Parameterization and applications of Catmull-Rom curves", CAD 43, 2011). A point given twice in
/// a row is a corner.
std::vector<Point> smooth_path(std::span<const Point> via);

/// Returns the points with the times at which a hand reaches them. The hand slows down in curves
/// according to the two-thirds power law, speed ~ curvature^(-1/3) (Lacquaniti, Terzuolo, Viviani,
/// Acta Psychologica 54, 1983), with a minimum curvature so that the speed on straight parts is
/// finite (Viviani, Schneider, J Exp Psychol HPP 17, 1991). It nearly stops in corners and at both
/// ends, and never accelerates beyond 2 m/s^2 along the path
/// (docs/design/simulation.md#perception). `tempo` multiplies all speeds.
std::vector<TimedPoint> pace(std::span<const Point> path, double tempo);

/// Returns the positions at equal time steps, from time 0 to the last time or, if that is later, to
/// `min_duration_s`. Requires at least one point.
std::vector<Point> at_equal_times(std::span<const TimedPoint> path, double step_s,
                                  double min_duration_s);

/// Smooths positions at equal time steps as muscles do: with a raised-cosine window that reaches
/// `reach` steps to each side. Before its start and after its end, the movement is at rest.
std::vector<Point> through_muscles(std::span<const Point> path, int reach);

}  // namespace felt
