#include "felt/tools/smooth/iron_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace felt {
namespace {

/// Directions are taken over chords of so many places to both sides, 2 mm.
constexpr int kChord = 4;

}  // namespace

IronPlaces::IronPlaces(const Stroke& stroke, const ArcMap& map, bool keep_corners)
    : stroke_(stroke), map_(map) {
  const int n = stroke.segment_count();
  lengths_.push_back(0.0);
  fixed_.push_back(!closed() || (keep_corners && is_corner_at(n)));
  double from = 0.0;
  for (int joint = 1; joint < n; ++joint) {
    if (!keep_corners || !is_corner_at(joint)) continue;
    add_span(from, map.start_of(joint));
    from = map.start_of(joint);
  }
  add_span(from, map.length_mm());
  fixed_.back() = fixed_.front();
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  us_.assign(lengths_.size(), unknown);
  us_.front() = 0.0;
  us_.back() = n;
  turns_.assign(lengths_.size(), unknown);
  points_.resize(lengths_.size());
  points_.front() = stroke.data().points.front();
  points_.back() = stroke.data().points.back();
}

/// Places after `from` up to `to`, which is fixed.
void IronPlaces::add_span(double from_mm, double to_mm) {
  const double cells = std::min((to_mm - from_mm) / kSpacingMm, 1e7);
  const int count = std::max(1, static_cast<int>(std::lround(cells)));
  for (int i = 1; i <= count; ++i) {
    lengths_.push_back(i == count ? to_mm : from_mm + (to_mm - from_mm) * i / count);
    fixed_.push_back(i == count);
  }
}

bool IronPlaces::is_corner_at(int joint) const {
  if (stroke_.joint(joint) != JointKind::kCorner) return false;
  const double at = map_.start_of(joint), whole = map_.length_mm();
  const double arm = std::min(kCornerArmMm, 0.25 * whole);
  // From the mean of the near half of an arm to that of its far half: a single spike has no say.
  const auto direction = [&](double side) {
    constexpr int kHalf = 6;
    Vec sum;
    for (int i = 1; i <= 2 * kHalf; ++i) {
      double s = at + side * arm * i / (2 * kHalf);
      if (!closed()) s = std::clamp(s, 0.0, whole);
      const Vec v = stroke_.position(map_.u_at(s)) - Point{};
      sum += i <= kHalf ? -v : v;
    }
    return side * sum;
  };
  return angle_between(direction(-1.0), direction(1.0)) > kCornerDeg * std::numbers::pi / 180.0;
}

int IronPlaces::nearest(double length_mm) const noexcept {
  const auto next = std::lower_bound(lengths_.begin(), lengths_.end(), length_mm);
  const int k = static_cast<int>(next - lengths_.begin());
  if (k > count()) return count();
  return k > 0 && length_mm - length_at(k - 1) < length_at(k) - length_mm ? k - 1 : k;
}

int IronPlaces::wrapped(int k) const noexcept {
  if (!closed()) return std::clamp(k, 0, count());
  const int rest = k % count();
  return rest < 0 ? rest + count() : rest;
}

double IronPlaces::u(int k) const {
  const auto i = static_cast<std::size_t>(k);
  if (std::isnan(us_[i])) {
    us_[i] = map_.u_at(lengths_[i]);
    points_[i] = stroke_.position(us_[i]);
  }
  return us_[i];
}

Point IronPlaces::point(int k) const {
  static_cast<void>(u(k));  // works it out
  return points_[static_cast<std::size_t>(k)];
}

/// By how much the direction turns from place k to the next one, rad.
double IronPlaces::turn(int k) const {
  double& turn = turns_[static_cast<std::size_t>(k)];
  if (std::isnan(turn)) {
    const auto chord = [&](int i) {
      return point(wrapped(i + kChord)) - point(wrapped(i - kChord));
    };
    const Vec a = chord(k), b = chord(k + 1);
    turn = std::atan2(cross(a, b), dot(a, b));
  }
  return turn;
}

double IronPlaces::from_fixed_mm(int k, double most_mm) const noexcept {
  const double at = length_at(k);
  for (int i = 0;; ++i) {
    double nearest = most_mm;
    for (const int side : {-1, 1}) {
      const int place = closed() ? wrapped(k + side * i) : std::clamp(k + side * i, 0, count());
      const double way = std::fabs(map_.way(at, length_at(place)));
      if (is_fixed(place)) return std::min(way, most_mm);
      nearest = std::min(nearest, way);
    }
    if (nearest >= most_mm || i > count()) return most_mm;
  }
}

double IronPlaces::mean_curvature(int k, double window_mm) const {
  const int half = std::max(2, static_cast<int>(0.5 * window_mm / kSpacingMm));
  double sum = 0.0, length = 0.0;
  // Outwards to both sides, up to the next fixed place: a corner is no bend.
  for (const int side : {-1, 1}) {
    for (int i = 0; i < half; ++i) {
      const int from = k + side * i - (side < 0 ? 1 : 0);
      if (!closed() && (from < 0 || from >= count())) break;
      const int at = wrapped(from);
      if (is_fixed(side < 0 ? wrapped(from + 1) : at) && i > 0) break;
      sum += turn(at);
      length += length_at(at + 1) - length_at(at);
    }
  }
  return length > 0.0 ? std::fabs(sum) / length : 0.0;
}

}  // namespace felt
