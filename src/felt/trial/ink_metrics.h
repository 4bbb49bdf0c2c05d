#pragma once

#include <span>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/trial/trial_metrics.h"

namespace felt {

/// A line of ink on the page of a trial, as a polyline. Requires finite numbers, at least one
/// point, and as many widths as points.
struct InkLine {
  std::vector<Point> points;      ///< mm; a closed line repeats its first point at the end
  std::vector<double> widths_mm;  ///< at each point, linear between them
  bool is_closed = false;
};

/// The page of the task `erase` at the start of a trial.
struct ErasedPage {
  /// The line that is to be erased in part; it has a length. Its part is from `from_mm` to `to_mm`,
  /// measured along the line.
  std::vector<Point> line;
  double from_mm = 0.0, to_mm = 0.0;
  std::vector<std::vector<Point>> others;  ///< lines that are to be kept
};

// Each of these sets the metrics of one task (trial_metric_columns() has their formulas) from the
// ink on the page after the trial. Without ink, those of closing and width stay nullopt, and those
// of erasing have values: all of it was erased.

/// Sets is_closed.
void measure_closing(std::span<const InkLine> ink, TrialMetrics& metrics);
/// Sets width_mean_mm, width_err_mm and width_cv.
void measure_width(std::span<const InkLine> ink, double required_mm, TrialMetrics& metrics);
/// Sets erased_extra_mm, erased_left_mm and erased_wrong_lines. Divides each line of `before` into
/// equal pieces of at most kErasedStepMm; a piece is erased if its middle is more than kSameInkMm
/// from the ink.
void measure_erasing(const ErasedPage& before, std::span<const InkLine> ink, TrialMetrics& metrics);

/// Two ends of lines at most this far apart meet.
inline constexpr double kMeetingEndsMm = 0.01;
/// The part at each end of a line whose width is not measured, because the pen lands or lifts.
inline constexpr double kWidthEndMm = 5.0;
inline constexpr double kWidthStepMm = 0.5;
inline constexpr double kErasedStepMm = 0.1;
inline constexpr double kSameInkMm = 0.02;
/// A line that has lost at most this much ink was not touched.
inline constexpr double kTouchedMm = 0.1;

}  // namespace felt
