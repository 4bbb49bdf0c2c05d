#include "felt/tools/smooth/iron_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "felt/geometry/polyline.h"

namespace felt {
namespace {

/// Directions are measured over chords of kChord places to each side, 2 mm in total.
constexpr int kChord = 4;
/// A line is straight if its chord is longer than this share of it.
constexpr double kStraightShare = 0.95;

/// Returns for each point the mean over `half` points to each side. Near the ends fewer points are
/// used, and the ends stay in place.
std::vector<Point> mean_of(const std::vector<Point>& points, std::size_t half) {
  const Point origin = points.front();
  std::vector<Vec> sums{Vec{}};  // prefix sums, relative to origin
  sums.reserve(points.size() + 1);
  for (const Point p : points) sums.push_back(sums.back() + (p - origin));
  std::vector<Point> means;
  means.reserve(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::size_t h = std::min({half, k, points.size() - 1 - k});
    const double count = static_cast<double>(2 * h + 1);
    means.push_back(origin + (sums[k + h + 1] - sums[k - h]) / count);
  }
  return means;
}

}  // namespace

IronPlaces::IronPlaces(const Stroke& stroke, const ArcMap& map, bool keep_corners)
    : stroke_(stroke), map_(map) {
  const int n = stroke.segment_count();
  lengths_.push_back(0.0);
  fixed_.push_back(!closed() || (keep_corners && is_corner_at(n)));
  int from = 0;
  for (const int joint : keep_corners ? corners() : std::vector<int>{}) {
    add_span(from, joint);
    from = joint;
  }
  add_span(from, n);
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

/// Samples the span about every kSpacingMm of its ink.
std::vector<IronPlaces::Step> IronPlaces::steps_between(int from_joint, int to_joint) const {
  std::vector<Step> steps{{map_.start_of(from_joint), 0.0}};
  std::vector<Point> points{stroke_.segment(from_joint).p[0]};
  for (int i = from_joint; i < to_joint; ++i) {
    const double start = map_.start_of(i), length = map_.start_of(i + 1) - start;
    const int n = 1 + static_cast<int>(std::min(length / kSpacingMm, 1e6));
    const Cubic c = stroke_.segment(i);
    const std::size_t first = steps.size();
    double chords = 0.0;
    for (int j = 1; j <= n; ++j) {
      points.push_back(j == n ? c.p[3] : evaluate(c, static_cast<double>(j) / n));
      chords += distance(points[points.size() - 2], points.back());
      steps.push_back({chords, 0.0});
    }
    for (std::size_t j = first; j < steps.size(); ++j) {
      const double share = chords > 0.0 ? steps[j].length_mm / chords : 1.0;
      steps[j].length_mm = start + share * length;
    }
  }
  // A moving mean M of the points P flattens bends by about M(P) - M(M(P)). Adding this difference,
  // 2 M(P) - M(M(P)), corrects most of that.
  constexpr auto kHalf = static_cast<std::size_t>(0.5 * kGuideMm / kSpacingMm);
  // If the seam is not a corner, the ink continues across it, so points from the other side are
  // added at both ends.
  const std::size_t size = points.size(), largest = 2 * kHalf;
  const bool goes_round = !fixed_.front() && from_joint == 0 && to_joint == stroke_.segment_count();
  const std::size_t pad = goes_round ? std::min(largest, size - 1) : 0;
  const std::vector<Point> ring = points;
  points.insert(points.begin(), ring.end() - 1 - static_cast<std::ptrdiff_t>(pad), ring.end() - 1);
  points.insert(points.end(), ring.begin() + 1,
                ring.begin() + 1 + static_cast<std::ptrdiff_t>(pad));
  const std::vector<Point> once = mean_of(points, kHalf), twice = mean_of(once, kHalf);
  const auto guide = [&](std::size_t k) {
    return once[pad + k] + (once[pad + k] - twice[pad + k]);
  };
  for (std::size_t k = 1; k < steps.size(); ++k) {
    const double ink = steps[k].length_mm - steps[k - 1].length_mm;
    const double way = distance(guide(k - 1), guide(k));
    steps[k].way_mm = steps[k - 1].way_mm + std::clamp(way, ink / kMaxInflation, ink);
  }
  return steps;
}

/// Adds the places after joint `from_joint` up to and including joint `to_joint`, which is fixed or
/// the seam.
void IronPlaces::add_span(int from_joint, int to_joint) {
  const std::vector<Step> steps = steps_between(from_joint, to_joint);
  const double whole = steps.back().way_mm;
  const int count = std::max(1, static_cast<int>(std::lround(std::min(whole / kSpacingMm, 1e7))));
  std::size_t next = 1;
  for (int i = 1; i < count; ++i) {
    const double way = whole * i / count;
    while (next + 1 < steps.size() && steps[next].way_mm < way) ++next;
    const Step &a = steps[next - 1], &b = steps[next];
    const double t = b.way_mm > a.way_mm ? (way - a.way_mm) / (b.way_mm - a.way_mm) : 1.0;
    lengths_.push_back(a.length_mm + std::clamp(t, 0.0, 1.0) * (b.length_mm - a.length_mm));
    fixed_.push_back(false);
  }
  lengths_.push_back(map_.start_of(to_joint));
  fixed_.push_back(true);
}

double IronPlaces::inflation(int k) const noexcept {
  const int a = std::max(k - 1, 0), b = std::min(k + 1, count());
  const double ink = length_at(b) - length_at(a);
  return std::clamp(ink / ((b - a) * kSpacingMm), 1.0, kMaxInflation);
}

std::vector<int> IronPlaces::corners() const {
  const int n = stroke_.segment_count();
  std::vector<int> found{0};  // includes both ends
  for (int joint = 1; joint < n; ++joint) {
    if (is_corner_at(joint)) found.push_back(joint);
  }
  found.push_back(n);
  const auto point_of = [&](std::size_t i) {
    return stroke_.data().points[3 * static_cast<std::size_t>(found[i])];
  };
  const auto turn_of = [&](std::size_t i) {
    return cross(point_of(i) - point_of(i - 1), point_of(i + 1) - point_of(i));
  };
  const auto is_near = [&](std::size_t i, std::size_t j) {
    return map_.start_of(found[j]) - map_.start_of(found[i]) <= kShakeLengthMm;
  };
  const auto is_shake = [&](std::size_t i) {
    const bool before = i > 1 && is_near(i - 1, i) && turn_of(i - 1) * turn_of(i) < 0.0;
    const bool after =
        i + 2 < found.size() && is_near(i, i + 1) && turn_of(i + 1) * turn_of(i) < 0.0;
    const double height =
        std::sqrt(nearest_on_line(point_of(i - 1), point_of(i + 1), point_of(i)).distance_squared);
    return (before || after) && height <= kShakeHeightMm;
  };
  std::vector<int> kept;
  for (std::size_t i = 1; i + 1 < found.size(); ++i) {
    if (!is_shake(i)) kept.push_back(found[i]);
  }
  return kept;
}

bool IronPlaces::is_corner_at(int joint) const {
  if (stroke_.joint(joint) != JointKind::kCorner) return false;
  return turns_at(joint, kCornerArmMm) && turns_at(joint, kLongArmMm) && !is_spike(joint);
}

bool IronPlaces::is_spike(int joint) const {
  const double at = map_.start_of(joint), arm = 0.5 * kShakeLengthMm;
  if (!closed() && std::min(at, map_.length_mm() - at) < 2.0 * arm) return false;
  if (map_.length_mm() < 4.0 * arm) return false;
  const auto point_at = [&](double s) { return stroke_.position(map_.u_at(at + s)); };
  const Point from = point_at(-arm), to = point_at(arm);
  const Vec before = from - point_at(-2.0 * arm), across = to - from,
            after = point_at(2.0 * arm) - to;
  const double same = std::cos(kCornerDeg * std::numbers::pi / 180.0);
  const auto goes_on = [same](Vec a, Vec b) { return dot(a, b) > same * norm(a) * norm(b); };
  // Beside a tooth of a zigzag, the line bends.
  const bool is_straight = std::min(norm(before), norm(after)) > kStraightShare * arm;
  const double height = std::sqrt(nearest_on_line(from, to, point_at(0.0)).distance_squared);
  return is_straight && goes_on(before, across) && goes_on(across, after) &&
         goes_on(before, after) && height <= kShakeHeightMm;
}

bool IronPlaces::turns_at(int joint, double arm_mm) const {
  const double at = map_.start_of(joint), whole = map_.length_mm();
  const double arm = std::min(arm_mm, 0.25 * whole);
  // The direction of an arm goes from the mean of its near half to the mean of its far half, so
  // that a single spike has no effect.
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
  static_cast<void>(u(k));  // computes the point
  return points_[static_cast<std::size_t>(k)];
}

/// Returns the turn of the direction from place k to the next one, rad.
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

double IronPlaces::from_fixed_mm(int k, double max_mm) const noexcept {
  const double at = length_at(k);
  for (int i = 0;; ++i) {
    double nearest = max_mm;
    for (const int side : {-1, 1}) {
      const int place = closed() ? wrapped(k + side * i) : std::clamp(k + side * i, 0, count());
      const double way = std::fabs(map_.way(at, length_at(place)));
      if (is_fixed(place)) return std::min(way, max_mm);
      nearest = std::min(nearest, way);
    }
    if (nearest >= max_mm || i > count()) return max_mm;
  }
}

double IronPlaces::mean_curvature(int k, double window_mm) const {
  const int half = std::max(2, static_cast<int>(0.5 * window_mm / kSpacingMm));
  double sum = 0.0, length = 0.0;
  // Goes outwards on both sides, at most to the next fixed place, because a corner is not part of a
  // bend.
  for (const int side : {-1, 1}) {
    for (int i = 0; i < half; ++i) {
      const int from = k + side * i - (side < 0 ? 1 : 0);
      if (!closed() && (from < 0 || from >= count())) break;
      const int at = wrapped(from);
      if (is_fixed(side < 0 ? wrapped(from + 1) : at) && i > 0) break;
      sum += turn(at);
      length += kSpacingMm;
    }
  }
  return length > 0.0 ? std::fabs(sum) / length : 0.0;
}

}  // namespace felt
