#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "felt/geometry/height_tile.h"

// The characters of HeightField. Each function draws a relief; keep_band then removes the waves
// that are too short. Distances are in steps between heights, kSide to a tile.
namespace felt::height_tile {
namespace {

constexpr double kHighestRms = 1.6;

std::size_t index_of(int x, int y) noexcept {
  return static_cast<std::size_t>((y & (kSide - 1)) * kSide + (x & (kSide - 1)));
}

Tile empty_tile() {
  return Tile(std::size_t{kSide} * kSide, 0.0);
}

double rms_of(const Tile& tile) noexcept {
  double squares = 0.0;
  for (const double h : tile) squares += h * h;
  return std::sqrt(squares / static_cast<double>(tile.size()));
}

void scale_to(Tile& tile, double rms) noexcept {
  const double now = rms_of(tile);
  if (!(now > 0.0)) return;
  for (double& h : tile) h *= rms / now;
}

void add(Tile& tile, const Tile& other) noexcept {
  for (std::size_t i = 0; i < tile.size(); ++i) tile[i] += other[i];
}

/// Rounds off extreme heights so that no height exceeds `most` times the previous rms. The highest
/// or steepest point limits the force of the whole relief. If the extremes are flatter, the rest
/// can be stronger.
void round_off(Tile& tile, double largest) noexcept {
  double mean = 0.0;
  for (const double h : tile) mean += h / static_cast<double>(tile.size());
  for (double& h : tile) h -= mean;
  scale_to(tile, 1.0 / largest);
  for (double& h : tile) h /= std::sqrt(1.0 + h * h);
}

/// Cosine and sine of an angle in turns, linearly interpolated in a table.
class Circle {
 public:
  [[nodiscard]] double cosine(double turns) const noexcept {
    const double at = kSide * (turns - std::floor(turns));
    const auto i = std::min(static_cast<std::size_t>(at), std::size_t{kSide - 1});
    const double part = at - static_cast<double>(i);
    return table_[i] + part * (table_[(i + 1) % kSide] - table_[i]);
  }
  [[nodiscard]] double sine(double turns) const noexcept { return cosine(turns - 0.25); }
  /// Returns the cosine of `step` / kSide turns.
  [[nodiscard]] double at(int step) const noexcept {
    return table_[static_cast<std::size_t>(step & (kSide - 1))];
  }

 private:
  std::array<double, kSide> table_ = cosines();
};

/// Parameters of random waves: how many there are, the largest number of waves per tile in x and in
/// y, and the range of the length of that vector.
struct Waves {
  int count;
  int max_x, max_y;
  double smallest, largest;
};

void add_waves(Tile& tile, const Circle& circle, Random& random, const Waves& waves) {
  for (int wave = 0; wave < waves.count;) {
    const int kx = random.below(2 * waves.max_x + 1) - waves.max_x;
    const int ky = random.below(waves.max_y + 1);
    const int phase = random.below(kSide);
    const double k_squared = kx * kx + ky * ky;
    if (k_squared < waves.smallest * waves.smallest || k_squared > waves.largest * waves.largest)
      continue;
    ++wave;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        // The angle may be negative: at() masks it, which gives the remainder in two's complement.
        tile[index_of(x, y)] += circle.at(kx * x + ky * y + phase);
      }
    }
  }
}

Waves ring(double waves_per_tile, int count) noexcept {
  const double largest = waves_per_tile * HeightField::kBand;
  const int box = static_cast<int>(largest);
  return {count, box, box, waves_per_tile / HeightField::kBand, static_cast<double>(box)};
}

Tile smooth_noise(const Circle& circle, Random& random, const Waves& waves, double rms) {
  Tile noise = empty_tile();
  add_waves(noise, circle, random, waves);
  scale_to(noise, rms);
  return noise;
}

Tile grain(Random& random) {
  const Circle circle;
  Tile tile = empty_tile();
  add_waves(tile, circle, random, ring(HeightField::kWavesPerTile, 96));
  return tile;
}

/// Hills of several sizes with narrow valleys between them, as made by the felt of a paper press.
Tile rough(Random& random) {
  const Circle circle;
  Tile tile = smooth_noise(circle, random, ring(12.0, 64), 1.0);
  add(tile, smooth_noise(circle, random, ring(24.0, 64), 0.6));
  // Makes the hills round and the valleys narrow.
  for (double& h : tile) h = h - 0.22 * h * h;
  // The imprint of the press felt: long waves, more of them along y than along x.
  add(tile, smooth_noise(circle, random, {24, 4, 6, 3.0, 7.0}, 0.35));
  return tile;
}

