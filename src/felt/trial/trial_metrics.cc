#include "felt/trial/trial_metrics.h"

#include <cmath>

#include "felt/geometry/polyline.h"
#include "felt/trial/trial_parts.h"

namespace felt {
namespace {

bool is_valid(const TrialSample& sample) {
  if (!is_in_range(sample.position)) return false;
  // A NaN fails each comparison.
  if (sample.pressure && !(std::abs(*sample.pressure) <= kMaxTrialForceN)) return false;
  if (sample.height_mm && !(std::abs(*sample.height_mm) <= kMaxCoordinateMm)) return false;
  const Vec force = sample.force_n.value_or(Vec{});
  return std::abs(force.x) <= kMaxTrialForceN && std::abs(force.y) <= kMaxTrialForceN;
}

TrialInk ink_of_samples(std::span<const TrialSample> samples) {
  TrialInk ink;
  bool touching = false;
  for (const TrialSample& sample : samples) {
    if (!is_valid(sample)) continue;
    if (!ink.samples.empty() && sample.time_ns <= ink.samples.back().time_ns) continue;
    const std::size_t index = ink.samples.size();
    ink.samples.push_back(sample);
    if (sample.contact) {
      if (!touching) ink.touches.push_back({index, index});
      ink.touches.back().end = index + 1;
      ink.points.push_back(sample.position);
    }
    touching = sample.contact;
  }
  return ink;
}

void measure_time(const TrialInk& ink, TrialMetrics& metrics) {
  const auto& samples = ink.samples;
  const std::size_t first = ink.touches.front().begin, last = ink.touches.back().end - 1;
  metrics.reaction_s = seconds_between(samples.front(), samples[first]);
  metrics.movement_s = seconds_between(samples[first], samples[last]);
  metrics.lifts = static_cast<double>(ink.touches.size() - 1);
  double in_air_s = 0.0, in_contact_s = 0.0, length_mm = 0.0;
  for (std::size_t k = 0; k < ink.touches.size(); ++k) {
    const TrialTouch touch = ink.touches[k];
    in_contact_s += seconds_between(samples[touch.begin], samples[touch.end - 1]);
    for (std::size_t i = touch.begin + 1; i < touch.end; ++i)
      length_mm += distance(samples[i - 1].position, samples[i].position);
    if (k > 0)
      in_air_s += seconds_between(samples[ink.touches[k - 1].end - 1], samples[touch.begin]);
  }
  metrics.in_air_s = in_air_s;
  metrics.ink_length_mm = length_mm;
  if (in_contact_s > 0.0) metrics.speed_mean_mm_per_s = length_mm / in_contact_s;
}

}  // namespace

std::span<const TrialSample> TrialInk::movement() const noexcept {
  const std::size_t first = touches.front().begin;
  return std::span(samples).subspan(first, touches.back().end - first);
}

double seconds_between(const TrialSample& a, const TrialSample& b) noexcept {
  // The difference fits into 64 bits without a sign, even if both times are extreme.
  const auto ns = static_cast<std::uint64_t>(b.time_ns) - static_cast<std::uint64_t>(a.time_ns);
  return 1e-9 * static_cast<double>(ns);
}

TrialMetrics measure_trial(std::span<const TrialSample> samples, std::span<const Point> path,
                           const TrialGeometry& geometry) {
  TrialGeometry task = geometry;
  for (std::optional<double>* width : {&task.tunnel_width_mm, &task.target_width_mm}) {
    if (*width && !(std::isfinite(**width) && **width > 0.0)) width->reset();
  }
  const TrialInk ink = ink_of_samples(samples);
  const TrialPath line(path, task.ends);
  TrialMetrics metrics;
  metrics.samples = static_cast<double>(ink.samples.size());
  metrics.samples_ignored = static_cast<double>(samples.size() - ink.samples.size());
  if (!line.empty()) {
    metrics.path_length_mm = line.length_mm();
    if (task.tunnel_width_mm) metrics.steering_id = line.length_mm() / *task.tunnel_width_mm;
  }
  if (ink.touches.empty()) return metrics;
  measure_time(ink, metrics);
  if (!line.empty()) {
    measure_errors(ink, line, task, metrics);
    measure_frechet(ink, line, metrics);
    if (line.straight()) measure_straight(ink, line, task, metrics);
    if (line.closed()) metrics.end_gap_mm = distance(ink.points.front(), ink.points.back());
  }
  measure_smoothness(ink, metrics);
  measure_forces(ink, metrics);
  measure_pressure(ink, metrics);
  return metrics;
}

}  // namespace felt
