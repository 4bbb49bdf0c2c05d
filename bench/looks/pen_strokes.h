#pragma once

#include <vector>

#include "felt/stroke/fit/ink_fit.h"

namespace felt::bench {

/// The samples of one stroke of a pen.
using PenStroke = std::vector<InkSample>;

/// The size of a test picture and the strokes on it, in mm.
struct TestPage {
  double width_mm = 0.0, height_mm = 0.0;
  std::vector<PenStroke> strokes;
};

/// Returns a straight line along x whose pressure changes linearly. The pen moves at 60 mm/s.
PenStroke line_of(Point from, Point to, double first_pressure, double last_pressure);

/// Pressures at the ends of the ramp.
inline constexpr double kRampFrom = 0.05, kRampTo = 0.95;
/// The ramp: one line of 100 mm, along which the pressure grows from kRampFrom to kRampTo.
inline constexpr double kRampX0 = 10.0, kRampX1 = 110.0, kRampY = 10.0;
TestPage ramp();

/// Several straight lines of 100 mm with the same pressure, 18 mm apart, each drawn `times` times.
inline constexpr int kEvenLines = 6;
inline constexpr double kEvenApart = 18.0;
TestPage even_lines(double pressure, int times);

/// The same lines, each drawn there and back in one stroke.
TestPage lines_there_and_back(double pressure);

/// A cell of the chart: the ramp, a wave that swells, hatching that crosses, and a scribble.
TestPage chart_cell();

}  // namespace felt::bench