/// Plain weave: two sets of 32 threads that alternately pass over and under each other.
Tile weave(Random& random) {
  constexpr int kThreads = 32;
  constexpr double kPitch = static_cast<double>(kSide) / kThreads;
  constexpr double kUndulation = 0.9;
  const Circle circle;
  const Waves slow = ring(4.0, 16);
  const Tile aside = smooth_noise(circle, random, slow, 0.10 * kPitch);
  const Tile up = smooth_noise(circle, random, slow, 0.10 * kPitch);
  const Tile thick = smooth_noise(circle, random, ring(8.0, 24), 0.12);
  std::array<std::array<double, kThreads>, 2> thread{};
  for (auto& system : thread) {
    for (double& one : system) one = 0.85 + 0.3 * random.part();
  }
  Tile tile = empty_tile();
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const std::size_t i = index_of(x, y);
      const double u = (x + aside[i]) / kPitch, v = (y + up[i]) / kPitch;
      const auto of = [](double at) {
        return static_cast<std::size_t>(static_cast<int>(std::floor(at + 0.5)) & (kThreads - 1));
      };
      const double over = circle.cosine(0.5 * u) * circle.cosine(0.5 * v);
      const double warp =
          thread[0][of(u)] * (0.5 + 0.5 * circle.cosine(u)) * (1.0 + kUndulation * over);
      const double weft =
          thread[1][of(v)] * (0.5 + 0.5 * circle.cosine(v)) * (1.0 - kUndulation * over);
      const double apart = warp - weft;
      tile[i] = 0.5 * (warp + weft + std::sqrt(apart * apart + 0.02)) + 0.6 * thick[i];
    }
  }
  return tile;
}

/// Fibres that cross each other. Each is a walk that changes its direction a little at every step.
Tile fibres(Random& random) {
  const Circle circle;
  Tile tile = empty_tile();
  for (int fibre = 0; fibre < 420; ++fibre) {
    double x = random.below(kSide), y = random.below(kSide);
    double heading = random.part(), turning = 0.0;
    const double height = 0.4 + random.part();
    const int length = 80 + random.below(160);
    for (int step = 0; step < length; ++step) {
      turning = 0.9 * turning + 0.006 * (random.part() - 0.5);
      heading += turning;
      x += 0.7 * circle.cosine(heading);
      y += 0.7 * circle.sine(heading);
      const double left = std::floor(x), top = std::floor(y);
      const double fx = x - left, fy = y - top;
      const int ix = static_cast<int>(left), iy = static_cast<int>(top);
      tile[index_of(ix, iy)] += height * (1.0 - fx) * (1.0 - fy);
      tile[index_of(ix + 1, iy)] += height * fx * (1.0 - fy);
      tile[index_of(ix, iy + 1)] += height * (1.0 - fx) * fy;
      tile[index_of(ix + 1, iy + 1)] += height * fx * fy;
    }
  }
  return tile;
}

/// Returns the signed distance on the repeating tile, -kSide/2 .. kSide/2.
double round_trip(double from, double to) noexcept {
  const double d = to - from;
  return d - kSide * std::floor(d / kSide + 0.5);
}

/// Annual rings cut lengthwise: lines along x that bend, converge, diverge and go round a knot. The
/// height of each ring rises slowly (early wood) and falls steeply (late wood). Fine fibres are
/// added.
Tile wood(Random& random) {
  constexpr double kRings = 18.0;
  const Circle circle;
  const Tile bent = smooth_noise(circle, random, {14, 1, 3, 1.0, 3.2}, 0.7);
  const Tile fibre = smooth_noise(circle, random, {80, 2, 38, 22.0, 38.0}, 0.16);
  const double knot_x = random.below(kSide), knot_y = random.below(kSide);
  Tile tile = empty_tile();
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const std::size_t i = index_of(x, y);
      const double along = round_trip(knot_x, x) / 40.0, across = round_trip(knot_y, y) / 14.0;
      const double near = 1.0 / (1.0 + along * along + across * across);
      const double ring = kRings * y / kSide + bent[i] + 2.5 * near * near;
      const double part = ring - std::floor(ring);
      const double rise = part < 0.75 ? part / 0.75 : (1.0 - part) / 0.25;
      tile[i] = rise * rise + fibre[i];
    }
  }
  return tile;
}

}  // namespace

Tile heights_of(const HeightFieldSpec& spec) {
  Random random(spec.seed);
  double smallest = 1.0;
  Tile tile;
  switch (spec.character) {
    case HeightCharacter::kGrain:
    case HeightCharacter::kPicture:
      return grain(random);  // already a ring of waves: nothing to filter
    case HeightCharacter::kRough:
      tile = rough(random);
      break;
    case HeightCharacter::kWeave:
      tile = weave(random);
      break;
    case HeightCharacter::kFibres:
      tile = fibres(random);
      smallest = 4.0;  // removes the long hills made by the uneven density of random fibres
      break;
    case HeightCharacter::kWood:
      tile = wood(random);
      break;
  }
  keep_band(tile, smallest, kFadeFrom, kMaxWaves);
  round_off(tile, kHighestRms);
  keep_band(tile, smallest, kFadeFrom, kMaxWaves);
  return tile;
}

}  // namespace felt::height_tile
