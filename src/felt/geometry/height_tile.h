#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/geometry/height_field.h"

/// Helpers to make height fields; not public. They use only + - * / and sqrt, so that the same seed
/// gives the same heights on every machine.
namespace felt::height_tile {

inline constexpr int kSide = HeightField::kSide;
/// Limits of the relief's waves. Waves that fit into the tile more than kFadeFrom times are
/// weakened, and those that fit kMaxWaves times or more are removed.
inline constexpr double kFadeFrom = 30.0;
inline constexpr double kMaxWaves = HeightField::kWavesPerTile * HeightField::kBand;

/// A tile of kSide x kSide heights, row by row, that repeats in both directions. The unit is up to
/// the caller.
using Tile = std::vector<double>;

/// SplitMix64 (Steele, Lea, Flood 2014). It is short and gives the same numbers on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept : state_(seed) {}
  /// Returns a number in 0..n-1. The bias of the remainder is below 1e-16 for the n used here.
  int below(int n) noexcept {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return static_cast<int>((z ^ (z >> 31)) % static_cast<std::uint64_t>(n));
  }
  /// Returns a number in [0, 1).
  double part() noexcept { return below(1 << 24) / static_cast<double>(1 << 24); }

 private:
  std::uint64_t state_;
};

/// Returns cos(2 pi i / kSide) for every i. Halves a quarter turn until the angle is one step, then
/// rotates by that step again and again. Does not call cos(), whose last bit differs between
/// machines.
std::array<double, kSide> cosines();

/// Removes waves that fit into the tile fewer than `smallest` times, or `largest` times or more.
/// Gradually weakens those between `fade_from` and `largest`.
void keep_band(Tile& tile, double smallest, double fade_from, double largest);

/// Returns the relief of a character, before its rms is set (height_characters.cc).
Tile heights_of(const HeightFieldSpec& spec);

}  // namespace felt::height_tile
