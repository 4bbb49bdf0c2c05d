#include "felt/stroke/arc_map.h"

#include <algorithm>
#include <cmath>

namespace felt {

ArcMap::ArcMap(const Stroke& stroke, double accuracy_mm)
    : stroke_(stroke), accuracy_mm_(accuracy_mm) {
  const int n = stroke.segment_count();
  starts_.reserve(static_cast<std::size_t>(n) + 1);
  starts_.push_back(0.0);
  for (int i = 0; i < n; ++i) {
    starts_.push_back(starts_.back() + arc_length(stroke.segment(i), accuracy_mm));
  }
}

double ArcMap::length_at(double u) const noexcept {
  const int n = stroke_.segment_count();
  if (!(u > 0.0)) return 0.0;
  if (u >= n) return length_mm();
  const double segment = std::floor(u);
  const int i = static_cast<int>(segment);
  if (u == segment) return start_of(i);
  // Rounding of the integral must not give a length beyond the segment.
  return std::min(start_of(i) + arc_length(stroke_.segment(i), 0.0, u - segment, accuracy_mm_),
                  start_of(i + 1));
}

double ArcMap::u_at(double length) const noexcept {
  const int n = stroke_.segment_count();
  const double whole = length_mm();
  if (stroke_.closed() && (length < 0.0 || length > whole)) {
    length -= whole * std::floor(length / whole);
  }
  if (!(length > 0.0)) return 0.0;
  if (length >= whole) return n;
  const auto next = std::upper_bound(starts_.begin() + 1, starts_.end() - 1, length);
  const int i = static_cast<int>(next - starts_.begin()) - 1;
  return i + parameter_at_length(stroke_.segment(i), length - start_of(i), accuracy_mm_);
}

double ArcMap::way(double s0_mm, double s_mm) const noexcept {
  const double straight = s_mm - s0_mm;
  return stroke_.closed() ? std::remainder(straight, length_mm()) : straight;
}

}  // namespace felt
