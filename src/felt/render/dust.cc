#include "felt/render/dust.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/render/relief_square.h"

namespace felt::dust {
namespace {

constexpr int kLog2Side = 10, kCoarsest = 3;
constexpr int kSide = 1 << kLog2Side;

/// White noise smoothed by `passes` box filters of 2 `radius` + 1 texels, which is close to a
/// Gaussian, and its share of the height.
struct Octave {
  int radius = 0, passes = 0;
  double share = 1.0;
};
/// Standard deviations of the kernels: 0, 1.2, 2.4, 4.5 and 8.5 texels; a crumb is 16 texels wide.
constexpr std::array<Octave, 5> kOctaves{
    {{0, 0, 0.55}, {1, 2, 0.8}, {2, 3, 1.0}, {4, 3, 1.0}, {8, 3, 0.8}}};

std::uint32_t mixed(std::uint32_t n) noexcept {
  n = (n ^ (n >> 16U)) * 0x7FEB352DU;
  n = (n ^ (n >> 15U)) * 0x846CA68BU;
  return n ^ (n >> 16U);
}

std::vector<float> white_noise(std::uint32_t seed) {
  std::vector<float> noise(std::size_t{kSide} * kSide);
  std::uint32_t n = mixed(seed) | 1U;
  for (float& v : noise) v = static_cast<float>(static_cast<std::int32_t>(mixed(n++)) >> 8);
  return noise;
}

/// Smooths all columns: each height becomes the sum of those up to `radius` above and below.
void smooth_columns(std::vector<float>& heights, int radius) {
  const std::vector<float> from = heights;
  const auto row = [&](int y) {
    return from.data() + static_cast<std::ptrdiff_t>(y & (kSide - 1)) * kSide;
  };
  std::vector<float> sum(kSide, 0.0F);
  for (int y = -radius; y <= radius; ++y) {
    for (std::size_t x = 0; x < sum.size(); ++x) sum[x] += row(y)[x];
  }
  for (int y = 0; y < kSide; ++y) {
    float* to = heights.data() + static_cast<std::ptrdiff_t>(y) * kSide;
    const float *in = row(y + radius + 1), *out = row(y - radius);
    for (std::size_t x = 0; x < sum.size(); ++x) {
      to[x] = sum[x];
      sum[x] += in[x] - out[x];
    }
  }
}

void transpose(std::vector<float>& heights) {
  constexpr std::size_t kBlock = 32, kWide = kSide;
  for (std::size_t y0 = 0; y0 < kWide; y0 += kBlock) {
    for (std::size_t x0 = y0; x0 < kWide; x0 += kBlock) {
      for (std::size_t y = y0; y < y0 + kBlock; ++y) {
        for (std::size_t x = x0 == y0 ? y + 1 : x0; x < x0 + kBlock; ++x) {
          std::swap(heights[y * kWide + x], heights[x * kWide + y]);
        }
      }
    }
  }
}

/// Scales to mean 0 and the RMS `rms`.
void normalize(std::vector<float>& heights, double rms) {
  double sum = 0.0, squares = 0.0;
  for (const float h : heights) {
    sum += static_cast<double>(h);
    squares += static_cast<double>(h) * static_cast<double>(h);
  }
  const auto count = static_cast<double>(heights.size());
  const double mean = sum / count;
  const double scale = rms / std::sqrt(squares / count - mean * mean);
  for (float& h : heights) h = static_cast<float>(scale * (static_cast<double>(h) - mean));
}

ReliefSquare make_square() {
  ReliefSquare all{kSide, std::vector<float>(std::size_t{kSide} * kSide, 0.0F)};
  std::uint32_t seed = 1;
  for (const Octave& octave : kOctaves) {
    std::vector<float> heights = white_noise(seed++);
    for (int turn = 0; turn < (octave.passes > 0 ? 2 : 0); ++turn) {
      for (int pass = 0; pass < octave.passes; ++pass) smooth_columns(heights, octave.radius);
      transpose(heights);
    }
    normalize(heights, octave.share);
    for (std::size_t i = 0; i < heights.size(); ++i) all.heights[i] += heights[i];
  }
  normalize(all.heights, 1.0);
  return all;
}

using Levels = std::array<std::shared_ptr<const ReliefLevel>, kLog2Side + 1>;

const Levels& levels() {
  static const Levels& made = *new Levels([] {  // outlives every thread
    Levels all;
    ReliefSquare square = make_square();
    for (int n = kLog2Side; n >= kCoarsest; --n) {
      all[static_cast<std::size_t>(n)] = level_of(square);
      square = halved(square);
    }
    return all;
  }());
  return made;
}

}  // namespace

double height(Point place) {
  const ReliefLevel& finest = *levels().back();
  constexpr double kPerCrumb = kSide / kWavesPerTile;
  const double u = kPerCrumb * (kTurn.x * place.x + kTurn.y * place.y);
  const double v = kPerCrumb * (kTurn.x * place.y - kTurn.y * place.x);
  if (!(std::abs(u) < 1e9 && std::abs(v) < 1e9)) return 0.0;
  const auto x = static_cast<std::int64_t>(std::floor(u)),
             y = static_cast<std::int64_t>(std::floor(v));
  const double fx = u - static_cast<double>(x), fy = v - static_cast<double>(y);
  const auto at = [&](std::int64_t right, std::int64_t down) {
    return static_cast<double>(finest.texels[static_cast<std::size_t>(
        (((y + down) & (kSide - 1)) << kLog2Side) + ((x + right) & (kSide - 1)))]);
  };
  return std::lerp(std::lerp(at(0, 0), at(1, 0), fx), std::lerp(at(0, 1), at(1, 1), fx), fy) /
         ReliefLevel::kPerRms;
}

std::shared_ptr<const ReliefLevel> level(double px_per_tile) {
  if (!(px_per_tile > (1 << kCoarsest))) return nullptr;
  int log2 = kCoarsest;
  while (log2 < kLog2Side && 0.75 * (1 << log2) < px_per_tile) ++log2;
  return levels()[static_cast<std::size_t>(log2)];
}

}  // namespace felt::dust
