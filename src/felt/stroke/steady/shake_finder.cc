#include "felt/stroke/steady/shake_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include "felt/base/constants.h"
#include "felt/stroke/fit/sample_faults.h"

namespace felt {
namespace {

constexpr double kRateHz = 128.0;
constexpr double kWindowS = 2.0;
constexpr double kMaxGapS = 0.1;
constexpr std::size_t kWindow = 256, kHop = 128;
/// Bins of the spectrum are 0.5 Hz apart; the last one is 2 Hz above the highest frequency.
constexpr double kBinHz = kRateHz / kWindow;
constexpr std::size_t kBins = 29;
/// A peak counts if its acceleration is this much stronger than the median of all bins from 2 to 14
/// Hz. In 400 human strokes without shaking, the ratio stays below 4 in 95 %; a shaking of 0.5 mm
/// gives 20 and more.
constexpr double kMinProminence = 5.0;

/// The spectra of x and y of one window.
struct WindowSpectrum {
  std::array<std::complex<double>, kBins> x{}, y{};
};

/// A line with times in s from its first sample.
struct TimedLine {
  std::vector<Point> points;
  std::vector<double> times_s;
};

std::vector<TimedLine> lines_of(std::span<const InkSample> samples) {
  std::vector<TimedLine> lines;
  double start = 0.0;
  for (const InkSample& sample : samples) {
    if (!sample.time_ns || !is_in_range(sample.position)) continue;
    const double s = 1e-9 * static_cast<double>(*sample.time_ns);
    const double dt = lines.empty() ? 0.0 : s - start - lines.back().times_s.back();
    if (lines.empty() || !(dt > 0.0 && dt <= kMaxGapS)) {
      if (!lines.empty() && dt == 0.0) continue;  // a sample that repeats a time
      lines.emplace_back();
      start = s;
    }
    lines.back().points.push_back(sample.position);
    lines.back().times_s.push_back(s - start);
  }
  std::erase_if(lines, [](const TimedLine& l) { return l.times_s.back() < kWindowS; });
  return lines;
}

/// Returns the line at kRateHz, interpolated.
std::vector<Vec> resampled_line(const TimedLine& line) {
  std::vector<Vec> result;
  std::size_t i = 0;
  for (std::size_t k = 0;; ++k) {
    const double t = static_cast<double>(k) / kRateHz;
    while (i + 1 < line.times_s.size() && line.times_s[i + 1] < t) ++i;
    if (i + 1 == line.times_s.size()) return result;
    const double u = (t - line.times_s[i]) / (line.times_s[i + 1] - line.times_s[i]);
    result.push_back(lerp(line.points[i], line.points[i + 1], u) - line.points[0]);
  }
}

/// Removes the least-squares parabola, the slow part of the motion, from the values of a window.
void remove_parabola(std::array<Vec, kWindow>& window) {
  // Legendre polynomials of degree 0, 1, 2 on the samples; the third is made orthogonal to the
  // first, so each one is fitted by itself.
  constexpr double kMiddle = 0.5 * (kWindow - 1);
  double mean_square = 0.0;
  for (std::size_t i = 0; i < kWindow; ++i) {
    const double x = (static_cast<double>(i) - kMiddle) / kMiddle;
    mean_square += x * x / kWindow;
  }
  for (int degree = 0; degree < 3; ++degree) {
    const auto value = [&](std::size_t i) {
      const double x = (static_cast<double>(i) - kMiddle) / kMiddle;
      return degree == 0 ? 1.0 : degree == 1 ? x : x * x - mean_square;
    };
    Vec sum;
    double squares = 0.0;
    for (std::size_t i = 0; i < kWindow; ++i) {
      sum += value(i) * window[i];
      squares += value(i) * value(i);
    }
    for (std::size_t i = 0; i < kWindow; ++i) window[i] += (-value(i) / squares) * sum;
  }
}

WindowSpectrum spectrum_of(std::span<const Vec> line) {
  std::array<Vec, kWindow> window;
  std::copy_n(line.begin(), kWindow, window.begin());
  remove_parabola(window);
  WindowSpectrum spectrum;
  for (std::size_t i = 0; i < kWindow; ++i) {
    const double x = static_cast<double>(i) / kWindow;
    const double hann = 0.5 - 0.5 * std::cos(kTau * x);
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      const auto turn = std::polar(hann, -kTau * static_cast<double>(bin) * x);
      spectrum.x[bin] += window[i].x * turn;
      spectrum.y[bin] += window[i].y * turn;
    }
  }
  return spectrum;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns the acceleration of each bin: the median of the windows.
std::array<double, kBins> acceleration_of(const std::vector<WindowSpectrum>& windows) {
  std::array<double, kBins> power{};
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    std::vector<double> values;
    for (const WindowSpectrum& w : windows) {
      values.push_back(std::norm(w.x[bin]) + std::norm(w.y[bin]));
    }
    const double w = kTau * kBinHz * static_cast<double>(bin);
    power[bin] = median_of(std::move(values)) * w * w * w * w;
  }
  return power;
}

/// Returns the frequency of the highest peak, or nullopt if none stands out.
std::optional<double> peak_of(const std::array<double, kBins>& power) {
  constexpr auto kFirst = static_cast<std::size_t>(Shake::kMinHz / kBinHz);
  constexpr auto kLast = static_cast<std::size_t>(Shake::kMaxHz / kBinHz);
  std::size_t best = 0;
  for (std::size_t bin = kFirst; bin <= kLast; ++bin) {
    if (power[bin] < power[bin - 1] || power[bin] < power[bin + 1]) continue;
    if (best == 0 || power[bin] > power[best]) best = bin;
  }
  constexpr std::size_t kFrom = 4;  // 2 Hz
  const double usual = median_of({power.begin() + kFrom, power.end()});
  if (best == 0 || !(power[best] > kMinProminence * usual)) return std::nullopt;
  // The mean of the bins within 1 Hz, weighted by what is above the usual level.
  double sum = 0.0, weights = 0.0;
  for (std::size_t bin = best - 2; bin <= best + 2; ++bin) {
    const double weight = std::max(power[bin] - usual, 0.0);
    sum += weight * kBinHz * static_cast<double>(bin);
    weights += weight;
  }
  return std::clamp(sum / weights, Shake::kMinHz, Shake::kMaxHz);
}

/// Returns the amplitude and the axis of the motion within 1 Hz of a frequency.
Shake shake_at(double hz, const std::vector<WindowSpectrum>& windows) {
  const auto middle = static_cast<std::size_t>(std::lround(hz / kBinHz));
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (const WindowSpectrum& w : windows) {
    for (std::size_t bin = middle - 2; bin <= middle + 2; ++bin) {
      xx += std::norm(w.x[bin]);
      yy += std::norm(w.y[bin]);
      xy += (w.x[bin] * std::conj(w.y[bin])).real();
    }
  }
  // The larger eigenvalue of the covariance is the power along the axis. A sinusoid of amplitude A
  // has the power (A/2)^2 times the energy of the Hann window in all its bins, 3/8 kWindow^2.
  const double half = 0.5 * (xx - yy);
  const double largest = 0.5 * (xx + yy) + std::hypot(half, xy);
  const double size = static_cast<double>(kWindow);
  const double energy = 0.375 * size * size * static_cast<double>(windows.size());
  double axis = 0.5 * std::atan2(2.0 * xy, xx - yy) * 180.0 / std::numbers::pi;
  if (axis < 0.0) axis += Shake::kMaxAxisDeg;
  return {hz, 2.0 * std::sqrt(largest / energy), axis};
}

Error no_shaking() {
  return {ErrorCode::kInvalidData,
          "no shaking was found, so there is nothing to remove; draw the spiral slowly, without "
          "resting the hand"};
}

}  // namespace

