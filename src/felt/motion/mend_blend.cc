#include "felt/motion/mend_blend.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/geometry/cubic.h"
#include "felt/stroke/edit/mend_joints.h"

namespace felt {
namespace {

Cubic cubic_at(const StrokeData& data, std::size_t i) noexcept {
  const Point* p = &data.points[3 * i];
  return Cubic{{p[0], p[1], p[2], p[3]}};
}

/// Joins segments `first` and first + 1. Their outer handles keep their directions.
void join_segments(StrokeData& data, std::size_t first) {
  const Cubic a = cubic_at(data, first), b = cubic_at(data, first + 1);
  const double a_mm = control_length(a), b_mm = control_length(b), sum = a_mm + b_mm;
  const double a_grow = a_mm > 0.01 * sum ? sum / a_mm : 1.0;
  const double b_grow = b_mm > 0.01 * sum ? sum / b_mm : 1.0;
  Point* p = &data.points[3 * first];
  p[1] = a.p[0] + a_grow * (a.p[1] - a.p[0]);
  p[2] = b.p[3] + b_grow * (b.p[2] - b.p[3]);
  p[3] = b.p[3];
  const auto at = data.points.begin() + static_cast<std::ptrdiff_t>(3 * first + 4);
  data.points.erase(at, at + 3);
  data.joints.erase(data.joints.begin() + static_cast<std::ptrdiff_t>(first));
  // The parameters of both become one segment by their lengths.
  const double start = static_cast<double>(first), share = sum > 0.0 ? a_mm / sum : 0.5;
  std::vector<WidthKnot> knots;
  for (WidthKnot knot : data.widths) {
    const double t = knot.u - start;
    if (t > 0.0 && t <= 1.0) knot.u = start + t * share;
    if (t > 1.0 && t < 2.0) knot.u = start + share + (t - 1.0) * (1.0 - share);
    if (t >= 2.0) knot.u -= 1.0;
    if (knots.empty() || knot.u > knots.back().u) knots.push_back(knot);
  }
  knots.back().u = static_cast<double>(data.points.size() / 3);
  data.widths = std::move(knots);
}

/// Replaces a stroke without length by a dot.
void make_dot(StrokeData& data) {
  const Point at = data.points.front();
  const Cubic dot = straight(at, at + Vec{2.0 * kMinSegmentMm, 0.0});
  const WidthKnot start{0.0, data.widths.front().width_mm, data.widths.front().tone};
  const WidthKnot end{1.0, data.widths.back().width_mm, data.widths.back().tone};
  data.points.assign(dot.p.begin(), dot.p.end());
  data.joints.clear();
  data.closed = false;
  data.widths = {start, end};
}

/// Returns the first segment that is too short, or the number of segments.
std::size_t short_segment(const StrokeData& data) noexcept {
  const std::size_t n = data.points.size() / 3;
  for (std::size_t i = 0; i < n; ++i) {
    if (!(control_length(cubic_at(data, i)) >= kMinSegmentMm)) return i;
  }
  return n;
}

void join_short_segments(StrokeData& data) {
  for (;;) {
    const std::size_t n = data.points.size() / 3, i = short_segment(data);
    if (i == n) return;
    if (n == 1) return make_dot(data);
    const bool with_next = i == 0 || (i + 1 < n && control_length(cubic_at(data, i + 1)) <
                                                       control_length(cubic_at(data, i - 1)));
    join_segments(data, with_next ? i : i - 1);
  }
}

}  // namespace

Result<Stroke> mended_blend(StrokeData data) {
  for (const Point p : data.points) {
    if (!is_in_range(p)) return fail(ErrorCode::kInvalidData, "a coordinate is not finite");
  }
  join_short_segments(data);
  if (check_invariants(data)) return Stroke::create(std::move(data));
  mend_rounding(data);
  return Stroke::create(std::move(data));
}

}  // namespace felt
