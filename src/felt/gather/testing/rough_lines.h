#pragma once

#include <cstdint>
#include <vector>

#include "felt/gather/line_sections.h"
#include "felt/geometry/cubic.h"

namespace felt {

/// Random numbers that are the same on every machine (splitmix64, Steele et al. 2014,
/// doi:10.1145/2660193.2660195).
class TestRandom {
 public:
  explicit TestRandom(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  /// Returns a number from 0 to n - 1.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
  /// Returns a number from -1 to 1.
  double signed_unit() { return static_cast<double>(next() >> 11) * 0x1p-52 - 1.0; }

 private:
  std::uint64_t state_;
};

/// Returns copies of a cubic as a hand would redraw it: each is shifted by up to `jitter_mm` and
/// waves by up to a quarter of it.
inline std::vector<RoughLine> jittered_copies(const Cubic& middle, int count, double jitter_mm,
                                              std::uint64_t seed) {
  TestRandom random(seed);
  std::vector<RoughLine> lines;
  for (int i = 0; i < count; ++i) {
    const Vec shift{jitter_mm * random.signed_unit(), jitter_mm * random.signed_unit()};
    const double phase = 3.0 * random.signed_unit();
    RoughLine line;
    for (int k = 0; k <= 60; ++k) {
      const double t = k / 60.0;
      const Vec wave = 0.25 * jitter_mm * std::sin(9.0 * t + phase) * perp(tangent(middle, t));
      line.push_back(evaluate(middle, t) + shift + wave);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace felt
