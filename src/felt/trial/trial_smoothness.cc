#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "felt/trial/spectrum.h"
#include "felt/trial/trial_parts.h"

// The whole movement from the first to the last contact is measured, with the parts between two
// touches, because the hand does not stop there. All measures use positions every 5 ms. All but the
// power share use positions smoothed by a Gaussian, because derivatives amplify noise.
namespace felt {
namespace {

constexpr std::uint64_t kGridNs = 5'000'000;
constexpr double kGridS = 0.005;
constexpr double kGaussS = 0.02;            // standard deviation: passes up to 8 Hz
constexpr std::ptrdiff_t kGaussReach = 12;  // steps on both sides
constexpr std::size_t kLawMargin = 4;       // steps at both ends, where the window lacks neighbours
constexpr double kMinSpeedMmPerS = 1e-6;
constexpr double kLawSpeedShare = 0.02;  // of the largest speed; slower parts do not count
constexpr double kMinTurnPerS = 0.01;    // radians/s; less is rounding on a straight line
constexpr std::size_t kMinLawPoints = 10;
constexpr double kMinLawVariance = 1e-9;
constexpr double kPeakShare = 0.02;  // of the largest speed: smaller ups and downs are no peaks
constexpr double kSparcMaxHz = 10.0, kSparcThreshold = 0.05;
constexpr std::size_t kSparcPadding = 16;
constexpr double kTremorMinHz = 3.0, kTremorMaxHz = 12.0;

std::vector<Point> grid_points(std::span<const TrialSample> movement) {
  std::vector<Point> points;
  const auto start = static_cast<std::uint64_t>(movement.front().time_ns);
  const auto time = [&](std::size_t i) {
    return static_cast<std::uint64_t>(movement[i].time_ns) - start;
  };
  const std::uint64_t end =
      std::min(time(movement.size() - 1), static_cast<std::uint64_t>(kMaxSmoothnessS * 1e9));
  std::size_t k = 0;
  for (std::uint64_t t = 0; t <= end; t += kGridNs) {
    while (k + 2 < movement.size() && time(k + 1) < t) ++k;
    const double part =
        static_cast<double>(t - time(k)) / static_cast<double>(time(k + 1) - time(k));
    const Point from = movement[k].position;
    // Not lerp(), so that a still pen does not move by rounding.
    points.push_back(from + part * (movement[k + 1].position - from));
  }
  return points;
}

// At the ends, the first or last point stands for its missing neighbours.
std::vector<Vec> gauss_filtered(const std::vector<Point>& points) {
  std::vector<double> weights;
  double total = 0.0;
  for (std::ptrdiff_t k = -kGaussReach; k <= kGaussReach; ++k) {
    const double x = static_cast<double>(k) * kGridS / kGaussS;
    weights.push_back(std::exp(-0.5 * x * x));
    total += weights.back();
  }
  const auto last = static_cast<std::ptrdiff_t>(points.size()) - 1;
  std::vector<Vec> out;
  for (std::ptrdiff_t i = 0; i <= last; ++i) {
    Vec sum;
    for (std::ptrdiff_t k = -kGaussReach; k <= kGaussReach; ++k) {
      const auto at = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i + k, 0, last));
      sum += weights[static_cast<std::size_t>(k + kGaussReach)] * (points[at] - points[0]);
    }
    out.push_back(sum / total);
  }
  return out;
}

// Central differences; the result is shorter by two.
std::vector<Vec> slopes(const std::vector<Vec>& values) {
  std::vector<Vec> out;
  for (std::size_t i = 1; i + 1 < values.size(); ++i)
    out.push_back((values[i + 1] - values[i - 1]) / (2.0 * kGridS));
  return out;
}

// Counts the peaks that rise by at least `least` above the lows on both sides.
double count_speed_peaks(const std::vector<double>& speed, double least) {
  double peaks = 0.0;
  double low = speed.front(), high = speed.front();
  bool rising = true;
  for (const double v : speed) {
    low = std::min(low, v);
    high = std::max(high, v);
    if (rising && v < high - least) {
      ++peaks;
      rising = false;
      low = v;
    } else if (!rising && v > low + least) {
      rising = true;
      high = v;
    }
  }
  return peaks;
}

