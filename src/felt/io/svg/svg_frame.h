#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "felt/geometry/affine.h"
#include "felt/geometry/point.h"
#include "felt/geometry/rect.h"

namespace felt {

/// Half of the plane: the points p with outside_mm(p) <= 0. `normal` has length 1.
struct SvgHalfPlane {
  Vec normal;
  double limit_mm = 0.0;

  /// Returns how far a point is outside; negative inside.
  [[nodiscard]] double outside_mm(Point p) const { return dot(normal, p - Point{}) - limit_mm; }
};

/// The area of the page that the viewports around a shape show: the part that several half planes
/// have in common. Viewports may be rotated or skewed.
class SvgFrame {
 public:
  static constexpr std::size_t kMaxPlanes = 64;

  SvgFrame() = default;
  explicit SvgFrame(const Rect& rect) { static_cast<void>(cut(rect, Affine())); }

  /// Keeps only the part inside a viewport, which `to_mm` maps to the page. Returns false and
  /// changes nothing if the frame would have more than kMaxPlanes edges, or if a side of a rotated
  /// viewport has no length on the page.
  [[nodiscard]] bool cut(const Rect& viewport, const Affine& to_mm);
  /// Returns true if all of the rectangle is inside, or less than `margin_mm` outside.
  [[nodiscard]] bool contains(const Rect& box, double margin_mm) const;
  /// Returns true if one edge of the frame has all of the rectangle outside.
  [[nodiscard]] bool misses(const Rect& box) const;
  [[nodiscard]] std::span<const SvgHalfPlane> planes() const noexcept { return planes_; }

 private:
  std::vector<SvgHalfPlane> planes_;
};

}  // namespace felt
