#include "felt/tools/smooth/ironed_stroke.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace felt {
namespace {

/// If a cut is within kNearestCutMm of a joint, it moves to the joint, so that no segment gets too
/// short (I5).
constexpr double kNearestCutMm = 1.5 * kMinSegmentMm;
constexpr double kWidthToleranceMm = 0.005;

/// Returns the part [t0, t1] of c. Sets zero-length handles to zero again, because rounding would
/// give them a direction.
Cubic part_of(const Cubic& c, double t0, double t1) {
  Cubic part = sub_segment(c, t0, t1);
  if (t0 == 0.0 && c.p[1] == c.p[0]) {
    part.p[1] = part.p[0];
    if (c.p[2] == c.p[0]) part.p[2] = part.p[0];
  }
  if (t1 == 1.0 && c.p[2] == c.p[3]) {
    part.p[2] = part.p[3];
    if (c.p[1] == c.p[3]) part.p[1] = part.p[3];
  }
  return part;
}

}  // namespace

IronedStroke::IronedStroke(const Stroke& stroke, const ArcMap& map, const IronPlaces& places,
                           const Ironed& ironed, IronedBlocks& blocks, Detail detail)
    : stroke_(stroke),
      map_(map),
      places_(places),
      ironed_(ironed),
      blocks_(blocks),
      detail_(detail),
      profile_(stroke.widths()) {
  data_.closed = stroke.closed();
  data_.medium = stroke.medium();
  data_.color = stroke.color();
}

IronedStroke::Border IronedStroke::border(int k) const {
  const double u = places_.u(k), length = places_.length_at(k);
  const int n = stroke_.segment_count(), i = std::min(static_cast<int>(u), n - 1);
  if (length - map_.start_of(i) < kNearestCutMm) return {static_cast<double>(i), true, false};
  if (map_.start_of(i + 1) - length < kNearestCutMm)
    return {static_cast<double>(i + 1), true, false};
  return {u, false, false};
}

void IronedStroke::push(const Cubic& c, JointKind end) {
  if (data_.points.empty()) data_.points.push_back(c.p[0]);
  data_.points.insert(data_.points.end(), c.p.begin() + 1, c.p.end());
  data_.joints.push_back(end);
}

void IronedStroke::copy_up_to(double u) {
  while (u_ < u) {
    const int i = static_cast<int>(u_);
    const double t0 = u_ - i, t1 = std::min(1.0, u - i);
    if (t0 == 0.0 && t1 == 1.0) {
      profile_.shift(i, i + 1, count() - i);
      push(stroke_.segment(i), stroke_.joint(i + 1));
    } else {
      profile_.stretch(u_, i + t1, count(), count() + 1);
      push(part_of(stroke_.segment(i), t0, t1),
           t1 == 1.0 ? stroke_.joint(i + 1) : JointKind::kSmooth);
    }
    u_ = t1 == 1.0 ? i + 1 : u;
  }
}

/// Returns the point of the ironed line at place k; at a border, the point of the old stroke.
Point IronedStroke::point(int k) const {
  if (k == now_.first && !now_.from.turns) return stroke_.position(now_.from.u);
  if (k == now_.last && !now_.to.turns) return stroke_.position(now_.to.u);
  const auto i = static_cast<std::size_t>(places_.wrapped(k));
  return ironed_.doses[i] > 0.0 ? ironed_.points[i] : places_.point(k);
}

/// Returns the direction at place k, computed from the points: the direction between its neighbours
/// or, at a corner or an end, that of a parabola through three points on one side.
Vec IronedStroke::ironed_direction(int k, int side) const {
  const bool is_border =
      (k == now_.first && !now_.from.turns) || (k == now_.last && !now_.to.turns);
  if (!is_border && !places_.is_fixed(k)) {
    return normalized(point(places_.wrapped(k + 1)) - point(places_.wrapped(k - 1)));
  }
  const Point p = point(k), a = point(k + side), b = point(k + 2 * side);
  return normalized(static_cast<double>(side) * (4.0 * (a - p) - (b - p)));
}

/// Returns true if the old stroke continues smoothly from a border.
bool IronedStroke::goes_on(const Border& border, bool has_more) const {
  if (border.turns || !(has_more || stroke_.closed())) return false;
  return !border.is_joint || stroke_.joint(border.joint()) == JointKind::kSmooth;
}

/// Returns the direction at place k for a segment that leaves it (side 1) or arrives (side -1).
Vec IronedStroke::direction(int k, int side) const {
  const int n = stroke_.segment_count();
  if (k == now_.first && goes_on(now_.from, k > 0)) {
    if (count() == 0) return tangent(stroke_.segment(n - 1), 1.0);
    const auto end = data_.points.end();
    return tangent(Cubic{{end[-4], end[-3], end[-2], end[-1]}}, 1.0);
  }
  if (k == now_.last && goes_on(now_.to, k < places_.count())) {
    const int i = now_.to.joint() % n;
    const double t = now_.to.is_joint ? 0.0 : now_.to.u - i;
    return tangent(part_of(stroke_.segment(i), t, 1.0), 0.0);
  }
  return ironed_direction(k, side);
}

