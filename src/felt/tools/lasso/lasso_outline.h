#pragma once

#include <span>
#include <vector>

#include "felt/geometry/rect.h"

namespace felt {

/// The way of the pen round what is to be selected, simplified while it grows: every place the pen
/// was at lies within kToleranceMm of it (specification 5e, R31). A sample costs a bounded time,
/// however long the way is.
class LassoOutline {
 public:
  static constexpr double kToleranceMm = 0.25;

  void begin(Point p);
  void add(Point p);
  void clear();

  /// The way so far, from its first to its last point.
  [[nodiscard]] std::span<const Point> points() const noexcept { return points_; }
  /// Around every place the pen was at.
  [[nodiscard]] const Rect& bounds() const noexcept { return bounds_; }
  /// The whole of it, simplified. `add` may follow.
  [[nodiscard]] std::vector<Point> finished() const;

 private:
  void simplify_tail();

  std::vector<Point> points_;
  std::size_t simplified_ = 0;  // the points before this one stay
  Rect bounds_;
};

}  // namespace felt
