#include "measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "felt/geometry/nearest.h"
#include "felt/geometry/polyline.h"
#include "felt/stroke/arc_map.h"

namespace felt::bench {
namespace {

/// Distance between the points that are checked beyond the span, mm.
constexpr double kProbeMm = 0.5;
/// Distance between the points for the bending energy, mm.
constexpr double kBendMm = 0.25;
/// Number of chords per segment from which these points are computed.
constexpr int kChords = 256;
constexpr double kBreakDeg = 0.1;

Cubic segment_of(const StrokeData& data, std::size_t i) {
  const Point* p = &data.points[3 * i];
  return {{p[0], p[1], p[2], p[3]}};
}

std::size_t count_of(const StrokeData& data) {
  return data.points.size() / 3;
}

double distance_to(const StrokeData& data, Point p) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count_of(data); ++i) {
    if (const auto near = nearest_within(segment_of(data, i), p, best)) {
      best = near->distance_squared;
    }
  }
  return std::sqrt(best);
}

struct Curving {
  double bending_per_mm = 0.0, turn_deg = 0.0;
};

Curving curving_of(const StrokeData& data) {
  std::vector<Point> line{data.points.front()};
  for (std::size_t i = 0; i < count_of(data); ++i) {
    const Cubic c = segment_of(data, i);
    for (int k = 1; k <= kChords; ++k) line.push_back(evaluate(c, k / double{kChords}));
  }
  const double length = polyline_length(line);
  std::vector<Point> points(std::max<std::size_t>(
      3, static_cast<std::size_t>(std::lround(std::min(1e6, length / kBendMm))) + 1));
  resample(line, points);
  const double step = length / static_cast<double>(points.size() - 1);
  Curving sum;
  for (std::size_t k = 1; k + 1 < points.size(); ++k) {
    const double turn = angle_between(points[k] - points[k - 1], points[k + 1] - points[k]);
    sum.bending_per_mm += turn * turn / step;
    sum.turn_deg += turn * 180.0 / std::numbers::pi;
  }
  return sum;
}

int breaks_of(const StrokeData& data) {
  int breaks = 0;
  const std::size_t n = count_of(data);
  for (std::size_t j = 0; j < data.joints.size(); ++j) {
    if (data.joints[j] != JointKind::kSmooth) continue;
    const Vec in = tangent(segment_of(data, j), 1.0);
    const Vec out = tangent(segment_of(data, (j + 1) % n), 0.0);
    if (angle_between(in, out) * 180.0 / std::numbers::pi > kBreakDeg) ++breaks;
  }
  return breaks;
}

}  // namespace

Effect effect_of(const Pull& pull, const StrokeData& now, double radius_mm) {
  const Stroke& old = *pull.stroke;
  Effect effect;
  const ArcMap map(old);
  const double at = map.length_at(pull.u);
  for (double s = 0.0; s <= map.length_mm(); s += kProbeMm) {
    if (std::fabs(map.way(at, s)) <= radius_mm) continue;
    effect.outside_mm = std::max(effect.outside_mm, distance_to(now, old.position(map.u_at(s))));
  }
  effect.pen_mm = distance_to(now, old.position(pull.u) + pull.way);
  const Curving before = curving_of(old.data()), after = curving_of(now);
  effect.bending_per_mm = after.bending_per_mm - before.bending_per_mm;
  effect.turn_deg = after.turn_deg - before.turn_deg;
  effect.breaks = breaks_of(now);
  effect.segments_added = static_cast<int>(count_of(now)) - old.segment_count();
  return effect;
}

}  // namespace felt::bench
