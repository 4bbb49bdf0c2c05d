#include "felt/tools/pull/nib_push.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "felt/geometry/nearest.h"
#include "felt/tools/pull/refit.h"

namespace felt {
namespace {

/// Handles longer than this part of their segment's length make loops (specification 5c, sweep).
constexpr double kLongestHandle = 1.5;

/// The steps of a straight way.
struct Steps {
  Point from, to;
  int count = 1;
  bool may_jump = false;  // steps longer than half a radius

  Steps(Point a, Point b, double radius_mm) noexcept : from(a), to(b) {
    const double wanted = std::ceil(distance(a, b) / (0.5 * radius_mm));
    may_jump = !(wanted <= NibPush::kMostSteps);
    count = may_jump ? NibPush::kMostSteps : std::max(1, static_cast<int>(wanted));
  }
  [[nodiscard]] Point at(int k) const noexcept {
    return k == count ? to : lerp(from, to, static_cast<double>(k) / count);
  }
};

Rect box_of(Point a, Point b) noexcept {
  Rect box;
  box.extend(a);
  box.extend(b);
  return box;
}

/// The parameter at which a segment crosses the straight line from a to b, the one nearest to a, by
/// chords: good enough to take hold of it.
std::optional<double> crossing(const Cubic& c, Point a, Point b) noexcept {
  constexpr int kChords = 16;
  if (!control_bounds(c).intersects(box_of(a, b))) return std::nullopt;
  const Vec way = b - a;
  std::optional<double> found;
  double nearest_part = 2.0;
  Point p = c.p[0];
  for (int k = 1; k <= kChords; ++k) {
    const Point q = evaluate(c, static_cast<double>(k) / kChords);
    const double det = cross(way, q - p);
    const double part = det != 0.0 ? cross(p - a, q - p) / det : 2.0;
    const double along = det != 0.0 ? cross(p - a, way) / det : 2.0;
    if (part >= 0.0 && part <= 1.0 && along >= 0.0 && along <= 1.0 && part < nearest_part) {
      nearest_part = part;
      found = (k - 1 + along) / kChords;
    }
    p = q;
  }
  return found;
}

Rect bounds_of(std::span<const Point> points) noexcept {
  Rect box;
  for (const Point p : points) box.extend(p);
  return box;
}

}  // namespace

bool nib_meets(const Cubic& c, Point from, Point to, double radius_mm) noexcept {
  const Rect box = control_bounds(c);
  if (!box.intersects(box_of(from, to).inflated(radius_mm))) return false;
  const Steps steps(from, to, radius_mm);
  const double near = radius_mm - NibPush::kContactMm;
  for (int k = 0; k <= steps.count; ++k) {
    const Point p = steps.at(k);
    if (distance_squared(box, p) < near * near && nearest_within(c, p, near * near)) return true;
  }
  return steps.may_jump && crossing(c, from, to).has_value();
}

NibPush::NibPush(StrokePtr snapshot, double radius_mm)
    : strand_(snapshot),
      stroke_(std::move(snapshot)),
      box_(bounds_of(strand_.points())),
      radius_mm_(radius_mm),
      is_in_pieces_(static_cast<std::size_t>(stroke_->segment_count()), 0) {}

bool NibPush::move(Point from, Point to, Vec came_from) {
  contact_.reset();
  if (!box_.intersects(box_of(from, to).inflated(radius_mm_))) return false;
  std::optional<Strand> before;
  const Steps steps(from, to, radius_mm_);
  bool moved = false;
  for (int k = 1; k <= steps.count; ++k) {
    const Point p = steps.at(k);
    const auto met = deepest(p);
    if (!met && !steps.may_jump) continue;
    if (!before) before = strand_;
    if (steps.may_jump) moved = catch_jumped(steps.at(k - 1), p) || moved;
    moved = clear(p, came_from) || moved;
  }
  if (!moved) return false;
  Result<Stroke> now = strand_.stroke();
  if (!now) {
    strand_ = *std::move(before);
    return false;
  }
  stroke_ = std::make_shared<const Stroke>(*std::move(now));
  box_ = bounds_of(strand_.points());
  return true;
}

std::optional<NibPush::Nearest> NibPush::deepest(Point p) const {
  const double near = radius_mm_ - kContactMm;
  double best = near * near;
  std::optional<Nearest> found;
  for (int i = 0; i < strand_.count(); ++i) {
    const Cubic c = strand_.segment(i);
    if (distance_squared(control_bounds(c), p) >= best) continue;
    const auto hit = nearest_within(c, p, best);
    if (!hit || hit->distance_squared >= best) continue;
    best = hit->distance_squared;
    found = {{i, hit->t}, hit->point};
  }
  return found;
}

bool NibPush::clear(Point p, Vec came_from) {
  bool moved = false;
  for (int k = 0; k < kCorrections; ++k) {
    auto met = deepest(p);
    if (!met) break;
    if (divide_at(met->place.segment)) met = deepest(p);
    if (!met) break;
    const double depth = distance(p, met->point);
    Vec n = depth > 1e-9 ? (p - met->point) / depth : came_from;
    if (n == Vec{}) n = perp(tangent(strand_.segment(met->place.segment), met->place.t));
    contact_ = p - radius_mm_ * n;
    if (!displace(*met, *contact_)) break;
    moved = true;
  }
  return moved;
}

bool NibPush::catch_jumped(Point from, Point to) {
  bool moved = false;
  const Point beyond = to + radius_mm_ * normalized(to - from);
  for (int round = 0; round < kCorrections; ++round) {
    int i = 0;
    std::optional<double> t;
    while (i < strand_.count() && !(t = crossing(strand_.segment(i), from, to))) ++i;
    if (!t) break;
    if (divide_at(i)) continue;
    if (!displace({{i, *t}, evaluate(strand_.segment(i), *t)}, beyond)) break;
    moved = true;
  }
  return moved;
}

bool NibPush::divide_at(int segment) {
  bool divided = false;
  // The neighbours are bent too. The later ones first, so that the numbers of the others stay.
  std::array<int, 3> parts{strand_.previous(segment), segment, strand_.next(segment)};
  std::sort(parts.begin(), parts.end());
  for (auto i = parts.rbegin(); i != parts.rend(); ++i) {
    if (*i < 0) continue;
    const auto origin = static_cast<std::size_t>(strand_.snapshot_u(*i));
    if (is_in_pieces_[origin] != 0) continue;
    is_in_pieces_[origin] = 1;
    const int most = kMostSegments - strand_.count() + 1;
    divided = strand_.divide_evenly(*i, kPieceRadii * radius_mm_, most) > 1 || divided;
  }
  return divided;
}

bool NibPush::displace(const Nearest& at, Point target) {
  const auto [i, t] = at.place;
  strand_.prepare(i);
  const EditWeights weights = soft_weights(t, strand_.compliance(i, t, false));
  if (!strand_.bend(i, t, weights, target - at.point)) return false;
  for (const int k : {strand_.previous(i), i, strand_.next(i)}) {
    if (k >= 0) strand_.limit_handles(k, kLongestHandle);
  }
  return true;
}

Result<Stroke> NibPush::finished() const {
  return with_good_shapes(strand_);
}

}  // namespace felt
