#include "felt/tools/overlay.h"

#include <algorithm>
#include <cmath>

namespace felt {

void Overlay::clear_ink() noexcept {
  if (!ink.empty()) {
    ink.swap(last_ink_);
    last_stroke_ = ink_stroke;
    last_stable_ = ink_stable;
  }
  ink.clear();
  ink_stroke = 0;
  ink_stable = 0;
}

void Overlay::add_stable_ink(std::uint64_t stroke, std::span<const InkSegment> segments) {
  std::size_t known = 0;
  const bool is_first = ink.empty();
  if (is_first && stroke == last_stroke_) {
    known = std::min({last_stable_, last_ink_.size(), segments.size()});
    ink.swap(last_ink_);
    ink.resize(known);
    last_stroke_ = 0;
  }
  ink.insert(ink.end(), segments.begin() + static_cast<std::ptrdiff_t>(known), segments.end());
  ink_stroke = is_first ? stroke : 0;
  ink_stable = is_first ? segments.size() : 0;
}

Overlay::InkSegment mapped(const Overlay::InkSegment& segment, const Affine& image) noexcept {
  Overlay::InkSegment result = segment;
  result.curve = apply(image, segment.curve);
  return result;
}

void add_span(Overlay& overlay, const Stroke& stroke, double u0, double u1, Overlay::Role role) {
  const int n = stroke.segment_count();
  if (stroke.closed() && u1 <= u0) {
    if (u0 < n) add_span(overlay, stroke, u0, n, role);
    u0 = 0.0;
  }
  u0 = std::clamp(u0, 0.0, static_cast<double>(n));
  u1 = std::clamp(u1, 0.0, static_cast<double>(n));
  for (int i = static_cast<int>(u0); i < n && i < u1; ++i) {
    const double t0 = std::max(0.0, u0 - i), t1 = std::min(1.0, u1 - i);
    overlay.spans.push_back(
        {sub_segment(stroke.segment(i), t0, t1), stroke.width_mm(i + 0.5 * (t0 + t1)), role});
  }
}

}  // namespace felt
