#pragma once

#include "felt/geometry/point.h"

namespace felt {

/// A cheap test before the exact fit. It keeps running sums. From these, the least-squares cubic
/// through the two end samples of a run and its residual are computed in constant time per sample.
///
/// With s the path length from the origin, the sums are M_k = sum s^k (k 0..6), Q_k = sum s^k P (k
/// 0..3) and sum |P|^2, with positions P relative to the origin. Divided by powers of the whole
/// length L they become sums over t = s / L. From these follow the normal equations and the sum of
/// squared distances at chord-length parameters. If that sum is at most tolerance^2, every single
/// sample is within the tolerance, so the run can grow without visiting its samples again. If the
/// sum is larger, the exact fit must decide, because the sum also counts distance along the curve
/// as error. After 100,000 samples the rounding error is 3e-10 mm.
class RunMoments {
 public:
  /// Starts a run at `origin` with a free tangent.
  void begin(Point origin) noexcept;
  /// Starts a run at `origin` with the unit tangent `tangent`.
  void begin(Point origin, Vec tangent) noexcept;
  /// Adds the sample p at `path_mm` from the origin along the samples. Requires that `path_mm` does
  /// not decrease.
  void add(Point p, double path_mm) noexcept;
  /// Returns the sum of squared distances in mm^2 of the samples from the best cubic between the
  /// origin and the last sample, or infinity if the sums do not determine a cubic.
  [[nodiscard]] double residual() const noexcept;

 private:
  Point origin_;
  Vec tangent_;
  bool has_tangent_ = false;
  Vec last_;
  double length_ = 0.0;
  double m_[7] = {};
  Vec q_[4];
  double pp_ = 0.0;
};

}  // namespace felt
