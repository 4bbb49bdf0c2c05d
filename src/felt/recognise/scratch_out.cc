#include "felt/recognise/scratch_out.h"

#include <algorithm>
#include <cmath>

#include "felt/geometry/polyline.h"
#include "felt/recognise/even_path.h"

namespace felt {
namespace {

constexpr std::size_t kScratchPoints = 400;
/// A run that is shorter than this share of the extent along the axis is not a pass.
constexpr double kMinRun = 0.15;

/// The direction along which a path goes to and fro.
struct MainAxis {
  Vec direction{1.0, 0.0};
  double along = 0.0;  // mean of cos^2 of the angle between path and axis
};

/// The axis is the principal direction of the steps: the eigenvector of the sum of d d^T.
MainAxis main_axis(std::span<const Point> path) noexcept {
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec d = path[i] - path[i - 1];
    xx += d.x * d.x;
    xy += d.x * d.y;
    yy += d.y * d.y;
  }
  const double sum = xx + yy;
  if (!(sum > 0.0)) return {};
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
  return {{std::cos(angle), std::sin(angle)}, 0.5 + 0.5 * std::hypot(xx - yy, 2.0 * xy) / sum};
}

/// Returns the indices at which the path turns back along the axis, with both ends. A turn counts
/// if the path goes by more than `run_mm` before it and after it, so a hook at an end is part of
/// its pass.
std::vector<std::size_t> turns_of(std::span<const Point> path, Vec axis, double run_mm) {
  const auto at = [&](std::size_t i) { return dot(path[i] - path[0], axis); };
  std::vector<std::size_t> turns{0};
  std::size_t low = 0, high = 0;
  int heading = 0;  // 1: forwards, -1: backwards, 0: not known yet
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (at(i) > at(high)) high = i;
    if (at(i) < at(low)) low = i;
    if (heading >= 0 && at(high) - at(i) > run_mm) {
      if (heading > 0) turns.push_back(high);
      heading = -1;
      low = high = i;
    } else if (heading <= 0 && at(i) - at(low) > run_mm) {
      if (heading < 0) turns.push_back(low);
      heading = 1;
      low = high = i;
    }
  }
  turns.push_back(path.size() - 1);
  return turns;
}

/// The path cut into passes.
struct PassList {
  std::vector<Point> path;
  std::vector<std::size_t> turns;  // the ends of the passes, as indices of `path`
  MainAxis axis;
  double diagonal_mm = 0.0;
  double length_mm = 0.0;
  double longest_mm = 0.0;

  [[nodiscard]] std::size_t size() const noexcept { return turns.empty() ? 0 : turns.size() - 1; }
  [[nodiscard]] double chord_mm(std::size_t i) const noexcept {
    return distance(path[turns[i]], path[turns[i + 1]]);
  }
};

PassList passes_of(std::span<const Point> path) {
  PassList list;
  list.path = even_path(path, kScratchPoints);
  if (list.path.empty()) return list;
  list.diagonal_mm = diagonal_mm(list.path);
  list.length_mm = polyline_length(list.path);
  list.axis = main_axis(list.path);
  double from = 0.0, to = 0.0;
  for (const Point p : list.path) {
    const double at = dot(p - list.path[0], list.axis.direction);
    from = std::min(from, at);
    to = std::max(to, at);
  }
  if (!(to > from)) return list;
  list.turns = turns_of(list.path, list.axis.direction, kMinRun * (to - from));
  for (std::size_t i = 0; i < list.size(); ++i) {
    list.longest_mm = std::max(list.longest_mm, list.chord_mm(i));
  }
  return list;
}

ScratchFeatures features_of(const PassList& list) {
  ScratchFeatures f;
  f.passes = static_cast<int>(list.size());
  f.along = list.axis.along;
  if (list.size() < 3) return f;
  f.evenness = f.straightness = f.overlap = 1.0;
  f.path_per_diagonal = list.length_mm / std::max(list.diagonal_mm, 1e-9);
  const auto at = [&](std::size_t turn) {
    return dot(list.path[list.turns[turn]] - list.path[0], list.axis.direction);
  };
  const double step_mm = list.length_mm / static_cast<double>(list.path.size() - 1);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const double chord = list.chord_mm(i);
    const double length = step_mm * static_cast<double>(list.turns[i + 1] - list.turns[i]);
    if (i > 0 && i + 1 < list.size()) {
      f.evenness = std::min(f.evenness, chord / std::max(list.longest_mm, 1e-9));
      f.straightness = std::min(f.straightness, chord / std::max(length, 1e-9));
    }
    if (i > 0 && i + 2 < list.size()) {
      const double before = std::abs(at(i + 1) - at(i)), after = std::abs(at(i + 2) - at(i + 1));
      f.overlap = std::min(f.overlap, std::min(before, after) / std::max({before, after, 1e-9}));
    }
  }
  return f;
}

