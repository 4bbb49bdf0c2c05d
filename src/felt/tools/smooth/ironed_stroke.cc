#include "felt/tools/smooth/ironed_stroke.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace felt {
namespace {

/// A cut nearer to a joint than this is that joint: there are no slivers (I5).
constexpr double kNearestCutMm = 1.5 * kMinSegmentMm;
constexpr double kWidthToleranceMm = 0.005;

/// The part [t0, t1] of c. Handles of zero length stay so, as rounding would give them a direction.
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
                           PointAt point_at)
    : stroke_(stroke),
      map_(map),
      places_(places),
      point_at_(std::move(point_at)),
      profile_(stroke.widths()) {
  data_.closed = stroke.closed();
  data_.material = stroke.material();
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

/// Of the ironed line: on the old stroke where that goes on.
Point IronedStroke::point(int k) const {
  if (k == now_.first && !now_.from.turns) return stroke_.position(now_.from.u);
  if (k == now_.last && !now_.to.turns) return stroke_.position(now_.to.u);
  return point_at_(k);
}

/// Direction of the points at place k: between its neighbours, or to one side of a corner or an
/// end, by the parabola through three of them.
Vec IronedStroke::ironed_direction(int k, int side) const {
  const bool is_border =
      (k == now_.first && !now_.from.turns) || (k == now_.last && !now_.to.turns);
  if (!is_border && !places_.is_fixed(k)) {
    return normalized(point(places_.wrapped(k + 1)) - point(places_.wrapped(k - 1)));
  }
  const Point p = point(k), a = point(k + side), b = point(k + 2 * side);
  return normalized(static_cast<double>(side) * (4.0 * (a - p) - (b - p)));
}

/// True when the old stroke leads on from a border without a turn.
bool IronedStroke::goes_on(const Border& border, bool has_more) const {
  if (border.turns || !(has_more || stroke_.closed())) return false;
  return !border.is_joint || stroke_.joint(border.joint()) == JointKind::kSmooth;
}

/// Direction at place k for a segment that leaves it (side 1) or arrives (side -1).
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
  double length = 0.0;
  for (int k = from; k < to; ++k) length += distance(point(k), point(k + 1));
  const Point a = point(from), b = point(to);
  c = {{a, a + (length / 3.0) * start, b - (length / 3.0) * direction(to, -1), b}};
  double way = 0.0;
  for (int k = from + 1; k < to; ++k) {
    way += distance(point(k - 1), point(k));
    const double t = way / length;
    if (std::fabs(cross(tangent(c, t), point(k) - evaluate(c, t))) > kCurveMm) return false;
  }
  return true;
}

IronedStroke::Next IronedStroke::next_segment(int from, Vec start) const {
  Next next;
  int limit = from + 1;
  while (limit < now_.last && !places_.is_fixed(limit)) ++limit;
  for (int step = kLongest; step >= 1; step /= 2) {
    next.end = std::min(from + step, limit);
    if (try_segment(from, next.end, start, next.curve)) break;
  }
  // Where ironing has drawn places together, one to the next is not enough for a segment (I5).
  while (next.end < limit && control_length(next.curve) < kNearestCutMm) {
    try_segment(from, ++next.end, start, next.curve);
  }
  return next;
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
  std::vector<ProfileBuilder::Match> matches{{now_.from.u, static_cast<double>(first_joint)}};
  for (int k = first; k < last;) {
    const Next next = next_segment(k, direction(k, 1));
    for (int i = k + 1; i <= next.end; ++i) {
      const double u = i == last ? now_.to.u : places_.u(i);
      const double v = count() + static_cast<double>(i - k) / (next.end - k);
      if (u > matches.back().u) matches.push_back({u, v});
    }
    push(next.curve, kind_at(next.end));
    k = next.end;
  }
  profile_.follow(matches, kWidthToleranceMm);
  u_ = now_.to.u;
  return {first_joint, count()};
}

Result<Stroke> IronedStroke::finish() && {
  copy_up_to(stroke_.segment_count());
  if (!data_.closed) data_.joints.pop_back();
  data_.widths = std::move(profile_).finish(count());
  return Stroke::create(std::move(data_));
}

}  // namespace felt
