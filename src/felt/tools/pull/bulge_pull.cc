#include "felt/tools/pull/bulge_pull.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/stroke/edit/subdivide.h"
#include "felt/tools/pull/brush_reach.h"
#include "felt/tools/pull/handles.h"

namespace felt {
namespace {

constexpr int kCircleLooks = 16;     // positions on a segment at which a crossing is searched
constexpr int kCircleHalvings = 50;  // of an interval with a crossing
constexpr int kMaxBulgeRounds = 6;   // in which pieces are halved
constexpr double kBulgeShare = 0.2;  // of the tolerance, during the gesture

/// Returns the cubic with the mapped positions and derivatives of both ends.
Cubic mapped_cubic(const RadialMap& map, const Cubic& c) noexcept {
  const Point first = map(c.p[0]), last = map(c.p[3]);
  return {{first, first + map.derivative(c.p[0], c.p[1] - c.p[0]),
           last + map.derivative(c.p[3], c.p[2] - c.p[3]), last}};
}

}  // namespace

Point RadialMap::operator()(Point p) const noexcept {
  if (!reaches(p)) return p;
  const Vec d = p - centre;
  return centre + (1.0 + gain * influence(norm(d) / radius_mm)) * d;
}

Vec RadialMap::derivative(Point p, Vec v) const noexcept {
  if (!reaches(p)) return v;
  const Vec d = p - centre;
  const double x = norm(d) / radius_mm;
  // The slope of the influence divided by |d|; finite at the centre.
  const double slope = -6.0 * (1.0 - x) / (radius_mm * radius_mm);
  return (1.0 + gain * influence(x)) * v + gain * slope * dot(d, v) * d;
}

BulgePull::BulgePull(StrokePtr snapshot, const RadialMap& map, double tolerance_mm)
    : snapshot_(std::move(snapshot)),
      map_(map),
      tolerance_mm_(tolerance_mm),
      base_(snapshot_->data()) {
  divide(crossings());
  mark();
  if (!moves_) return;
  for (int round = 0; round < kMaxBulgeRounds; ++round) {
    std::vector<double> more = crooked();
    if (more.empty()) break;
    divide(std::move(more));
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

void BulgePull::divide(std::vector<double> us) {
  if (us.empty()) return;
  const auto divided =
      Stroke::create(base_).and_then([&](const Stroke& stroke) { return subdivided(stroke, us); });
  if (divided) base_ = divided->data();
}

/// Finds the segments that move, even if only a part of them is in the circle.
void BulgePull::mark() {
  is_moved_.assign(base_.points.size() / 3, false);
  for (std::size_t i = 0; i < is_moved_.size(); ++i) {
    const Cubic c = segment(i);
    for (int k = 0; k <= kCircleLooks && !is_moved_[i]; ++k) {
      is_moved_[i] = map_.reaches(evaluate(c, static_cast<double>(k) / kCircleLooks));
    }
  }
  moves_ = std::find(is_moved_.begin(), is_moved_.end(), true) != is_moved_.end();
}

/// Returns the parameters at which the stroke crosses the circle, ascending.
std::vector<double> BulgePull::crossings() const {
  std::vector<double> us;
  for (std::size_t i = 0; i < base_.points.size() / 3; ++i) {
    const Cubic c = segment(i);
    bool was_inside = map_.reaches(c.p[0]);
    for (int k = 1; k <= kCircleLooks; ++k) {
      double low = static_cast<double>(k - 1) / kCircleLooks,
             high = static_cast<double>(k) / kCircleLooks;
      const bool before = std::exchange(was_inside, map_.reaches(evaluate(c, high)));
      if (before == was_inside) continue;
      for (int halving = 0; halving < kCircleHalvings; ++halving) {
        const double middle = 0.5 * (low + high);
        (map_.reaches(evaluate(c, middle)) == before ? low : high) = middle;
      }
      // The side of the crossing that is outside, so that the joint does not move.
      us.push_back(static_cast<double>(i) + (before ? high : low));
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
  return Stroke::create(std::move(data));
}

Result<Stroke> BulgePull::finished(double gain) const {
  Result<Stroke> whole = at(gain);
  if (!whole || gain == 0.0 || !moves_) return whole;
  const int n = whole->segment_count();
  std::vector<int> keep;  // the ends of ink that did not move
  for (std::size_t i = 0; i < is_moved_.size(); ++i) {
    if (is_moved_[i]) continue;
    keep.push_back(static_cast<int>(i));
    if (static_cast<int>(i) + 1 < n || !base_.closed) keep.push_back(static_cast<int>(i) + 1);
  }
  Result<Stroke> few = with_fewer_segments(*whole, 0, base_.closed ? 0 : n, tolerance_mm_, keep);
  return few ? few : whole;
}

}  // namespace felt
