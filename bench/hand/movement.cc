#include "movement.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "statistics.h"

namespace felt::bench {
namespace {

constexpr double kStepS = 0.005;
constexpr double kSmoothS = 0.02;  // standard deviation of the Gaussian window: passes up to 8 Hz
constexpr double kShortestS = 0.6;
constexpr std::size_t kEndSteps = 4;  // at both ends, where the window lacks neighbours
constexpr double kMinTurn =
    0.01;  // radians/s; less is the rounding of the numbers on a straight line
constexpr double kPeakShare = 0.02;  // of the largest speed: smaller ups and downs are no peaks

std::vector<Point> at_equal_steps(std::span<const Sample> stroke) {
  std::vector<Point> points;
  const double start = stroke.front().t_s, end = stroke.back().t_s;
  std::size_t k = 0;
  for (double t = start; t <= end; t += kStepS) {
    while (k + 1 < stroke.size() && stroke[k + 1].t_s < t) ++k;
    const std::size_t next = std::min(k + 1, stroke.size() - 1);
    const double span = stroke[next].t_s - stroke[k].t_s;
    const double part = span > 0.0 ? std::clamp((t - stroke[k].t_s) / span, 0.0, 1.0) : 0.0;
    points.push_back(lerp(stroke[k].position, stroke[next].position, part));
  }
  return points;
}

std::vector<Point> smoothed(const std::vector<Point>& points) {
  const auto reach = static_cast<std::ptrdiff_t>(3.0 * kSmoothS / kStepS);
  const auto last = static_cast<std::ptrdiff_t>(points.size()) - 1;
  std::vector<Point> out;
  for (std::ptrdiff_t i = 0; i <= last; ++i) {
    Vec sum;
    double weights = 0.0;
    for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
      const double x = static_cast<double>(k) * kStepS / kSmoothS;
      const double weight = std::exp(-0.5 * x * x);
      const auto at = std::clamp<std::ptrdiff_t>(i + k, 0, last);
      sum += weight * (points[static_cast<std::size_t>(at)] - Point{});
      weights += weight;
    }
    out.push_back(Point{} + sum / weights);
  }
  return out;
}

std::vector<Vec> derivative(const std::vector<Vec>& values) {
  std::vector<Vec> out;
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    out.push_back((values[i + 1] - values[i - 1]) / (2.0 * kStepS));
  }
  return out;
}

// Fits a line through the points by least squares; sets its slope and R squared.
void fit_line(const std::vector<Point>& points, double& slope, double& fit) {
  const double r = correlation(points);
  double mean_x = 0.0, mean_y = 0.0, var_x = 0.0, cov = 0.0;
  for (const Point p : points) {
    mean_x += p.x / double(points.size());
    mean_y += p.y / double(points.size());
  }
  for (const Point p : points) {
    var_x += (p.x - mean_x) * (p.x - mean_x);
    cov += (p.x - mean_x) * (p.y - mean_y);
  }
  slope = var_x > 0.0 ? cov / var_x : 0.0;
  fit = r * r;
}

// Counts the peaks that rise by at least `least` above the lows beside them.
int count_peaks(const std::vector<double>& speed, double least) {
  int peaks = 0;
  bool rising = true;
  double extreme = speed.front();
  for (const double v : speed) {
    if (rising) {
      extreme = std::max(extreme, v);
      if (v < extreme - least) {
        ++peaks;
        rising = false;
        extreme = v;
      }
    } else {
      extreme = std::min(extreme, v);
      if (v > extreme + least) {
        rising = true;
        extreme = v;
      }
    }
  }
  return peaks;
}

}  // namespace

std::optional<Movement> measure(std::span<const Sample> stroke) {
  if (stroke.size() < 4 || stroke.back().t_s - stroke.front().t_s < kShortestS) return std::nullopt;
  std::vector<Vec> places;
  for (const Point p : smoothed(at_equal_steps(stroke))) places.push_back(p - Point{});
  const std::vector<Vec> velocity = derivative(places);
  const std::vector<Vec> acceleration = derivative(velocity);
  const std::vector<Vec> jerk = derivative(acceleration);
  std::vector<double> speed;
  for (const Vec v : velocity) speed.push_back(norm(v));
  const double top = *std::max_element(speed.begin(), speed.end());
  if (!(top > 0.0)) return std::nullopt;

  Movement movement;
  std::vector<Point> law;
  for (std::size_t i = kEndSteps; i + kEndSteps < acceleration.size(); ++i) {
    const double v = speed[i + 1];
    if (v < 0.02 * top) continue;
    const double turn = std::abs(cross(velocity[i + 1], acceleration[i]));
    if (turn < kMinTurn * v * v) continue;
    law.push_back({std::log(turn / (v * v * v)), std::log(v)});
  }
  if (law.size() < 10) return std::nullopt;
  fit_line(law, movement.power, movement.fit);
  const double duration_s = kStepS * static_cast<double>(speed.size());
  movement.peaks_hz = count_peaks(speed, kPeakShare * top) / duration_s;
  double sum = 0.0;
  for (const Vec j : jerk) sum += norm_squared(j) * kStepS;
  movement.jerk = -std::log(sum * std::pow(duration_s, 3.0) / (top * top));
  return movement;
}

}  // namespace felt::bench
