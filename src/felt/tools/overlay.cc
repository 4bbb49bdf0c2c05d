#include "felt/tools/overlay.h"

#include <algorithm>
#include <cmath>

namespace felt {

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