bool IronedStroke::try_segment(int from, int to, Vec start, Cubic& c) const {
  std::array<Point, kLongest + 1> points;
  std::array<double, kLongest + 1> ways{};
  // A segment over more than kLongest places need not be near the ironed points.
  const bool follows = to - from <= kLongest;
  double length = 0.0;
  Point last = point(from);
  points[0] = last;
  for (int k = from + 1; k <= to; ++k) {
    const Point p = point(k);
    length += distance(last, p);
    last = p;
    if (!follows) continue;
    points[static_cast<std::size_t>(k - from)] = p;
    ways[static_cast<std::size_t>(k - from)] = length;
  }
  c = {{points[0], points[0] + (length / 3.0) * start, last - (length / 3.0) * direction(to, -1),
        last}};
  for (std::size_t i = 1; follows && i < static_cast<std::size_t>(to - from); ++i) {
    const double t = ways[i] / length;
    if (std::fabs(cross(tangent(c, t), points[i] - evaluate(c, t))) > kCurveMm) return false;
  }
  return follows;
}

IronedStroke::Next IronedStroke::next_segment(int from, Vec start) const {
  Next next;
  int limit = std::min(now_.last, from - from % kLongest + kLongest);
  for (int k = from + 1; k < limit; ++k) {
    if (places_.is_fixed(k)) limit = k;
  }
  for (int step = kLongest; step >= 1; step /= 2) {
    next.end = std::min(from + step, limit);
    if (try_segment(from, next.end, start, next.curve)) break;
  }
  // If ironing has moved places close together, one step is too short for a segment (I5).
  while (next.end < now_.last && !places_.is_fixed(next.end) &&
         control_length(next.curve) < kNearestCutMm) {
    try_segment(from, ++next.end, start, next.curve);
  }
  return next;
}

/// Returns the segments from a place to the end of its block or of the stretch. The last segment
/// may extend slightly beyond that.
std::span<const IronedStroke::Next> IronedStroke::block(int from) {
  const int end = std::min(now_.last, from - from % kLongest + kLongest);
  // Segments that depend on an end of the stretch are not cached, because the stretch grows.
  const bool is_whole = from % kLongest == 0 && from > now_.first && end < now_.last;
  IronedBlocks::Block& kept = blocks_.at(from);
  if (is_whole && kept.is_good) return kept.segments;
  std::vector<Next>& segments = is_whole ? kept.segments : border_;
  segments.clear();
  for (int k = from; k < end; k = segments.back().end) {
    segments.push_back(next_segment(k, direction(k, 1)));
  }
  kept.is_good = is_whole && segments.back().end == end;
  return segments;
}

JointKind IronedStroke::kind_at(int k) const {
  const bool is_border = k == now_.last && !now_.to.turns;
  if (is_border) return now_.to.is_joint ? stroke_.joint(now_.to.joint()) : JointKind::kSmooth;
  return places_.is_fixed(k) ? JointKind::kCorner : JointKind::kSmooth;
}

IronedStroke::Joints IronedStroke::add(int first, int last, bool turns_seam) {
  now_ = {first, last, border(first), border(last)};
  now_.from.turns = first == 0 && turns_seam;
  now_.to.turns = last == places_.count() && turns_seam;
  copy_up_to(now_.from.u);
  const int first_joint = count();
  matches_.assign(1, {now_.from.u, static_cast<double>(first_joint)});
  for (int k = first; k < last;) {
    for (const Next& next : block(k)) {
      add_segment(k, next);
      k = next.end;
    }
  }
  if (detail_ == Detail::kExact) {
    profile_.follow(matches_, kWidthToleranceMm);
  } else {
    for (std::size_t i = 1; i < matches_.size(); ++i) {
      profile_.stretch(matches_[i - 1].u, matches_[i].u, matches_[i - 1].v, matches_[i].v);
    }
  }
  u_ = now_.to.u;
  return {first_joint, count()};
}

void IronedStroke::add_segment(int from, const Next& next) {
  const int step = detail_ == Detail::kShown ? next.end - from : 1;
  for (int i = from + step; i <= next.end; i += step) {
    const double u = i == now_.last ? now_.to.u : places_.u(i);
    const double v = count() + static_cast<double>(i - from) / (next.end - from);
    if (u > matches_.back().u) matches_.push_back({u, v});
  }
  push(next.curve, kind_at(next.end));
}

Result<Stroke> IronedStroke::finish() && {
  copy_up_to(stroke_.segment_count());
  if (!data_.closed) data_.joints.pop_back();
  data_.widths = std::move(profile_).finish(count());
  return Stroke::create(std::move(data_));
}

}  // namespace felt
