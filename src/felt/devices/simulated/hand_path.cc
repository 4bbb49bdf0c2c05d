#include "felt/devices/simulated/hand_path.h"

#include <algorithm>
#include <cmath>

#include "felt/base/constants.h"

namespace felt {
namespace {

constexpr double kStepMm = 0.05;
constexpr double kSpeedAtUnitCurvature = 40.0;  // mm/s in a circle of 1 mm
constexpr double kFloorCurvature = 0.01;    // 1/mm; straight lines are drawn like circles of 100 mm
constexpr double kEndSpeed = 12.0;          // mm/s when the pen touches and leaves the surface
constexpr double kSlowest = 4.0;            // mm/s, in corners
constexpr double kAcceleration = 2000.0;    // mm/s^2
constexpr std::size_t kCurvatureReach = 6;  // steps to each side over which curvature is measured

// Evaluates the Catmull-Rom spline from b (t = 0) to c (t = 1) by Barry and Goldman's pyramid. The
// knots are spaced by the square roots of the chords.
Point catmull_rom(Point a, Point b, Point c, Point d, double t) {
  const auto gap = [](Point p, Point q) { return std::max(std::sqrt(distance(p, q)), 1e-6); };
  const double t1 = gap(a, b), t2 = t1 + gap(b, c), t3 = t2 + gap(c, d);
  const double x = t1 + t * (t2 - t1);
  const auto blend = [x](Point p, Point q, double from, double to) {
    return lerp(p, q, (x - from) / (to - from));
  };
  const Point a1 = blend(a, b, 0.0, t1), a2 = blend(b, c, t1, t2), a3 = blend(c, d, t2, t3);
  return blend(blend(a1, a2, 0.0, t2), blend(a2, a3, t1, t3), t1, t2);
}

// Returns the point before a, b, c on their circle, by mirroring b and c. If the turn is sharp,
// returns a point on the straight continuation.
Point before(Point a, Point b, Point c) {
  const Vec along = normalized(b - a);
  if (dot(c - b, along) <= 0.0) return a - (b - a);
  return c - 2.0 * dot(c - lerp(a, b, 0.5), along) * along;
}

// Appends the smooth curve through all points of `via`, but without the last point of the curve.
void append_run(std::span<const Point> via, std::vector<Point>& path) {
  for (std::size_t i = 0; i + 1 < via.size(); ++i) {
    const Point b = via[i], c = via[i + 1];
    const Point a = i > 0 ? via[i - 1] : before(b, c, i + 2 < via.size() ? via[i + 2] : c);
    const Point d = i + 2 < via.size() ? via[i + 2] : before(c, b, a);
    const int steps = std::max(1, static_cast<int>(distance(b, c) / kStepMm));
    for (int k = 0; k < steps; ++k) path.push_back(catmull_rom(a, b, c, d, k / double(steps)));
  }
}

double curvature(std::span<const Point> path, std::size_t i) {
  const std::size_t reach = std::min({kCurvatureReach, i, path.size() - 1 - i});
  if (reach == 0) return 0.0;
  const Vec in = path[i] - path[i - reach], out = path[i + reach] - path[i];
  return 2.0 * angle_between(in, out) / std::max(norm(in) + norm(out), kStepMm);
}

}  // namespace

std::vector<Point> smooth_path(std::span<const Point> via) {
  std::vector<Point> path;
  std::size_t from = 0;
  for (std::size_t i = 1; i <= via.size(); ++i) {
    if (i < via.size() && via[i] != via[i - 1]) continue;
    append_run(via.subspan(from, i - from), path);
    from = i;
  }
  if (!via.empty()) path.push_back(via.back());
  return path;
}

std::vector<TimedPoint> pace(std::span<const Point> path, double tempo) {
  const std::size_t n = path.size();
  std::vector<double> speed(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double by_curve = kSpeedAtUnitCurvature / std::cbrt(curvature(path, i) + kFloorCurvature);
    // A corner turns within one step. Its curvature, measured over kCurvatureReach steps, would be
    // too small, and the hand would pass the corner too fast.
    const bool corner =
        i > 0 && i + 1 < n && angle_between(path[i] - path[i - 1], path[i + 1] - path[i]) > 0.6;
    const bool end = i == 0 || i + 1 == n;
    speed[i] = corner ? kSlowest : end ? kEndSpeed : std::max(tempo * by_curve, kSlowest);
  }
  const auto reachable = [&](std::size_t from, std::size_t to) {
    const double gain = 2.0 * kAcceleration * tempo * distance(path[from], path[to]);
    return std::sqrt(speed[from] * speed[from] + gain);
  };
  for (std::size_t i = 1; i < n; ++i) speed[i] = std::min(speed[i], reachable(i - 1, i));
  for (std::size_t i = n; i-- > 1;) speed[i - 1] = std::min(speed[i - 1], reachable(i, i - 1));

  std::vector<TimedPoint> timed;
  for (std::size_t i = 0; i < n; ++i) {
    double t_s = 0.0;
    if (i > 0) {
      t_s = timed.back().t_s + 2.0 * distance(path[i - 1], path[i]) / (speed[i - 1] + speed[i]);
    }
    timed.push_back({path[i], t_s});
  }
  return timed;
}

std::vector<Point> at_equal_times(std::span<const TimedPoint> path, double step_s,
                                  double min_duration_s) {
  std::vector<Point> points;
  std::size_t k = 0;
  const double duration_s = std::max(path.back().t_s, min_duration_s);
  for (double t = 0.0; t <= duration_s; t += step_s) {
    while (k + 1 < path.size() && path[k + 1].t_s < t) ++k;
    if (k + 1 == path.size()) {
      points.push_back(path.back().position);
      continue;
    }
    const double span = path[k + 1].t_s - path[k].t_s;
    points.push_back(lerp(path[k].position, path[k + 1].position,
                          span > 0.0 ? std::min((t - path[k].t_s) / span, 1.0) : 1.0));
  }
  return points;
}

std::vector<Point> through_muscles(std::span<const Point> path, int reach) {
  const auto last = static_cast<std::ptrdiff_t>(path.size()) - 1;
  std::vector<Point> moved;
  for (std::ptrdiff_t i = 0; i <= last; ++i) {
    const Point center = path[static_cast<std::size_t>(i)];
    Vec sum;
    double weights = 0.0;
    for (int k = -reach; k <= reach; ++k) {
      const double w = 1.0 + std::cos(kTau * k / (2.0 * reach + 2.0));
      const auto j = std::clamp<std::ptrdiff_t>(i + k, 0, last);
      sum += w * (path[static_cast<std::size_t>(j)] - center);
      weights += w;
    }
    moved.push_back(center + sum / weights);
  }
  return moved;
}

}  // namespace felt
