#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "felt/geometry/rect.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// The inside of a lasso, prepared for many queries: the edges are sorted into horizontal strips,
/// so that a query checks only the edges near the point. The results are the same as those of
/// felt::contains() with FillRule::kEvenOdd (R31: even-odd, a point on an edge is inside).
class LassoArea {
 public:
  /// Closes the outline, which may cross itself. If it has fewer than three points, the area is
  /// empty.
  explicit LassoArea(std::vector<Point> outline);

  [[nodiscard]] bool contains(Point p) const noexcept;
  /// Returns true if any part of the curve is inside. Segments are flattened to 4..64 chords of
  /// about 0.5 mm.
  [[nodiscard]] bool touches(const Stroke& stroke) const noexcept;
  /// Returns the share of the stroke's length that is inside, 0..1. The curve is flattened in the
  /// same way, and a chord is inside if its middle is.
  [[nodiscard]] double share_inside(const Stroke& stroke) const noexcept;
  [[nodiscard]] const Rect& bounds() const noexcept { return bounds_; }
  [[nodiscard]] std::span<const Point> outline() const noexcept { return outline_; }

 private:
  struct Edge {
    Point a, b;
  };

  [[nodiscard]] std::size_t strip_of(double y) const noexcept;
  [[nodiscard]] Edge edge(std::size_t i) const noexcept;
  [[nodiscard]] std::span<const std::uint32_t> edges_in(std::size_t strip) const noexcept;
  [[nodiscard]] bool crosses(Point a, Point b) const noexcept;
  [[nodiscard]] bool touches(const Cubic& curve) const noexcept;

  std::vector<Point> outline_;
  Rect bounds_;
  double strip_mm_ = 0.0;
  std::vector<std::uint32_t> begins_;  // start of each strip in edges_, and the end
  std::vector<std::uint32_t> edges_;   // indices of first points, by strip
};

/// Returns the area swept by the straight line from the start of a path to a point that moves along
/// the path. Every part counts as positive: a straight path has 0, but a figure eight has more than
/// 0, although its signed area is 0.
double swept_area_mm2(std::span<const Point> path) noexcept;

}  // namespace felt