// Fits ln(speed) = a + exponent ln(curvature) by least squares.
void measure_power_law(const std::vector<Vec>& velocity, const std::vector<Vec>& acceleration,
                       double top, TrialMetrics& metrics) {
  std::vector<Vec> law;
  Vec mean;
  for (std::size_t i = kLawMargin; i + kLawMargin < acceleration.size(); ++i) {
    const double v = norm(velocity[i + 1]);
    const double turn = std::abs(cross(velocity[i + 1], acceleration[i]));
    if (v < kLawSpeedShare * top || turn < kMinTurnPerS * v * v) continue;
    law.push_back({std::log(turn / (v * v * v)), std::log(v)});
    mean += law.back();
  }
  if (law.size() < kMinLawPoints) return;
  const auto count = static_cast<double>(law.size());
  mean = mean / count;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const Vec p : law) {
    const Vec d = p - mean;
    xx += d.x * d.x / count;
    xy += d.x * d.y / count;
    yy += d.y * d.y / count;
  }
  if (xx < kMinLawVariance) return;
  metrics.power_law_exponent = xy / xx;
  if (yy >= kMinLawVariance) metrics.power_law_r2 = xy * xy / (xx * yy);
}

// Balasubramanian et al. 2015: the length of the normalized spectrum of speed, up to the highest
// frequency below 10 Hz that has at least 5 % of the largest amplitude.
TrialMetrics::Value sparc_of(const std::vector<double>& speed) {
  const std::size_t size = std::bit_ceil(speed.size()) * kSparcPadding;
  const auto bins = spectrum(speed, size);
  double top = 0.0;
  for (const auto& bin : bins) top = std::max(top, std::abs(bin));
  if (!(top > 0.0)) return std::nullopt;
  const double bin_hz = 1.0 / (kGridS * static_cast<double>(size));
  const auto limit = static_cast<std::size_t>(kSparcMaxHz / bin_hz + 1e-9);
  std::size_t first = size, last = 0;
  for (std::size_t k = 0; k <= limit; ++k) {
    if (std::abs(bins[k]) / top < kSparcThreshold) continue;
    first = std::min(first, k);
    last = k;
  }
  if (first >= last) return std::nullopt;
  const double step = 1.0 / static_cast<double>(last - first);
  double length = 0.0;
  for (std::size_t k = first; k < last; ++k)
    length += std::hypot(step, (std::abs(bins[k + 1]) - std::abs(bins[k])) / top);
  return -length;
}

// The share of the power of velocity without its mean, in a Hann window.
TrialMetrics::Value tremor_share(const std::vector<Point>& points) {
  std::vector<Vec> positions;
  for (const Point p : points) positions.push_back(p - points[0]);
  const std::vector<Vec> velocity = slopes(positions);
  const auto count = static_cast<double>(velocity.size());
  Vec mean;
  for (const Vec v : velocity) mean += v / count;
  std::vector<double> xs, ys;
  double squares = 0.0, total = 0.0;
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    const double phase = 2.0 * std::numbers::pi * static_cast<double>(i) / (count - 1.0);
    const Vec v = velocity[i] - mean;
    squares += norm_squared(v) / count;
    const Vec windowed = 0.5 * (1.0 - std::cos(phase)) * v;
    total += norm_squared(windowed);
    xs.push_back(windowed.x);
    ys.push_back(windowed.y);
  }
  if (!(std::sqrt(squares) > kMinSpeedMmPerS)) return std::nullopt;
  const std::size_t size = std::bit_ceil(velocity.size());
  const auto x = spectrum(xs, size), y = spectrum(ys, size);
  double band = 0.0;
  for (std::size_t k = 1; k < size / 2; ++k) {
    const double hz = static_cast<double>(k) / (kGridS * static_cast<double>(size));
    if (hz >= kTremorMinHz && hz <= kTremorMaxHz) band += std::norm(x[k]) + std::norm(y[k]);
  }
  // Each frequency is in the spectrum twice; the sum of all is `total` times the size (Parseval).
  return 2.0 * band / (total * static_cast<double>(size));
}

}  // namespace

void measure_smoothness(const TrialInk& ink, TrialMetrics& metrics) {
  const std::span<const TrialSample> movement = ink.movement();
  if (movement.size() < 4 || seconds_between(movement.front(), movement.back()) < kMinSmoothnessS)
    return;
  const std::vector<Point> points = grid_points(movement);
  const std::vector<Vec> velocity = slopes(gauss_filtered(points));
  const std::vector<Vec> acceleration = slopes(velocity);
  std::vector<double> speed;
  for (const Vec v : velocity) speed.push_back(norm(v));
  const double top = *std::max_element(speed.begin(), speed.end());
  if (!(top > kMinSpeedMmPerS)) return;

  const double duration_s = kGridS * static_cast<double>(speed.size());
  metrics.velocity_peaks_per_s = count_speed_peaks(speed, kPeakShare * top) / duration_s;
  double jerk = 0.0;
  for (const Vec j : slopes(acceleration)) jerk += norm_squared(j) * kGridS;
  if (jerk > 0.0)
    metrics.log_dimensionless_jerk = -std::log(jerk * std::pow(duration_s, 3.0) / (top * top));
  measure_power_law(velocity, acceleration, top, metrics);
  metrics.sparc = sparc_of(speed);
  metrics.power_share_3_12_hz = tremor_share(points);
}

}  // namespace felt
