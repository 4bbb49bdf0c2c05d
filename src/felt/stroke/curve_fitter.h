#pragma once

#include <vector>

#include "felt/geometry/cubic.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// What a curve fit must keep to.
struct CurveFitOptions {
  /// Largest distance from any sample to the curve, in mm. 0 joins the samples by straight lines.
  double tolerance_mm = 0.15;
};

/// A chain of joined cubics fitted to samples. While a stroke is drawn it only grows.
struct FittedCurve {
  std::vector<Point> points;      ///< 3n + 1 control points; empty before the first segment
  std::vector<JointKind> joints;  ///< n - 1 kinds of the inner joints
  /// For each sample that the n segments cover, in order: its place u = segment index + t on the
  /// curve. Non-decreasing; the curve at u lies within the tolerance of the sample.
  std::vector<double> sample_u;

  [[nodiscard]] int segment_count() const noexcept {
    return points.empty() ? 0 : static_cast<int>(points.size() / 3);
  }
  [[nodiscard]] Cubic segment(int i) const noexcept {
    const auto k = static_cast<std::size_t>(3 * i);
    return {{points[k], points[k + 1], points[k + 2], points[k + 3]}};
  }
};

}  // namespace felt
