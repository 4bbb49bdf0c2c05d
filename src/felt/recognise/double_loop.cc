#include "felt/recognise/double_loop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "felt/geometry/polyline.h"
#include "felt/recognise/even_path.h"

namespace felt {
namespace {

constexpr std::size_t kLoopPoints = 200;
constexpr double kFullTurn = 2.0 * std::numbers::pi;

/// A path in polar coordinates about its middle. The angles continue beyond a whole turn.
struct PolarPath {
  std::vector<Point> points;
  std::vector<double> angle, radius;
  double winding = 0.0, turning = 0.0, mean_radius = 0.0;
};

PolarPath polar_path(std::span<const Point> path) {
  PolarPath polar;
  polar.points = even_path(path, kLoopPoints);
  if (polar.points.empty()) return polar;
  Vec sum;
  for (const Point p : polar.points) sum += p - polar.points[0];
  const Point middle = polar.points[0] + sum / static_cast<double>(polar.points.size());
  for (const Point p : polar.points) {
    const Vec d = p - middle;
    polar.radius.push_back(norm(d));
    polar.mean_radius += norm(d) / static_cast<double>(polar.points.size());
    const double raw = std::atan2(d.y, d.x);
    const double step =
        polar.angle.empty() ? 0.0 : std::remainder(raw - polar.angle.back(), kFullTurn);
    polar.angle.push_back(polar.angle.empty() ? raw : polar.angle.back() + step);
    polar.turning += std::abs(step);
  }
  polar.winding = polar.angle.back() - polar.angle.front();
  return polar;
}

/// Returns the mean distance between the first and the second turn, on rays from the middle. The
/// angle of a steady loop hardly ever runs backwards, so a ray meets each turn about once.
double mean_apart(const PolarPath& polar) {
  constexpr std::size_t kRays = 48;
  struct Ray {
    double sum[2] = {0.0, 0.0};
    int count[2] = {0, 0};
  };
  std::array<Ray, kRays> rays{};
  const double sign = polar.winding < 0.0 ? -1.0 : 1.0;
  for (std::size_t i = 0; i < polar.angle.size(); ++i) {
    const double turned = std::max(0.0, sign * (polar.angle[i] - polar.angle.front()) / kFullTurn);
    const std::size_t turn = turned < 1.0 ? 0 : 1;
    if (turned >= 2.0) continue;
    const double share = turned - std::floor(turned);
    Ray& ray = rays[std::min(kRays - 1, static_cast<std::size_t>(share * kRays))];
    ray.sum[turn] += polar.radius[i];
    ++ray.count[turn];
  }
  double apart = 0.0;
  int rays_met = 0;
  for (const Ray& ray : rays) {
    if (ray.count[0] == 0 || ray.count[1] == 0) continue;
    apart += std::abs(ray.sum[0] / ray.count[0] - ray.sum[1] / ray.count[1]);
    ++rays_met;
  }
  return rays_met > 0 ? apart / rays_met : polar.mean_radius;
}

LoopFeatures loop_features(const PolarPath& polar) {
  LoopFeatures f;
  if (polar.points.empty() || !(polar.mean_radius > 0.0) || !(polar.turning > 0.0)) return f;
  f.turns = std::abs(polar.winding) / kFullTurn;
  f.steadiness = std::abs(polar.winding) / polar.turning;
  f.gap = distance(polar.points.front(), polar.points.back()) / polar.mean_radius;
  f.flatness = *std::min_element(polar.radius.begin(), polar.radius.end()) / polar.mean_radius;
  f.radius_mm = polar.mean_radius;
  f.apart = mean_apart(polar) / polar.mean_radius;
  return f;
}

}  // namespace

LoopFeatures DoubleLoop::features(std::span<const Point> path) {
  return loop_features(polar_path(path));
}

std::optional<DoubleLoop> DoubleLoop::find(std::span<const Point> path) {
  const PolarPath polar = polar_path(path);
  const LoopFeatures f = loop_features(polar);
  const bool fits = f.turns >= kMinTurns && f.turns <= kMaxTurns &&
                    f.steadiness >= kMinSteadiness && f.apart <= kMaxApart && f.gap <= kMaxGap &&
                    f.flatness >= kMinFlatness && f.radius_mm >= kMinRadiusMm;
  if (!fits) return std::nullopt;
  DoubleLoop loop;
  loop.outline_ = polar.points;
  loop.bounds_ = bounds_of(polar.points);
  return loop;
}

bool DoubleLoop::encloses(std::span<const Point> line) const {
  constexpr std::size_t kProbes = 32;
  if (line.empty()) return false;
  std::array<Point, kProbes> probes;
  resample(line, probes);
  const auto inside = std::count_if(probes.begin(), probes.end(), [this](Point p) {
    return bounds_.contains(p) && contains(outline_, p, FillRule::kNonZero);
  });
  return static_cast<double>(inside) >= kEnclosedShare * static_cast<double>(kProbes);
}

bool DoubleLoop::is_about(const Rect& enclosed) const noexcept {
  return std::hypot(enclosed.width(), enclosed.height()) >=
         kMinReach * std::hypot(bounds_.width(), bounds_.height());
}

}  // namespace felt
