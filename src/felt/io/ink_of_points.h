#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/io/import.h"
#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// A point of a line that another program drew, with the width of the line there.
struct WidePoint {
  Point position;  ///< mm, page frame
  double width_mm = 0.0;

  friend constexpr bool operator==(const WidePoint&, const WidePoint&) noexcept = default;
};

/// Largest distance between the curve and the points of a drawn line. The fit also checks further
/// points, at most 1 mm apart, on the straight lines between these points. Between the checked
/// points, the curve stays within twice this distance.
inline constexpr double kDrawnLineToleranceMm = 0.05;
/// Largest difference between the width profile and the widths of a drawn line.
inline constexpr double kDrawnWidthToleranceMm = 0.02;
/// If a straight piece of a drawn line is longer than this, in mm, it is assumed to have been drawn
/// with a ruler and becomes one straight segment.
inline constexpr double kRuledMm = 20.0;

/// Converts the data of other programs to strokes: pen samples, or lines with widths. Use one
/// object for each file, because the object reuses its buffers and limits the total work for the
/// file. Not thread-safe.
class InkOfPoints {
 public:
  /// `fit` is used for pen samples. Drawn lines are fitted with the tolerances above, or
  /// with another one for their widths, mm.
  explicit InkOfPoints(const InkFitOptions& fit,
                       double width_tolerance_mm = kDrawnWidthToleranceMm);

  /// Converts pen samples, in mm, to the stroke that the pencil tool would have drawn. Samples at a
  /// single position become a dab. Fails if no sample is usable.
  Result<StrokeData> of_samples(std::span<const InkSample> samples);
  /// Converts pen samples with `widths` instead of the default map from pressure to width.
  Result<StrokeData> of_samples(std::span<const InkSample> samples, const WidthMapOptions& widths);
  /// Returns the faults of the samples of the last call of of_samples().
  [[nodiscard]] SampleFaults sample_faults() const { return pencil_.faults(); }

  /// Converts a drawn line. The curve follows the straight lines between the points. If the last
  /// point equals the first, the stroke is closed. If all points are at the same position, the
  /// stroke is a dab. Points that are not finite or beyond 1e9 mm are skipped. Widths below
  /// kMinWidthMm are raised to kMinWidthMm. Fails if no valid point remains.
  Result<StrokeData> of_line(std::span<const WidePoint> line);

 private:
  class Pieces;
  void add_between(const WidePoint& from, const WidePoint& to);
  Result<StrokeData> fitted_run();

  InkFitOptions fit_;
  double width_tolerance_mm_;
  InkFitter pencil_;
  InkFitter ruler_;
  std::size_t inserted_ = 0;           // number of points inserted between others so far
  std::vector<WidePoint> line_, run_;  // buffers of of_line()
  std::vector<double> steps_;
};

}  // namespace felt
