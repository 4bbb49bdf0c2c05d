#include "felt/render/segments_in_area.h"

#include <algorithm>

namespace felt {

Rect segment_area(const Stroke& stroke, int i) noexcept {
  Rect area;
  for (const Point& p : stroke.segment(i).p) area.extend(p);
  double widest = std::max(stroke.width_mm(i), stroke.width_mm(i + 1));
  const int size = stroke.segment_count();
  if (stroke.closed() && (i == 0 || i == size - 1)) {  // the seam has the larger of its two widths
    widest = std::max({widest, stroke.width_mm(0.0), stroke.width_mm(size)});
  }
  const auto knots = stroke.widths();
  auto knot = std::lower_bound(knots.begin(), knots.end(), static_cast<double>(i),
                               [](const WidthKnot& k, double u) { return k.u < u; });
  for (; knot != knots.end() && knot->u <= i + 1; ++knot) widest = std::max(widest, knot->width_mm);
  return area.inflated(0.5 * widest);
}

void SegmentsInArea::find(std::span<const Rect> areas, const Rect& area) {
  runs_.clear();
  for (int i = 0; i < static_cast<int>(areas.size()); ++i) {
    if (!area.intersects(areas[static_cast<std::size_t>(i)])) continue;
    if (runs_.empty() || runs_.back().last != i) runs_.push_back({i, i});
    runs_.back().last = i + 1;
  }
}

}  // namespace felt
