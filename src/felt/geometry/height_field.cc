#include "felt/geometry/height_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace felt {
namespace {

constexpr int kSide = HeightField::kSide;
constexpr int kWaves = 96;

/// SplitMix64 (Steele, Lea, Flood 2014): a few lines, and the same numbers everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept : state_(seed) {}
  /// 0..n-1. The bias of the remainder is below 1e-16 here.
  int below(int n) noexcept {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return static_cast<int>((z ^ (z >> 31)) % static_cast<std::uint64_t>(n));
  }

 private:
  std::uint64_t state_;
};

/// cos(2 pi i / kSide), by halving the quarter turn and then turning step by step: libm's cosines
/// differ between machines in the last bit.
std::array<double, kSide> cosines() {
  double c = 0.0;  // of a quarter turn
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

/// Cubic B-spline weights of the four heights around, for value, first and second derivative per
/// height step; f in [0, 1) is the way past the second of them.
struct Weights {
  std::array<double, 4> value, first, second;
};

Weights weights(double f) noexcept {
  const double g = 1.0 - f;
  return {{g * g * g / 6.0, 2.0 / 3.0 - 0.5 * f * f * (2.0 - f),
           2.0 / 3.0 - 0.5 * g * g * (2.0 - g), f * f * f / 6.0},
          {-0.5 * g * g, 0.5 * f * (3.0 * f - 4.0), -0.5 * g * (3.0 * g - 4.0), 0.5 * f * f},
          {g, 3.0 * f - 2.0, 3.0 * g - 2.0, f}};
}

double sum(const std::vector<float>& heights, int ix, int iy, const std::array<double, 4>& wx,
           const std::array<double, 4>& wy) noexcept {
  double total = 0.0;
  for (int j = 0; j < 4; ++j) {
    const auto row = static_cast<std::size_t>((iy + j - 1) & (kSide - 1)) * kSide;
    double line = 0.0;
    for (int i = 0; i < 4; ++i) {
      const auto column = static_cast<std::size_t>((ix + i - 1) & (kSide - 1));
      line += wx[static_cast<std::size_t>(i)] * static_cast<double>(heights[row + column]);
    }
    total += wy[static_cast<std::size_t>(j)] * line;
  }
  return total;
}

}  // namespace

HeightField::HeightField(const HeightFieldSpec& spec)
    : spec_(spec), heights_mm_(std::size_t{kSide} * kSide, 0.0F) {
  if (!(spec_.wavelength_mm > 0.0)) spec_ = {.wavelength_mm = 1.0, .rms_um = 0.0};
  if (!(spec_.rms_um > 0.0)) return;  // flat
  make_waves();
  find_bounds();
}

void HeightField::make_waves() {
  const std::array<double, kSide> cosine = cosines();
  Random random(spec_.seed);
  std::vector<double> sum_of_waves(heights_mm_.size(), 0.0);
  constexpr int kMost = static_cast<int>(kWavesPerTile * kBand);
  constexpr double kLeast = kWavesPerTile / kBand;
  for (int wave = 0; wave < kWaves;) {
    const int kx = random.below(2 * kMost + 1) - kMost;
    const int ky = random.below(kMost + 1);
    const int phase = random.below(kSide);
    const double k_squared = kx * kx + ky * ky;
    if (k_squared < kLeast * kLeast || k_squared > kMost * kMost) continue;
    ++wave;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        // kx < 0: the mask of a negative int is its remainder, as two's complement is asked for.
        const auto turn = static_cast<std::size_t>((kx * x + ky * y + phase) & (kSide - 1));
        sum_of_waves[static_cast<std::size_t>(y * kSide + x)] += cosine[turn];
      }
    }
  }
  std::transform(sum_of_waves.begin(), sum_of_waves.end(), heights_mm_.begin(),
                 [](double h) { return static_cast<float>(h); });
  // The spline lowers waves this short by a tenth: measure what it gives, not what it is given.
  const std::array<double, 4> at_height = weights(0.0).value;
  double squares = 0.0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double h = sum(heights_mm_, x, y, at_height, at_height);
      squares += h * h;
    }
  }
  const double rms = std::sqrt(squares / static_cast<double>(heights_mm_.size()));
  for (float& h : heights_mm_)
    h = static_cast<float>(1e-3 * spec_.rms_um / rms * static_cast<double>(h));
}

void HeightField::find_bounds() noexcept {
  // At every height and half way between: the waves are at least 6.4 heights long, so the true
  // extremes are less than 3 % away from the largest seen.
  constexpr double kMargin = 1.03;
  const double per_mm = kSide / tile_mm();
  const std::array<Weights, 2> w{weights(0.0), weights(0.5)};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      for (unsigned corner = 0; corner < 4; ++corner) {
        const Weights& wx = w[corner & 1u];
        const Weights& wy = w[corner >> 1u];
        const auto at = [&](const auto& a, const auto& b) { return sum(heights_mm_, x, y, a, b); };
        const Vec slope{at(wx.first, wy.value), at(wx.value, wy.first)};
        const double xx = at(wx.second, wy.value);
        const double yy = at(wx.value, wy.second);
        const double xy = at(wx.first, wy.first);
        // The larger eigenvalue of the symmetric 2 x 2 matrix, by size.
        const double curvature =
            0.5 * (std::abs(xx + yy) + std::sqrt((xx - yy) * (xx - yy) + 4.0 * xy * xy));
        max_height_mm_ = std::max(max_height_mm_, kMargin * std::abs(at(wx.value, wy.value)));
        max_slope_ = std::max(max_slope_, kMargin * per_mm * norm(slope));
        max_curvature_per_mm_ =
            std::max(max_curvature_per_mm_, kMargin * per_mm * per_mm * curvature);
      }
    }
  }
}

HeightField::Sample HeightField::at(Point p) const noexcept {
  constexpr double kFarthestMm = 1e6;
  if (!(std::abs(p.x) <= kFarthestMm) || !(std::abs(p.y) <= kFarthestMm)) return {};
  const double per_mm = kSide / tile_mm();
  // In units of heights; remainders first, so that tiny wavelengths do not overflow an int.
  const double x = std::fmod(p.x * per_mm, static_cast<double>(kSide));
  const double y = std::fmod(p.y * per_mm, static_cast<double>(kSide));
  const double floor_x = std::floor(x);
  const double floor_y = std::floor(y);
  const Weights wx = weights(x - floor_x);
  const Weights wy = weights(y - floor_y);
  const int ix = static_cast<int>(floor_x);
  const int iy = static_cast<int>(floor_y);
  return {sum(heights_mm_, ix, iy, wx.value, wy.value),
          {per_mm * sum(heights_mm_, ix, iy, wx.first, wy.value),
           per_mm * sum(heights_mm_, ix, iy, wx.value, wy.first)}};
}

}  // namespace felt
