#include "felt/stroke/edit/split.h"

#include <algorithm>
#include <cmath>

#include "felt/base/check.h"
#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

/// Returns the part of c with t in [t0, t1]. If an end of c is also an end of the part, a zero
/// handle there is kept exactly zero, because rounding would give it a direction, which would
/// become the tangent (I2).
Cubic part(const Cubic& c, double t0, double t1) noexcept {
  Cubic result = sub_segment(c, t0, t1);
  if (t0 == 0.0 && c.p[1] == c.p[0]) result.p[1] = result.p[0];
  if (t1 == 1.0 && c.p[2] == c.p[3]) result.p[2] = result.p[3];
  return result;
}

/// Appends a breakpoint, unless rounding moved it to the position of the last one or before it.
void append(std::vector<WidthKnot>& knots, WidthKnot k) {
  if (knots.empty() || k.u > knots.back().u) knots.push_back(k);
}

/// Segments `first` to `last` of a stroke; the first one starts at t0 and the last one ends at t1.
/// On a closed stroke, index n + i means segment i after the seam.
struct Span {
  int first, last;
  double t0, t1;

  static Span of(double u0, double u1) noexcept {
    const int first = static_cast<int>(std::floor(u0));
    const int last = std::max(first, static_cast<int>(std::ceil(u1)) - 1);
    return {first, last, u0 - first, u1 - last};
  }
  [[nodiscard]] double begin_t(int i) const noexcept { return i == first ? t0 : 0.0; }
  [[nodiscard]] double end_t(int i) const noexcept { return i == last ? t1 : 1.0; }
  /// Returns true if segment i is cut, so that its parameter is stretched.
  [[nodiscard]] bool cut(int i) const noexcept { return end_t(i) - begin_t(i) < 1.0; }
};

/// Appends the breakpoints of segment i of the span, except the breakpoint at its end.
void append_widths(const Stroke& stroke, const Span& span, int i, std::vector<WidthKnot>& out) {
  const auto knots = stroke.widths();
  const int segment = i % stroke.segment_count();
  const double begin = segment + span.begin_t(i), end = segment + span.end_t(i);
  const double shifted = i - span.first;
  auto k = std::lower_bound(knots.begin(), knots.end(), begin,
                            [](const WidthKnot& a, double u) { return a.u < u; });
  const bool knot_here = k != knots.end() && k->u == begin;
  if (i == span.first || knot_here || span.cut(i) || span.cut(i - 1)) {
    const WidthKnot here = knot_at(knots, begin);
    append(out, {shifted, here.width_mm, here.tone});
  }
  const double scale = 1.0 / (end - begin);
  for (k += knot_here ? 1 : 0; k != knots.end() && k->u < end; ++k) {
    const double within = span.cut(i) ? (k->u - begin) * scale : k->u - segment;
    append(out, {shifted + within, k->width_mm, k->tone});
  }
}

/// At the seam of a closed stroke the profile may step from its last to its first width or tone.
/// Appends the step as two breakpoints that are one unit in the last place apart.
void append_seam(const Stroke& stroke, double u, std::vector<WidthKnot>& out) {
  const WidthKnot& before = stroke.widths().back();
  const WidthKnot& after = stroke.widths().front();
  if (before.width_mm == after.width_mm && before.tone == after.tone) return;
  append(out, {u, before.width_mm, before.tone});
  append(out, {std::nextafter(u, u + 1.0), after.width_mm, after.tone});
}

}  // namespace

Result<Stroke> sub_stroke(const Stroke& stroke, double u0, double u1) {
  const int n = stroke.segment_count();
  if (std::isnan(u0) || std::isnan(u1)) {
    return fail(ErrorCode::kInvalidArgument, "the range of a sub-stroke is not a number");
  }
  u0 = std::clamp(u0, 0.0, static_cast<double>(n));
  u1 = std::clamp(u1, 0.0, static_cast<double>(n));
  if (u0 >= u1) {
    if (!stroke.closed()) {
      return fail(ErrorCode::kInvalidArgument, "the range of a sub-stroke is empty");
    }
    u1 += n;
  }
  const Span span = Span::of(u0, u1);
  StrokeData data{.points = {},
                  .joints = {},
                  .closed = false,
                  .widths = {},
                  .medium = stroke.medium(),
                  .color = stroke.color()};
  for (int i = span.first; i <= span.last; ++i) {
    const Cubic c = part(stroke.segment(i % n), span.begin_t(i), span.end_t(i));
    if (i == span.first) data.points.push_back(c.p[0]);
    data.points.insert(data.points.end(), c.p.begin() + 1, c.p.end());
    if (i > span.first) data.joints.push_back(stroke.joint(i % n));
    if (i > span.first && i % n == 0) append_seam(stroke, i - span.first, data.widths);
    append_widths(stroke, span, i, data.widths);
  }
  const double end = span.last - span.first + 1;
  while (data.widths.back().u >= end) data.widths.pop_back();
  const WidthKnot last = knot_at(stroke.widths(), span.last % n + span.t1);
  data.widths.push_back({end, last.width_mm, last.tone});
  return Stroke::create(std::move(data));
}

Result<std::pair<Stroke, Stroke>> split(const Stroke& stroke, double u) {
  if (stroke.closed()) {
    return fail(ErrorCode::kInvalidArgument,
                "a closed stroke cannot be divided into two parts by one cut");
  }
  auto before = sub_stroke(stroke, 0.0, u);
  if (!before) return tl::unexpected<Error>(std::move(before.error()));
  auto after = sub_stroke(stroke, u, stroke.segment_count());
  if (!after) return tl::unexpected<Error>(std::move(after.error()));
  return std::pair(*std::move(before), *std::move(after));
}

Stroke reversed(const Stroke& stroke) {
  StrokeData data = stroke.data();
  const double n = stroke.segment_count();
  std::reverse(data.points.begin(), data.points.end());
  // The seam of a closed stroke stays the last joint.
  std::reverse(data.joints.begin(), data.joints.end() - (data.closed ? 1 : 0));
  data.widths.clear();
  for (auto k = stroke.widths().rbegin(); k != stroke.widths().rend(); ++k) {
    append(data.widths, {n - k->u, k->width_mm, k->tone});
  }
  // Rounding of n - u may already have moved the last breakpoint to n. Then the breakpoint at the
  // end replaces it.
  const WidthKnot& end = stroke.widths().front();
  if (data.widths.back().u == n) data.widths.pop_back();
  data.widths.push_back({n, end.width_mm, end.tone});
  auto turned = Stroke::create(std::move(data));
  FELT_CHECK(turned.has_value());
  return *std::move(turned);
}

}  // namespace felt
