#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/io/import.h"
#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// A point of a line that another program drew, and how wide the line is there.
struct WidePoint {
  Point position;  ///< mm, sheet frame
  double width_mm = 0.0;

  friend constexpr bool operator==(const WidePoint&, const WidePoint&) noexcept = default;
};

/// How far the curve may be from the points of a drawn line, and from those that the fit looks at
/// on the straight lines between them, at most 1 mm apart. In between it stays within twice that.
inline constexpr double kDrawnLineToleranceMm = 0.05;
/// How far the width profile may be from the widths of a drawn line.
inline constexpr double kDrawnWidthToleranceMm = 0.02;
/// A piece of a drawn line longer than this was drawn with a ruler: it becomes one straight
/// segment.
inline constexpr double kRuledMm = 20.0;

/// Makes strokes of what other programs store: samples of a pen, or lines with widths. One for a
/// file, so that buffers are kept and the work it takes on is bounded. Thread: one.
class InkOfPoints {
 public:
  /// `fit` is for samples; drawn lines keep to the tolerances above.
  explicit InkOfPoints(const InkFitOptions& fit);

  /// Samples of a pen, in mm: what the pencil would have made of them, a dab of a single place.
  /// Error: none of them is usable.
  Result<StrokeData> of_samples(std::span<const InkSample> samples);
  /// The same with another map from pressure to width.
  Result<StrokeData> of_samples(std::span<const InkSample> samples, const WidthMapOptions& widths);

  /// A drawn line. The curve follows the straight lines between the points; where the last point is
  /// the first, the stroke is closed. A single place becomes a dab. Points that are not finite or
  /// beyond 1e9 mm are left out, widths below kMinWidthMm are raised to it. Error: no point is
  /// left.
  Result<StrokeData> of_line(std::span<const WidePoint> line);

 private:
  class Pieces;
  void add_between(const WidePoint& from, const WidePoint& to);
  Result<StrokeData> fitted_run();

  InkFitOptions fit_;
  InkFitter pencil_;
  InkFitter ruler_;
  std::size_t inserted_ = 0;           // points put between others so far
  std::vector<WidePoint> line_, run_;  // buffers of of_line()
  std::vector<double> steps_;
};

}  // namespace felt
