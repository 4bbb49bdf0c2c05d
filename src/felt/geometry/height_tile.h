#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/geometry/height_field.h"

/// What the makers of height fields share; not public. All of it with + - * / and sqrt alone, so
/// that a seed gives the same heights on every machine.
namespace felt::height_tile {

inline constexpr int kSide = HeightField::kSide;
/// Waves per tile: shorter ones fade from the first number on and end at the second.
inline constexpr double kFadeFrom = 30.0;
inline constexpr double kMaxWaves = HeightField::kWavesPerTile * HeightField::kBand;

/// kSide x kSide heights, row by row, that repeat in both directions; in any unit.
using Tile = std::vector<double>;

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
  /// In [0, 1).
  double part() noexcept { return below(1 << 24) / static_cast<double>(1 << 24); }

 private:
  std::uint64_t state_;
};

/// cos(2 pi i / kSide), by halving the quarter turn and then turning step by step: libm's cosines
/// differ between machines in the last bit.
std::array<double, kSide> cosines();

/// Removes what is shorter than kSide/`most` heights, fading from `fade_from` waves per tile on,
/// and what is longer than kSide/`least`.
void keep_band(Tile& tile, double least, double fade_from, double most);

/// The relief of a character, before its rms is set (height_characters.cc).
Tile heights_of(const HeightFieldSpec& spec);

}  // namespace felt::height_tile
