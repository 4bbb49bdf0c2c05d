#pragma once

#include <vector>

#include "felt/geometry/cubic.h"

namespace felt {

/// Fits one cubic to points along a smooth edge. Private to this layer.
///
/// Usage: `clear`, `add` for each point in order, `fit`. Keeps its buffers.
class EdgeFit {
 public:
  void clear() noexcept { points_.clear(); }
  void add(Point p) {
    if (points_.empty() || p != points_.back()) points_.push_back(p);
  }

  /// Finds the cubic from the first to the last point that leaves along `begin` and arrives along
  /// `end`, both unit vectors. Returns false if it would leave the tolerance at a point.
  bool fit(Vec begin, Vec end, double tolerance_mm, Cubic& c);

 private:
  bool fit_handles(Vec d0, Vec d1, Cubic& c) const noexcept;
  double move_parameters(const Cubic& c) noexcept;

  std::vector<Point> points_;
  std::vector<double> t_;
};

}  // namespace felt