double spiral_s(std::span<const InkSample> samples) {
  double duration_s = 0.0;
  for (const TimedLine& line : lines_of(samples)) duration_s += line.times_s.back();
  return duration_s;
}

Result<Shake> find_shake(std::span<const InkSample> samples) {
  const auto without_times =
      std::count_if(samples.begin(), samples.end(), [](const InkSample& s) { return !s.time_ns; });
  if (!samples.empty() && 2 * static_cast<std::size_t>(without_times) > samples.size()) {
    return fail(ErrorCode::kInvalidData,
                "the samples have no times, so no frequency can be measured");
  }
  SampleCheck check;
  for (const InkSample& sample : samples) check.add(sample);
  if (check.faults().has_no_clock) {
    return fail(
        ErrorCode::kInvalidData,
        "the times are not milliseconds: they stand still, run backwards or hardly advance, "
        "so no frequency can be measured");
  }
  const std::vector<TimedLine> lines = lines_of(samples);
  double duration_s = 0.0, count = 0.0;
  std::vector<WindowSpectrum> windows;
  for (const TimedLine& line : lines) {
    duration_s += line.times_s.back();
    count += static_cast<double>(line.points.size());
    const std::vector<Vec> even = resampled_line(line);
    for (std::size_t i = 0; i + kWindow <= even.size(); i += kHop) {
      windows.push_back(spectrum_of(std::span(even).subspan(i, kWindow)));
    }
  }
  if (duration_s < kMinSpiralS || windows.empty()) {
    return fail(ErrorCode::kInvalidData,
                "too short: draw for about 10 seconds without lifting the pen");
  }
  if (count < kMinSpiralHz * duration_s) {
    return fail(ErrorCode::kInvalidData,
                "too few samples: the pen must report at least 30 positions a second");
  }
  const std::optional<double> hz = peak_of(acceleration_of(windows));
  if (!hz) return tl::unexpected(no_shaking());
  Shake shake = shake_at(*hz, windows);
  if (shake.amplitude_mm < Shake::kMinAmplitudeMm) return tl::unexpected(no_shaking());
  shake.amplitude_mm = std::min(shake.amplitude_mm, Shake::kMaxAmplitudeMm);
  return shake;
}

}  // namespace felt
