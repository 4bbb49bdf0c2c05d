#include "felt/sound/roughness.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

/// The finaliser of SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t mixed(std::uint64_t z) noexcept {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/// Returns the random value, -1..1, of a lattice point.
double value_at(std::int64_t x, std::int64_t y, std::uint64_t seed) noexcept {
  const std::uint64_t place = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15u ^
                              static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4Fu;
  return static_cast<double>(static_cast<std::int64_t>(mixed(place ^ seed))) /
         9223372036854775808.0;
}

double eased(double t) noexcept {
  return t * t * (3.0 - 2.0 * t);
}

/// Returns 0 below a, 1 above b, and a smooth step in between.
double rising(double x, double a, double b) noexcept {
  return eased(std::clamp((x - a) / (b - a), 0.0, 1.0));
}

/// Returns the weight of an octave if `per_s` of its lattice points pass in a second. The weight
/// rises slightly with the frequency and is 0 if the frequency is inaudibly low or too high for the
/// sample rate.
double weight_of(double per_s, double rate_hz) noexcept {
  constexpr double kPlainHz = 6000.0, kLoudest = 2.0;
  const double tone = std::min(std::sqrt(per_s / kPlainHz), kLoudest);
  return tone * rising(per_s, 40.0, 120.0) * (1.0 - rising(per_s, 0.4 * rate_hz, 0.9 * rate_hz));
}

}  // namespace

void Roughness::set(double longest_mm, std::uint32_t seed) noexcept {
  double length = std::clamp(longest_mm, kFinestMm, 20.0);
  std::uint64_t random = mixed(seed + 0x9E3779B97F4A7C15u);
  for (count_ = 0; count_ < kMaxOctaves && length >= kFinestMm; length *= 0.5) {
    Octave& octave = octaves_[count_++];
    random = mixed(random + 0x9E3779B97F4A7C15u);
    // The lattices of the octaves are shifted against each other, so that no line lies on lattice
    // lines of all octaves.
    const double shift = static_cast<double>(random >> 40) / 16777216.0;
    octave = {1.0 / length, 0.37 * shift, 0.61 * shift, octave.weight, 0.0, random};
  }
}

void Roughness::set_speed(double mm_per_s, double rate_hz, int samples) noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    Octave& octave = octaves_[i];
    const double target = weight_of(mm_per_s * octave.per_mm, rate_hz);
    octave.step = (target - octave.weight) / samples;
    // Removes the rounding error of an octave that has faded out.
    if (target == 0.0 && std::fabs(octave.weight) < 1e-9) octave.weight = octave.step = 0.0;
  }
}

double Roughness::next(Point p) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    Octave& octave = octaves_[i];
    octave.weight += octave.step;
    if (octave.weight == 0.0) continue;
    // The lattice is rotated, so that a line along an axis of the page crosses it.
    const double x = (0.83 * p.x - 0.557 * p.y) * octave.per_mm + octave.dx;
    const double y = (0.557 * p.x + 0.83 * p.y) * octave.per_mm + octave.dy;
    const double floor_x = std::floor(x), floor_y = std::floor(y);
    const auto ix = static_cast<std::int64_t>(floor_x), iy = static_cast<std::int64_t>(floor_y);
    const double tx = eased(x - floor_x), ty = eased(y - floor_y);
    const double a = value_at(ix, iy, octave.seed), b = value_at(ix + 1, iy, octave.seed);
    const double c = value_at(ix, iy + 1, octave.seed), d = value_at(ix + 1, iy + 1, octave.seed);
    const double top = a + tx * (b - a), bottom = c + tx * (d - c);
    sum += octave.weight * (top + ty * (bottom - top));
  }
  return sum;
}

}  // namespace felt
