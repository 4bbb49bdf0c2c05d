#pragma once

#include "felt/geometry/point.h"

namespace felt {

/// A cheap test, before the exact fit, whether one cubic can follow a run (consecutive samples). It
/// keeps sums over the samples and updates them with each new sample. From these sums, it computes
/// the least-squares cubic through the two end samples and the residual of this cubic, in a time
/// that does not depend on the length of the run.
///
/// With s the path length from the origin, the sums are M_k = sum s^k (k 0..6), Q_k = sum s^k P (k
/// 0..3) and sum |P|^2, with positions P relative to the origin. Divided by powers of L, the length
/// of the whole run, they become sums over t = s / L. From these follow the normal equations, and
/// the sum of the squared distances between samples and cubic at chord-length parameters. If the
/// sum of squared distances is at most tolerance^2, every single sample is within the tolerance, so
/// the run can grow without visiting its samples again. If the sum is larger, the exact fit must
/// decide, because the sum also counts distance along the curve as error. After 100,000 samples the
/// rounding error is 3e-10 mm.
class RunMoments {
 public:
  /// Starts a run at `origin` with a free tangent.
  void begin(Point origin) noexcept;
  /// Starts a run at `origin` with the unit tangent `tangent`.
  void begin(Point origin, Vec tangent) noexcept;
  /// Adds the sample p at `path_mm` from the origin along the samples. Requires that `path_mm` does
  /// not decrease.
  void add(Point p, double path_mm) noexcept;
  /// Returns the sum of the squared distances between the samples and the best cubic from the
  /// origin to the last sample, in mm^2. Returns infinity if the sums do not determine a cubic.
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
