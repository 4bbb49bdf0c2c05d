#include "spectrogram.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace felt::bench {
namespace {

constexpr double kPi = 3.14159265358979324;
constexpr double kRateHz = 48000.0, kLowestHz = 60.0, kHighestHz = 20000.0;
constexpr std::size_t kWindow = 1024;
constexpr double kTopDb = -25.0, kRangeDb = 65.0, kStepDb = 5.0;

/// Computes the Fourier transform in place (radix 2).
void transform(std::vector<std::complex<double>>& a) {
  const std::size_t n = a.size();
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    std::size_t bit = n >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(a[i], a[j]);
  }
  for (std::size_t size = 2; size <= n; size <<= 1) {
    const std::complex<double> turn = std::polar(1.0, -2.0 * kPi / static_cast<double>(size));
    for (std::size_t from = 0; from < n; from += size) {
      std::complex<double> w = 1.0;
      for (std::size_t k = from; k < from + size / 2; ++k, w *= turn) {
        const std::complex<double> b = w * a[k + size / 2];
        a[k + size / 2] = a[k] - b;
        a[k] += b;
      }
    }
  }
}

/// Returns the levels of all frequencies around the sample `middle`, in dB of a full-scale sine.
std::vector<double> levels_at(const std::vector<float>& sound, double middle) {
  std::vector<std::complex<double>> block(kWindow);
  const auto first = static_cast<std::ptrdiff_t>(middle) - std::ptrdiff_t{kWindow / 2};
  for (std::size_t i = 0; i < kWindow; ++i) {
    const std::ptrdiff_t at = first + static_cast<std::ptrdiff_t>(i);
    if (at < 0 || at >= static_cast<std::ptrdiff_t>(sound.size())) continue;
    const double window = 0.5 - 0.5 * std::cos(2.0 * kPi * static_cast<double>(i) / kWindow);
    block[i] = window * static_cast<double>(sound[static_cast<std::size_t>(at)]);
  }
  transform(block);
  std::vector<double> levels(kWindow / 2);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels[i] = 20.0 * std::log10(std::abs(block[i]) * 4.0 / kWindow + 1e-9);
  }
  return levels;
}

/// Returns the colour of a level, from black through violet and orange to nearly white.
Rgba color_of(double level_db) {
  constexpr double kStops[5][3] = {
      {6, 6, 16}, {70, 20, 110}, {190, 50, 90}, {248, 150, 50}, {252, 250, 200}};
  // Rounds to steps that are not visible, because they halve the size of the .png file.
  const double level = kStepDb * std::round(level_db / kStepDb);
  const double at = 4.0 * std::clamp((level - kTopDb + kRangeDb) / kRangeDb, 0.0, 1.0);
  const auto i = static_cast<std::size_t>(std::min(at, 3.999));
  const double part = at - static_cast<double>(i);
  const auto mixed = [&](std::size_t c) {
    return static_cast<std::uint8_t>(
        std::lround(kStops[i][c] + part * (kStops[i + 1][c] - kStops[i][c])));
  };
  return {mixed(0), mixed(1), mixed(2), 255};
}

}  // namespace

double spectrogram_y(double hz, PixelRect where) noexcept {
  const double part = std::log(hz / kLowestHz) / std::log(kHighestHz / kLowestHz);
  return where.y1 - part * where.height();
}

void draw_spectrogram(const std::vector<float>& sound, Pixels into, PixelRect where) {
  for (int x = where.x0; x < where.x1; ++x) {
    const double part = (x - where.x0 + 0.5) / where.width();
    const auto levels = levels_at(sound, part * static_cast<double>(sound.size()));
    for (int y = where.y0; y < where.y1; ++y) {
      const double up = (where.y1 - y - 0.5) / where.height();
      const double hz = kLowestHz * std::pow(kHighestHz / kLowestHz, up);
      const double bin = hz / kRateHz * kWindow;
      const auto i = std::min(static_cast<std::size_t>(bin), levels.size() - 2);
      const double f = bin - static_cast<double>(i);
      const Rgba color = color_of(levels[i] + f * (levels[i + 1] - levels[i]));
      std::uint8_t* p = into.data + y * into.stride + 4 * x;
      p[0] = color.r;
      p[1] = color.g;
      p[2] = color.b;
      p[3] = 255;
    }
  }
}

}  // namespace felt::bench
