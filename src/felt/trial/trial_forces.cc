#include <cmath>

#include "felt/trial/trial_parts.h"

namespace felt {
namespace {

constexpr double kStrongForceN = 0.5;

}  // namespace

// All integrals use the trapezoidal rule, over the steps with a known force at both ends.
void measure_forces(const TrialInk& ink, TrialMetrics& metrics) {
  const std::span<const TrialSample> movement = ink.movement();
  double time_s = 0.0, impulse = 0.0, work = 0.0, strong_s = 0.0;
  for (std::size_t i = 1; i < movement.size(); ++i) {
    const TrialSample &a = movement[i - 1], &b = movement[i];
    if (!a.force_n || !b.force_n) continue;
    const double dt = seconds_between(a, b);
    const double from = norm(*a.force_n), to = norm(*b.force_n);
    time_s += dt;
    impulse += 0.5 * (from + to) * dt;
    work += dot(0.5 * (*a.force_n + *b.force_n), b.position - a.position);
    strong_s += 0.5 * dt * ((from > kStrongForceN ? 1.0 : 0.0) + (to > kStrongForceN ? 1.0 : 0.0));
  }
  if (!(time_s > 0.0)) return;
  metrics.force_mean_n = impulse / time_s;
  metrics.force_impulse_n_s = impulse;
  metrics.work_mj = work;
  metrics.force_above_half_n_share = strong_s / time_s;
}

void measure_pressure(const TrialInk& ink, TrialMetrics& metrics) {
  std::vector<double> values;
  double sum = 0.0;
  for (const TrialSample& sample : ink.samples) {
    if (!sample.contact || !sample.pressure) continue;
    values.push_back(*sample.pressure);
    sum += *sample.pressure;
  }
  if (values.empty()) return;
  const auto count = static_cast<double>(values.size());
  const double mean = sum / count;
  metrics.pressure_mean = mean;
  if (values.size() < 2 || !(mean > 0.0)) return;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  metrics.pressure_cv = std::sqrt(squares / (count - 1.0)) / mean;
}

}  // namespace felt
