#include "felt/geometry/height_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "felt/geometry/height_tile.h"

namespace felt {
namespace {

constexpr int kSide = HeightField::kSide;
/// Cubic B-spline weights of four neighbouring heights, for the value and the first and second
/// derivative per height step. f in [0, 1) is the position between the second and the third.
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
    : HeightField(spec, spec.wavelength_mm > 0.0 && spec.rms_um > 0.0
                            ? height_tile::heights_of(spec)
                            : std::vector<double>{}) {}

HeightField::HeightField(const HeightFieldSpec& spec, const std::vector<double>& tile)
    : spec_(spec) {
  const bool is_flat =
      !(spec_.rms_um > 0.0) || tile.size() != std::size_t{kSide} * kSide ||
      !std::all_of(tile.begin(), tile.end(), [](double h) { return std::isfinite(h); }) ||
      std::all_of(tile.begin(), tile.end(), [](double h) { return h == 0.0; });
  if (!is_flat) tile_ = tile_of(tile);
  size();
}

HeightField HeightField::scaled(double wavelength_mm, double rms_um) const {
  HeightField other = *this;
  other.spec_.wavelength_mm = wavelength_mm;
  other.spec_.rms_um = rms_um;
  other.size();
  return other;
}

void HeightField::size() {
  const auto is_size = [](double x) { return std::isfinite(x) && x > 0.0; };
  if (!is_size(spec_.wavelength_mm)) spec_ = {.wavelength_mm = 1.0, .rms_um = 0.0};
  if (!is_size(spec_.rms_um) || !tile_) {
    tile_.reset();
    spec_.rms_um = 0.0;
    rms_mm_ = max_height_mm_ = max_slope_ = max_curvature_per_mm_ = 0.0;
    return;
  }
  const double per_mm = 1.0 / spec_.wavelength_mm;
  rms_mm_ = 1e-3 * spec_.rms_um;
  max_height_mm_ = rms_mm_ * tile_->max_height;
  max_slope_ = rms_mm_ * per_mm * tile_->max_slope;
  max_curvature_per_mm_ = rms_mm_ * per_mm * per_mm * tile_->max_curvature;
}

std::shared_ptr<const HeightField::Tile> HeightField::tile_of(const std::vector<double>& heights) {
  auto tile = std::make_shared<Tile>();
  tile->heights.assign(heights.begin(), heights.end());
  // Measures the rms of the spline, not of its coefficients: the spline lowers short waves by 10 %.
  const std::array<double, 4> at_height = weights(0.0).value;
  double squares = 0.0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double h = sum(tile->heights, x, y, at_height, at_height);
      squares += h * h;
    }
  }
  const double rms = std::sqrt(squares / static_cast<double>(heights.size()));
  for (float& h : tile->heights) h = static_cast<float>(static_cast<double>(h) / rms);
  find_bounds(*tile);
  return tile;
}

void HeightField::find_bounds(Tile& tile) noexcept {
  // Samples every height and every midpoint. The waves are at least 6.4 heights long, so the true
  // extremes are less than 3 % above the largest sample.
  constexpr double kMargin = 1.03;
  constexpr double kPerWave = kSide / kWavesPerTile;
  const std::array<Weights, 2> w{weights(0.0), weights(0.5)};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      for (unsigned corner = 0; corner < 4; ++corner) {
        const Weights& wx = w[corner & 1u];
        const Weights& wy = w[corner >> 1u];
        const auto at = [&](const auto& a, const auto& b) { return sum(tile.heights, x, y, a, b); };
        const Vec slope{at(wx.first, wy.value), at(wx.value, wy.first)};
        const double xx = at(wx.second, wy.value);
        const double yy = at(wx.value, wy.second);
        const double xy = at(wx.first, wy.first);
        // The largest absolute eigenvalue of the symmetric 2 x 2 matrix.
        const double curvature =
            0.5 * (std::abs(xx + yy) + std::sqrt((xx - yy) * (xx - yy) + 4.0 * xy * xy));
        tile.max_height = std::max(tile.max_height, kMargin * std::abs(at(wx.value, wy.value)));
        tile.max_slope = std::max(tile.max_slope, kMargin * kPerWave * norm(slope));
        tile.max_curvature =
            std::max(tile.max_curvature, kMargin * kPerWave * kPerWave * curvature);
      }
    }
  }
}

HeightField::Sample HeightField::at(Point p) const noexcept {
  constexpr double kFarthestMm = 1e6;
  if (!tile_) return {};
  if (!(std::abs(p.x) <= kFarthestMm) || !(std::abs(p.y) <= kFarthestMm)) return {};
  const double per_mm = kSide / tile_mm();
  // In height steps. The remainder is computed before the conversion to int, so that tiny
  // wavelengths do not overflow.
  const double x = std::fmod(p.x * per_mm, static_cast<double>(kSide));
  const double y = std::fmod(p.y * per_mm, static_cast<double>(kSide));
  const double floor_x = std::floor(x);
  const double floor_y = std::floor(y);
  const Weights wx = weights(x - floor_x);
  const Weights wy = weights(y - floor_y);
  const int ix = static_cast<int>(floor_x);
  const int iy = static_cast<int>(floor_y);
  const std::vector<float>& heights = tile_->heights;
  const double slope = rms_mm_ * per_mm;
  return {rms_mm_ * sum(heights, ix, iy, wx.value, wy.value),
          {slope * sum(heights, ix, iy, wx.first, wy.value),
           slope * sum(heights, ix, iy, wx.value, wy.first)}};
}

}  // namespace felt
