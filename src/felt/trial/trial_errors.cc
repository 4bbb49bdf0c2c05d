#include <algorithm>
#include <cmath>
#include <numbers>

#include "felt/geometry/polyline.h"
#include "felt/trial/trial_parts.h"

namespace felt {
namespace {

constexpr double kStepSlack = 1e-9;  // so that 20 mm have 40 steps of 0.5 mm despite rounding

std::size_t steps_of(double length_mm, double step_mm, int max_steps) {
  const double steps = std::ceil(length_mm / step_mm - kStepSlack);
  return static_cast<std::size_t>(std::clamp(steps, 1.0, static_cast<double>(max_steps)));
}

// Points at equal distances. A closed line repeats its first point at the end, which counts once.
std::vector<Point> points_on_path(const TrialPath& path) {
  if (!(path.length_mm() > 0.0)) return {path.line().front()};
  std::vector<Point> points(steps_of(path.length_mm(), kPathStepMm, kMaxPathSteps) + 1);
  resample(path.line(), points);
  if (path.closed()) points.pop_back();
  return points;
}

LineTree tree_of_ink(const TrialInk& ink) {
  std::vector<LineTree::Line> lines;
  for (const TrialTouch touch : ink.touches) {
    const std::span samples = std::span(ink.samples).subspan(touch.begin, touch.end - touch.begin);
    for (std::size_t i = 1; i < samples.size(); ++i)
      lines.push_back({samples[i - 1].position, samples[i].position});
    if (samples.size() == 1) lines.push_back({samples[0].position, samples[0].position});
  }
  return LineTree(std::move(lines));
}

// The distances in one direction. Requires at least one.
struct OneWay {
  double mean = 0.0, mean_square = 0.0, p95 = 0.0, max = 0.0;
};

OneWay summary_of(std::vector<double> distances) {
  OneWay out;
  const auto count = static_cast<double>(distances.size());
  for (const double d : distances) {
    out.mean += d / count;
    out.mean_square += d * d / count;
  }
  std::sort(distances.begin(), distances.end());
  const double rank = 0.95 * (count - 1.0);
  const auto low = static_cast<std::size_t>(rank);
  const std::size_t high = std::min(low + 1, distances.size() - 1);
  out.p95 = std::lerp(distances[low], distances[high], rank - static_cast<double>(low));
  out.max = distances.back();
  return out;
}

// Beyond the ends of an open path, only the distance from its axis counts, not the overshoot.
double signed_error_mm(const TrialPath& path, const PolylineNearest& at, Point p) {
  const double side = cross(path.tangent(at), p - at.point);
  return path.is_end(at) ? side : std::copysign(std::sqrt(at.distance_squared), side);
}

// The heights of the samples in contact above their median, or nothing if a height is unknown.
std::vector<double> heights_of(const TrialInk& ink) {
  std::vector<double> heights;
  for (const TrialTouch touch : ink.touches) {
    for (std::size_t i = touch.begin; i < touch.end; ++i) {
      if (!ink.samples[i].height_mm) return {};
      heights.push_back(*ink.samples[i].height_mm);
    }
  }
  std::vector<double> sorted = heights;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  for (double& height : heights) height -= *middle;
  return heights;
}

TrialMetrics::Value total_error_mm(const std::vector<double>& to_path,
                                   const std::vector<double>& heights) {
  if (heights.empty()) return std::nullopt;
  double sum = 0.0;
  for (std::size_t i = 0; i < heights.size(); ++i) sum += std::hypot(to_path[i], heights[i]);
  return sum / static_cast<double>(heights.size());
}

double area_of(const TrialInk& ink, const std::vector<double>& errors) {
  double area_mm2 = 0.0;
  std::size_t k = 0;  // of the first sample of the touch, in `errors`
  for (const TrialTouch touch : ink.touches) {
    for (std::size_t i = touch.begin + 1; i < touch.end; ++i) {
      const double length = distance(ink.samples[i - 1].position, ink.samples[i].position);
      const std::size_t at = k + i - touch.begin;
      area_mm2 += 0.5 * (errors[at - 1] + errors[at]) * length;
    }
    k += touch.end - touch.begin;
  }
  return area_mm2;
}

TrialMetrics::Value direction_error_deg(const TrialInk& ink, const TrialPath& path) {
  if (!(path.length_mm() > 0.0)) return std::nullopt;
  double sum = 0.0, weights = 0.0;
  for (const TrialTouch touch : ink.touches) {
    std::vector<Point> line;
    for (std::size_t i = touch.begin; i < touch.end; ++i) line.push_back(ink.samples[i].position);
    const double length = polyline_length(line);
    if (!(length > 0.0)) continue;
    std::vector<Point> chords(steps_of(length, kDirectionStepMm, kMaxPathSteps) + 1);
    resample(line, chords);
    for (std::size_t i = 1; i < chords.size(); ++i) {
      const Vec chord = chords[i] - chords[i - 1];
      const Vec tangent = path.tangent(path.nearest(lerp(chords[i - 1], chords[i], 0.5)));
      const double angle =
          std::atan2(std::abs(cross(tangent, chord)), std::abs(dot(tangent, chord)));
      sum += norm(chord) * angle;
      weights += norm(chord);
    }
  }
  if (!(weights > 0.0)) return std::nullopt;
  return sum / weights * 180.0 / std::numbers::pi;
}

}  // namespace

void measure_errors(const TrialInk& ink, const TrialPath& path, const TrialGeometry& geometry,
                    TrialMetrics& metrics) {
  std::vector<double> to_path;
  double side_sum = 0.0;
  std::size_t outside = 0;
  const double half_mm = 0.5 * geometry.tunnel_width_mm.value_or(0.0);
  for (const Point p : ink.points) {
    const PolylineNearest at = path.nearest(p);
    to_path.push_back(std::sqrt(at.distance_squared));
    side_sum += signed_error_mm(path, at, p);
    if (to_path.back() > half_mm + kStepSlack) ++outside;
  }
  const LineTree tree = tree_of_ink(ink);
  std::vector<double> to_ink;
  std::size_t covered = 0;
  for (const Point p : points_on_path(path)) {
    to_ink.push_back(std::sqrt(tree.nearest(p).distance_squared));
    if (to_ink.back() <= kCoverageMm + kStepSlack) ++covered;
  }
  const auto count = static_cast<double>(to_path.size());
  if (path.length_mm() > 0.0) metrics.err_signed_mm = side_sum / count;
  if (geometry.tunnel_width_mm) metrics.out_of_tunnel_share = static_cast<double>(outside) / count;
  metrics.coverage = static_cast<double>(covered) / static_cast<double>(to_ink.size());
  metrics.area_mm2 = area_of(ink, to_path);
  metrics.err_total_mm = total_error_mm(to_path, heights_of(ink));
  metrics.direction_err_deg = direction_error_deg(ink, path);
  const OneWay a = summary_of(std::move(to_path)), b = summary_of(std::move(to_ink));
  metrics.err_mean_mm = 0.5 * (a.mean + b.mean);
  metrics.err_rms_mm = std::sqrt(0.5 * (a.mean_square + b.mean_square));
  metrics.err_p95_mm = std::max(a.p95, b.p95);
  metrics.err_max_mm = std::max(a.max, b.max);
}

}  // namespace felt
