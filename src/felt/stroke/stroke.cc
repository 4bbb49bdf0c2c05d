#include "felt/stroke/stroke.h"

#include <algorithm>

#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

/// Returns u clamped to [0, n]; NaN becomes 0.
double clamp_parameter(double u, int segment_count) noexcept {
  return u > 0.0 ? std::min(u, static_cast<double>(segment_count)) : 0.0;
}

}  // namespace

Result<Stroke> Stroke::create(StrokeData data) {
  return check_invariants(data).map([&] { return Stroke(std::move(data)); });
}

Cubic Stroke::segment(int i) const noexcept {
  const Point* p = data_.points.data() + 3 * static_cast<std::ptrdiff_t>(i);
  return Cubic{{p[0], p[1], p[2], p[3]}};
}

JointKind Stroke::joint(int i) const noexcept {
  const int n = segment_count();
  if (i <= 0 || i >= n) return data_.closed ? data_.joints.back() : JointKind::kEnd;
  return data_.joints[static_cast<std::size_t>(i - 1)];
}

Point Stroke::position(double u) const noexcept {
  u = clamp_parameter(u, segment_count());
  const int i = std::min(static_cast<int>(u), segment_count() - 1);
  return evaluate(segment(i), u - i);
}

double Stroke::width_mm(double u) const noexcept {
  return width_at(data_.widths, clamp_parameter(u, segment_count()));
}

double Stroke::tone(double u) const noexcept {
  return tone_at(data_.widths, clamp_parameter(u, segment_count()));
}

Rect Stroke::bounds() const noexcept {
  Rect area;
  for (int i = 0; i < segment_count(); ++i) area.extend(felt::bounds(segment(i)));
  const auto widest = std::max_element(
      data_.widths.begin(), data_.widths.end(),
      [](const WidthKnot& a, const WidthKnot& b) { return a.width_mm < b.width_mm; });
  return area.inflated(0.5 * widest->width_mm);
}

}  // namespace felt
