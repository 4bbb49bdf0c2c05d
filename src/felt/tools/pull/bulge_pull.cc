#include "felt/tools/pull/bulge_pull.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/geometry/nearest.h"
#include "felt/stroke/edit/subdivide.h"
#include "felt/tools/brush_reach.h"
#include "felt/tools/handles.h"

namespace felt {
namespace {

constexpr int kMinCircleLooks = 16, kMaxCircleLooks = 1024;  // positions on a segment
constexpr double kLooksPerRadius = 4.0;
constexpr int kCircleHalvings = 50;  // of an interval with a crossing
constexpr int kMaxBulgeRounds = 6;   // in which pieces are halved
constexpr double kBulgeShare = 0.2;  // of the tolerance, during the gesture
/// Ink that is in the circle by less than this does not move, so that it does not matter how the
/// position of a crossing is rounded.
constexpr double kInsideMm = 1e-7;

/// Returns the cubic with the mapped positions and derivatives of both ends.
Cubic mapped_cubic(const RadialMap& map, const Cubic& c) noexcept {
  const Point first = map(c.p[0]), last = map(c.p[3]);
  return {{first, first + map.derivative(c.p[0], c.p[1] - c.p[0]),
           last + map.derivative(c.p[3], c.p[2] - c.p[3]), last}};
}

/// Returns how many positions of a segment are tested for being in a circle, so that their distance
/// is a small part of the radius.
int circle_looks(const Cubic& c, double radius_mm) noexcept {
  const double wanted = kLooksPerRadius * control_length(c) / radius_mm;
  return static_cast<int>(std::clamp<double>(wanted, kMinCircleLooks, kMaxCircleLooks));
}

/// Returns where a curve crosses the circle between two parameters, of which one is inside.
double circle_crossing(const RadialMap& map, const Cubic& c, double low, double high) noexcept {
  const bool before = map.reaches(evaluate(c, low));
  for (int halving = 0; halving < kCircleHalvings; ++halving) {
    const double middle = 0.5 * (low + high);
    (map.reaches(evaluate(c, middle)) == before ? low : high) = middle;
  }
  return high;
}

}  // namespace

Point RadialMap::operator()(Point p) const noexcept {
  if (!reaches(p)) return p;
  const Vec d = p - centre;
  const double factor = 1.0 + gain * influence(norm(d) / radius_mm);
  return factor == 1.0 ? p : centre + factor * d;
}

Vec RadialMap::derivative(Point p, Vec v) const noexcept {
  if (!reaches(p)) return v;
  const Vec d = p - centre;
  const double x = norm(d) / radius_mm;
  // The slope of the influence divided by |d|; finite at the centre.
  const double slope = -6.0 * (1.0 - x) / (radius_mm * radius_mm);
  return (1.0 + gain * influence(x)) * v + gain * slope * dot(d, v) * d;
}

BulgePull::BulgePull(StrokePtr snapshot, const RadialMap& map, double tolerance_mm,
                     std::span<const double> fixed)
    : snapshot_(std::move(snapshot)),
      map_(map),
      tolerance_mm_(tolerance_mm),
      base_(snapshot_->data()) {
  std::vector<double> us = crossings();
  for (const double u : fixed) {
    fixed_.push_back(snapshot_->position(u));
    us.push_back(u);
  }
  std::sort(us.begin(), us.end());
  divide(us);
  mark();
  if (!moves_) return;
  for (int round = 0; round < kMaxBulgeRounds; ++round) {
    const std::vector<double> more = crooked();
    if (more.empty()) break;
    divide(more);
    mark();
  }
  for (std::size_t i = 0; i < is_moved_.size(); ++i) {
    if (is_moved_[i]) give_handles(base_, i);
  }
}

Cubic BulgePull::segment(std::size_t i) const noexcept {
  const Point* p = &base_.points[3 * i];
  return {{p[0], p[1], p[2], p[3]}};
}

void BulgePull::divide(const std::vector<double>& us) {
  if (us.empty()) return;
  const auto divided =
      Stroke::create(base_).and_then([&](const Stroke& stroke) { return subdivided(stroke, us); });
  if (divided) base_ = divided->data();
}

/// Finds the segments that move, even if only a part of them is in the circle.
void BulgePull::mark() {
  is_moved_.assign(base_.points.size() / 3, false);
  for (std::size_t i = 0; i < is_moved_.size(); ++i) {
    is_moved_[i] =
        std::sqrt(nearest(segment(i), map_.centre).distance_squared) < map_.radius_mm - kInsideMm;
  }
  moves_ = std::find(is_moved_.begin(), is_moved_.end(), true) != is_moved_.end();
}

/// Returns the parameters at which the stroke crosses the circle. A passage through the circle that
/// is shorter than the distance of the looks is found only if it is the nearest to the centre.
std::vector<double> BulgePull::crossings() const {
  std::vector<double> us;
  for (std::size_t i = 0; i < base_.points.size() / 3; ++i) {
    const Cubic c = segment(i);
    const int count = circle_looks(c, map_.radius_mm);
    std::vector<double> ts{nearest(c, map_.centre).t};
    for (int k = 0; k <= count; ++k) ts.push_back(static_cast<double>(k) / count);
    std::sort(ts.begin(), ts.end());
    for (std::size_t k = 1; k < ts.size(); ++k) {
      const bool before = map_.reaches(evaluate(c, ts[k - 1]));
      if (before == map_.reaches(evaluate(c, ts[k]))) continue;
      us.push_back(static_cast<double>(i) + circle_crossing(map_, c, ts[k - 1], ts[k]));
    }
  }
  return us;
}

/// Returns the middles of the pieces that one cubic does not approximate when they are mapped.
std::vector<double> BulgePull::crooked() const {
  std::vector<double> middles;
  for (std::size_t i = 0; i < is_moved_.size(); ++i) {
    if (!is_moved_[i]) continue;
    const Cubic c = segment(i), now = mapped_cubic(map_, c);
    for (const double t : {0.25, 0.5, 0.75}) {
      if (distance(evaluate(now, t), map_(evaluate(c, t))) <= kBulgeShare * tolerance_mm_) continue;
      middles.push_back(static_cast<double>(i) + 0.5);
      break;
    }
  }
  return middles;
}

bool BulgePull::is_fixed(Point joint) const noexcept {
  return std::any_of(fixed_.begin(), fixed_.end(),
                     [&](Point p) { return distance(p, joint) < kMinSegmentMm; });
}

Result<Stroke> BulgePull::at(double gain) const {
  if (gain == 0.0 || !moves_) return *snapshot_;
  RadialMap map = map_;
  map.gain = gain;
  StrokeData data = base_;
  for (std::size_t i = 0; i < is_moved_.size(); ++i) {
    if (!is_moved_[i]) continue;
    const Cubic c = mapped_cubic(map, segment(i));
    std::copy(c.p.begin(), c.p.end(), data.points.begin() + static_cast<std::ptrdiff_t>(3 * i));
    keep_length(data, i, segment(i));
  }
  for (std::size_t i = base_.closed ? 0 : 1; i < is_moved_.size(); ++i) {
    const std::size_t before = (i > 0 ? i : is_moved_.size()) - 1;
    if (is_moved_[i] && is_moved_[before]) keep_smooth(data, i, tangent(segment(i), 0.0));
  }
  return Stroke::create(std::move(data));
}

Result<Stroke> BulgePull::finished(double gain) const {
  Result<Stroke> whole = at(gain);
  if (!whole || gain == 0.0 || !moves_) return whole;
  const int n = whole->segment_count();
  // Joints next to ink that did not move, and the fixed points.
  std::vector<int> keep;
  for (std::size_t i = base_.closed ? 0 : 1; i < is_moved_.size(); ++i) {
    const std::size_t before = (i > 0 ? i : is_moved_.size()) - 1;
    const bool is_moved = is_moved_[i] && is_moved_[before];
    if (!is_moved || is_fixed(segment(i).p[0])) keep.push_back(static_cast<int>(i));
  }
  Result<Stroke> few = with_fewer_segments(*whole, 0, base_.closed ? 0 : n, tolerance_mm_, keep);
  return few ? few : whole;
}

}  // namespace felt