bool is_within_limits(const ScratchFeatures& f) noexcept {
  if (f.passes < ScratchOut::kMinPasses || f.along < ScratchOut::kMinAlong ||
      f.path_per_diagonal < ScratchOut::kMinPathPerDiagonal) {
    return false;
  }
  if (f.passes >= ScratchOut::kSurePasses) {
    return f.evenness >= ScratchOut::kSureEvenness &&
           f.straightness >= ScratchOut::kSureStraightness && f.overlap >= ScratchOut::kSureOverlap;
  }
  return f.evenness >= ScratchOut::kMinEvenness && f.straightness >= ScratchOut::kMinStraightness &&
         f.overlap >= ScratchOut::kMinOverlap;
}

/// Returns true if p is inside the triangle or within `margin_mm` of its sides.
bool is_in_triangle(Point a, Point b, Point c, Point p, double margin_mm) noexcept {
  const double ab = cross(b - a, p - a), bc = cross(c - b, p - b), ca = cross(a - c, p - c);
  if ((ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0)) {
    // All three are 0 on the line of a triangle without an area, also far away from it.
    if (ab != 0.0 || bc != 0.0 || ca != 0.0) return true;
  }
  const double squared = margin_mm * margin_mm;
  return nearest_on_line(a, b, p).distance_squared <= squared ||
         nearest_on_line(b, c, p).distance_squared <= squared ||
         nearest_on_line(c, a, p).distance_squared <= squared;
}

/// Returns true if the straight pass from a to b crosses a line.
bool is_crossed(std::span<const Point> line, Point a, Point b) noexcept {
  const auto side = [](Point from, Point to, Point p) { return cross(to - from, p - from); };
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Point c = line[k], d = line[k + 1];
    if (side(a, b, c) * side(a, b, d) <= 0.0 && side(c, d, a) * side(c, d, b) < 0.0) return true;
  }
  return false;
}

}  // namespace

ScratchFeatures ScratchOut::features(std::span<const Point> path) {
  return features_of(passes_of(path));
}

std::optional<ScratchOut> ScratchOut::find(std::span<const Point> path) {
  const PassList list = passes_of(path);
  if (!is_within_limits(features_of(list))) return std::nullopt;
  if (list.longest_mm < kMinPassMm || list.longest_mm > kMaxPassMm) return std::nullopt;
  ScratchOut found;
  for (const std::size_t turn : list.turns) found.turns_.push_back(list.path[turn]);
  found.bounds_ = bounds_of(list.path).inflated(kMarginMm);
  return found;
}

bool ScratchOut::contains(Point p) const noexcept {
  if (!bounds_.contains(p)) return false;
  for (std::size_t i = 0; i + 2 < turns_.size(); ++i) {
    if (is_in_triangle(turns_[i], turns_[i + 1], turns_[i + 2], p, kMarginMm)) return true;
  }
  return false;
}

double ScratchOut::covered_share(std::span<const Point> line) const {
  constexpr std::size_t kProbes = 64;
  std::vector<Point> probes(kProbes);
  if (line.empty()) return 0.0;
  resample(line, probes);
  const auto inside =
      std::count_if(probes.begin(), probes.end(), [this](Point p) { return contains(p); });
  return static_cast<double>(inside) / static_cast<double>(kProbes);
}

int ScratchOut::crossings(std::span<const Point> line) const {
  int count = 0;
  for (std::size_t i = 0; i + 1 < turns_.size(); ++i) {
    if (is_crossed(line, turns_[i], turns_[i + 1])) ++count;
  }
  return count;
}

bool ScratchOut::covers(std::span<const Point> line) const {
  const double share = covered_share(line);
  if (share >= kCoveredShare) return true;
  if (share < kCrossedShare) return false;
  const int crossed = crossings(line);
  return crossed >= kMinCrossings || (share >= kFlatCrossedShare && crossed >= kMinFlatCrossings);
}

bool ScratchOut::is_about(const Rect& covered) const noexcept {
  const double reach = std::hypot(covered.width(), covered.height());
  return reach >= kMinReach * std::hypot(bounds_.width(), bounds_.height());
}

}  // namespace felt
