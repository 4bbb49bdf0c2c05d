#include "tests/drawing/materials/feel_features.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace felt {
namespace {

constexpr double kForceJnd = 0.10;
constexpr double kStiffnessJnd = 0.22;
constexpr double kVibrationJnd = 0.20;
constexpr double kCoarsenessJnd = 0.25;
constexpr double kThresholdN = 0.04;  // smallest vibration that is felt, as peak force
constexpr double kShortestMm = 0.8, kLongestMm = 9.0;

double mean_of(const std::vector<Force>& forces, double Force::*axis) {
  double sum = 0.0;
  for (const Force& f : forces) sum += f.*axis;
  return forces.empty() ? 0.0 : sum / static_cast<double>(forces.size());
}

double surface_mean(const std::vector<Force>& forces) {
  return std::hypot(mean_of(forces, &Force::x), mean_of(forces, &Force::y));
}

// Returns the strength in JNDs above the threshold. The result approaches 0 below the threshold.
double strength_jnd(const Texturing& texture) {
  return std::log(std::hypot(texture.peak_n, kThresholdN) / kThresholdN) / kVibrationJnd;
}

// Returns the coarseness in JNDs. The result approaches 0, the middle of the range, below the
// threshold.
double coarseness_jnd(const Texturing& texture) {
  if (!(texture.peak_n > 0.0)) return 0.0;
  const double size = texture.peak_n / kThresholdN;
  const double share = size * size / (1.0 + size * size);
  return share * std::log(texture.wavelength_mm / std::sqrt(kShortestMm * kLongestMm)) /
         kCoarsenessJnd;
}

}  // namespace

std::string_view name_of_feature(std::size_t feature) noexcept {
  constexpr std::array<std::string_view, FeelFeatures::kCount> kNames{
      "friction", "hardness", "strength x", "coarseness x", "strength y", "coarseness y"};
  return kNames[feature];
}

Texturing texture_of(const std::vector<Force>& forces, double period_s, double speed_mm_per_s,
                     double shortest_mm, double longest_mm) {
  if (forces.size() < 16) return {};
  // Takes the component of the force along the mean pull, removes its mean and its linear drift,
  // applies a Hann window, and sums the power of the Fourier bins in the wavelength range.
  const double mx = mean_of(forces, &Force::x), my = mean_of(forces, &Force::y);
  const double size = std::hypot(mx, my);
  if (!(size > 0.0)) return {};
  const std::size_t n = forces.size();
  std::vector<double> signal(n);
  double mean = 0.0, slope = 0.0, spread = 0.0;
  const double middle = 0.5 * static_cast<double>(n - 1);
  for (std::size_t i = 0; i < n; ++i) {
    signal[i] = (forces[i].x * mx + forces[i].y * my) / size;
    const double at = static_cast<double>(i) - middle;
    mean += signal[i];
    slope += at * signal[i];
    spread += at * at;
  }
  mean /= static_cast<double>(n);
  slope /= spread;
  for (std::size_t i = 0; i < n; ++i) {
    const double at = static_cast<double>(i) - middle;
    const double window = 0.5 - 0.5 * std::cos(6.283185307179586 * (static_cast<double>(i) + 0.5) /
                                               static_cast<double>(n));
    signal[i] = window * (signal[i] - mean - slope * at);
  }
  const double bin_hz = 1.0 / (static_cast<double>(n) * period_s);
  const auto from = static_cast<int>(std::ceil(speed_mm_per_s / longest_mm / bin_hz));
  const auto to = static_cast<int>(std::floor(speed_mm_per_s / shortest_mm / bin_hz));
  double power = 0.0, weighted_hz = 0.0;
  for (int bin = std::max(from, 1); bin <= to && 2 * bin < static_cast<int>(n); ++bin) {
    // Goertzel's recurrence gives the power of one bin.
    const double turn = 6.283185307179586 * bin / static_cast<double>(n);
    const double twice = 2.0 * std::cos(turn);
    double a = 0.0, b = 0.0;
    for (const double s : signal) {
      const double next = s + twice * a - b;
      b = a;
      a = next;
    }
    const double of_bin = a * a + b * b - twice * a * b;
    power += of_bin;
    weighted_hz += of_bin * bin * bin_hz;
  }
  // A Hann window leaves 3/8 of the power; each bin stands for itself and its mirror.
  const double count = static_cast<double>(n);
  const double mean_square = 2.0 * power / (count * count) / 0.375;
  if (!(power > 0.0)) return {};
  return {std::sqrt(2.0 * mean_square), speed_mm_per_s * power / weighted_hz};
}

FeelFeatures features_of(const StrokeForces& forces, double leg_mm) {
  FeelFeatures features;
  const double push =
      0.5 * (mean_of(forces.along_x, &Force::z) + mean_of(forces.along_y, &Force::z));
  const double pull = 0.5 * (surface_mean(forces.along_x) + surface_mean(forces.along_y));
  const double dry = std::max(0.0, pull - forces.viscous_n) + forces.device_friction_n;
  features.jnd[0] = std::log(std::max(dry, 1e-3) / std::max(push, 1e-3)) / kForceJnd;
  // Hardness is the steepest growth of the normal force within 10 ms while the pen lands; the hand
  // always lands in the same way.
  double steepest = 1e-3;
  const auto over = static_cast<std::size_t>(std::llround(0.01 / forces.period_s));
  for (std::size_t i = over; i < forces.touching.size(); ++i) {
    steepest = std::max(steepest, (forces.touching[i].z - forces.touching[i - over].z) / 0.01);
  }
  features.jnd[1] = std::log(steepest / std::max(push, 1e-3)) / kStiffnessJnd;
  std::size_t next = 2;
  for (const auto* leg : {&forces.along_x, &forces.along_y}) {
    const Texturing texture =
        texture_of(*leg, forces.period_s, leg_mm / forces.leg_s, kShortestMm, kLongestMm);
    features.jnd[next++] = strength_jnd(texture);
    features.jnd[next++] = coarseness_jnd(texture);
  }
  return features;
}

FeelFeatures blurred(const FeelFeatures& features, std::uint32_t seed) {
  // A difference of one JND is noticed in 75 % of the comparisons. That is so if the error of one
  // look has a standard deviation of 1 / 0.954 JND.
  constexpr double kError = 1.0 / 0.954;
  std::mt19937 random(seed);
  const auto part = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.0; };
  FeelFeatures felt = features;
  for (double& value : felt.jnd) {
    const double radius = std::sqrt(-2.0 * std::log(part()));
    value += kError * radius * std::cos(6.283185307179586 * part());
  }
  return felt;
}

}  // namespace felt
