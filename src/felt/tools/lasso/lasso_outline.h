#pragma once

#include <span>
#include <vector>

#include "felt/geometry/rect.h"

namespace felt {

/// The path of the pen around the area to select. It is simplified while it grows: every position
/// of the pen is within kToleranceMm of the simplified path (docs/design/editing.md#lasso, R31).
/// The time per sample is bounded, independent of the length of the path.
class LassoOutline {
 public:
  static constexpr double kToleranceMm = 0.25;

  void begin(Point p);
  void add(Point p);
  void clear();

  /// Returns the path so far, from its first to its last point.
  [[nodiscard]] std::span<const Point> points() const noexcept { return points_; }
  /// Returns the box around all positions of the pen.
  [[nodiscard]] const Rect& bounds() const noexcept { return bounds_; }
  /// Returns the whole path, simplified. add() may be called again afterwards.
  [[nodiscard]] std::vector<Point> finished() const;

 private:
  void simplify_tail();

  std::vector<Point> points_;
  std::size_t simplified_ = 0;  // points before this one are final
  Rect bounds_;
};

}  // namespace felt
