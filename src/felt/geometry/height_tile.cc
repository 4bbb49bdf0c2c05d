#include "felt/geometry/height_tile.h"

#include <algorithm>
#include <utility>

namespace felt::height_tile {
namespace {

struct Complex {
  double re = 0.0, im = 0.0;
};
using Line = std::array<Complex, kSide>;

unsigned reversed(unsigned i) noexcept {
  unsigned r = 0;
  for (unsigned bit = 1; bit < kSide; bit *= 2, i /= 2) r = 2 * r + (i & 1u);
  return r;
}

/// Radix-2 Fourier transform in place, not normalised (Cooley and Tukey 1965).
void transform(Line& line, const std::array<double, kSide>& cosine, bool back) noexcept {
  for (unsigned i = 0; i < kSide; ++i) {
    if (i < reversed(i)) std::swap(line[i], line[reversed(i)]);
  }
  for (unsigned size = 2; size <= kSide; size *= 2) {
    const unsigned turn = kSide / size;
    for (unsigned from = 0; from < kSide; from += size) {
      for (unsigned i = 0; i < size / 2; ++i) {
        const double c = cosine[i * turn];
        const double sine = cosine[(i * turn + 3 * kSide / 4) % kSide];
        const double s = back ? sine : -sine;
        Complex& a = line[from + i];
        Complex& b = line[from + i + size / 2];
        const Complex turned{c * b.re - s * b.im, c * b.im + s * b.re};
        b = {a.re - turned.re, a.im - turned.im};
        a = {a.re + turned.re, a.im + turned.im};
      }
    }
  }
}

/// Transforms all rows, then all columns.
void transform(std::vector<Complex>& tile, bool back) {
  const std::array<double, kSide> cosine = cosines();
  Line line;
  for (const bool across : {false, true}) {
    const std::size_t step = across ? kSide : 1, next = across ? 1 : kSide;
    for (std::size_t i = 0; i < kSide; ++i) {
      for (std::size_t j = 0; j < kSide; ++j) line[j] = tile[i * next + j * step];
      transform(line, cosine, back);
      for (std::size_t j = 0; j < kSide; ++j) tile[i * next + j * step] = line[j];
    }
  }
}

double share_of(double waves, double smallest, double fade_from, double largest) noexcept {
  if (waves < smallest || waves >= largest) return 0.0;
  if (waves <= fade_from) return 1.0;
  const double x = (largest - waves) / (largest - fade_from);
  return x * x * (3.0 - 2.0 * x);
}

}  // namespace

std::array<double, kSide> cosines() {
  double c = 0.0;  // cosine and sine of a quarter turn
  double s = 1.0;
  for (int n = 4; n < kSide; n *= 2) {
    const double half = std::sqrt(0.5 * (1.0 + c));
    s = s / (2.0 * half);
    c = half;
  }
  std::array<double, kSide> table{};
  double x = 1.0;
  double y = 0.0;
  for (double& value : table) {
    value = x;
    const double turned = c * x - s * y;
    y = s * x + c * y;
    x = turned;
  }
  return table;
}

void keep_band(Tile& tile, double smallest, double fade_from, double largest) {
  std::vector<Complex> waves(tile.size());
  std::transform(tile.begin(), tile.end(), waves.begin(), [](double h) { return Complex{h, 0.0}; });
  transform(waves, false);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const int kx = std::min(x, kSide - x), ky = std::min(y, kSide - y);
      const double k = std::sqrt(static_cast<double>(kx * kx + ky * ky));
      const double share = share_of(k, smallest, fade_from, largest) / (kSide * kSide);
      Complex& wave = waves[static_cast<std::size_t>(y * kSide + x)];
      wave = {share * wave.re, share * wave.im};
    }
  }
  transform(waves, true);
  std::transform(waves.begin(), waves.end(), tile.begin(), [](const Complex& h) { return h.re; });
}

}  // namespace felt::height_tile
