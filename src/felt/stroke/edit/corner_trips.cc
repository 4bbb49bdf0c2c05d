#include "felt/stroke/edit/corner_trips.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

constexpr double kAfterJumpU =
    0.01;  // widths jump within 1e-4 beside a trip (kSvgJumpU), more after a cut

/// Segment `from` of a stroke, which becomes segment `to`.
struct KeptSegment {
  int from, to;
  bool after_trip, before_trip;
};

/// Appends the breakpoints of a segment. Beside a trip, the width is the one beyond the jump.
void append_widths_of(const Stroke& stroke, const KeptSegment& kept, std::vector<WidthKnot>& out) {
  const auto all = stroke.widths();
  const auto before = [](const WidthKnot& k, double u) { return k.u < u; };
  const double begin = kept.from, end = kept.from + 1.0;
  // The breakpoints inside the segment.
  auto first = std::lower_bound(all.begin(), all.end(), std::nextafter(begin, end), before);
  auto last = std::lower_bound(first, all.end(), end, before);
  WidthKnot start = knot_at(all, begin), stop = knot_at(all, end);
  if (kept.after_trip) {
    for (; first != last && first->u <= begin + kAfterJumpU; ++first) start = *first;
  }
  if (kept.before_trip) {
    for (; first != last && std::prev(last)->u >= end - kAfterJumpU; --last)
      stop = *std::prev(last);
  }
  const auto append = [&](double u, WidthKnot knot) {
    knot.u = u;
    if (out.empty() || u > out.back().u) out.push_back(knot);
  };
  append(kept.to, start);
  for (; first != last; ++first) append(kept.to + (first->u - kept.from), *first);
  append(kept.to + 1, stop);
}

/// Returns the segments that are no part of a trip.
std::vector<int> segments_beside_trips(const Stroke& stroke) {
  std::vector<int> kept;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    if (is_corner_trip(stroke, i)) {
      ++i;
    } else {
      kept.push_back(i);
    }
  }
  return kept;
}

/// Returns the middle of a flat end whose two trips begin at segments `first` and first + 2, with
/// half the width of the tips added; nullopt without such an end.
std::optional<Point> flat_end(const Stroke& stroke, int first) {
  if (first < 0 || !is_corner_trip(stroke, first) || first + 2 >= stroke.segment_count() ||
      !is_corner_trip(stroke, first + 2)) {
    return std::nullopt;
  }
  const Point base = stroke.segment(first).p[0];
  const Point middle = lerp(stroke.segment(first).p[3], stroke.segment(first + 2).p[3], 0.5);
  return middle + 0.5 * stroke.width_mm(first + 1.0) * normalized(middle - base);
}

/// Moves the start of a straight segment to `end` if this only makes it longer.
void lengthen(Cubic& c, Point end) {
  constexpr double kStraightMm = 1e-3;
  const Vec along = normalized(c.p[3] - c.p[0]);
  const auto is_beside = [&](Point p) { return std::fabs(cross(along, p - c.p[0])) > kStraightMm; };
  if (is_beside(c.p[1]) || is_beside(c.p[2]) || is_beside(end)) return;
  if (dot(along, end - c.p[0]) >= 0.0) return;
  const bool is_line = c.p == straight(c.p[0], c.p[3]).p;
  c.p[0] = end;
  if (is_line) c = straight(end, c.p[3]);
}

}  // namespace

bool is_corner_trip(const Stroke& stroke, int i) noexcept {
  constexpr double kSameMm = 1e-3;       // files round coordinates
  constexpr double kPointedShare = 0.5;  // of the broader way's width, at the tip
  constexpr double kMaxWidths = 10.0;    // a longer one is a line; a miter limit of 4 gives 2
  if (i + 1 >= stroke.segment_count()) return false;
  const double width =
      std::max(stroke.width_mm(i + kAfterJumpU), stroke.width_mm(i + 2.0 - kAfterJumpU));
  if (!(stroke.width_mm(i + 1.0) < kPointedShare * width)) return false;
  const Cubic out = stroke.segment(i);
  if (distance(out.p[0], out.p[3]) > kMaxWidths * width) return false;
  const Cubic back = reversed(stroke.segment(i + 1));
  return std::equal(out.p.begin(), out.p.end(), back.p.begin(),
                    [](Point a, Point b) { return distance(a, b) <= kSameMm; });
}

bool has_corner_trips(const Stroke& stroke) noexcept {
  for (int i = 0; i + 1 < stroke.segment_count(); ++i) {
    if (is_corner_trip(stroke, i)) return true;
  }
  return false;
}

std::optional<Stroke> without_corner_trips(const Stroke& stroke) {
  if (!has_corner_trips(stroke)) return std::nullopt;
  const std::vector<int> kept = segments_beside_trips(stroke);
  const auto count = static_cast<int>(kept.size());
  if (count == stroke.segment_count() || count == 0) return std::nullopt;
  StrokeData data;
  data.closed = stroke.closed();
  data.medium = stroke.medium();
  data.color = stroke.color();
  const int n = stroke.segment_count();
  const std::optional<Point> start = flat_end(stroke, kept.front() == 4 ? 0 : -1);
  const std::optional<Point> end = flat_end(stroke, kept.back() == n - 5 ? n - 4 : -1);
  for (int k = 0; k < count; ++k) {
    const int from = kept[static_cast<std::size_t>(k)];
    const int before = k > 0 ? kept[static_cast<std::size_t>(k) - 1] : -1;
    const int next = k + 1 < count ? kept[static_cast<std::size_t>(k) + 1] : n;
    Cubic c = stroke.segment(from);
    if (k == 0 && start && !data.closed) lengthen(c, *start);
    if (k + 1 == count && end && !data.closed) {
      c = reversed(c);
      lengthen(c, *end);
      c = reversed(c);
    }
    if (k == 0) data.points.push_back(c.p[0]);
    data.points.insert(data.points.end(), c.p.begin() + 1, c.p.end());
    if (k + 1 < count || data.closed) {
      const bool is_same = next == from + 1 && (next < n || kept.front() == 0);
      data.joints.push_back(is_same ? stroke.joint(next) : JointKind::kCorner);
    }
    append_widths_of(stroke, {from, k, before + 1 < from, from + 1 < next}, data.widths);
  }
  if (data.closed) data.points.back() = data.points.front();
  Result<Stroke> plain = Stroke::create(std::move(data));
  if (!plain) return std::nullopt;
  return *std::move(plain);
}

}  // namespace felt
