#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "felt/geometry/point.h"

namespace felt {

/// What is rough on a sheet below the waves of its relief: noise that lies on the sheet, by
/// *position* and not by time (Siira and Pai 1996), so that the same way sounds the same twice.
/// Octaves of it, each half as long as the one before, from a length down to kFinestMm; never
/// repeats. How much of each is heard is set by the speed: an octave that passes faster than
/// samples can tell is left out, so that nothing folds back, and a slow pen sounds duller.
///
/// A value; no allocation; any one thread.
class Roughness {
 public:
  static constexpr double kFinestMm = 0.006;
  static constexpr std::size_t kMostOctaves = 12;

  /// From this wavelength downwards, mm.
  void set(double longest_mm, std::uint32_t seed) noexcept;
  /// How fast the way is gone along from now on, mm/s; weights go there evenly in `samples`.
  void set_speed(double mm_per_s, double rate_hz, int samples) noexcept;
  /// The noise there; RMS about 1 for a fast pen. Call once a sample: weights go on.
  double next(Point p) noexcept;

 private:
  struct Octave {
    double per_mm = 1.0;
    double dx = 0.0, dy = 0.0;  // where its lattice begins
    double weight = 0.0, step = 0.0;
    std::uint64_t seed = 0;
  };
  std::array<Octave, kMostOctaves> octaves_{};
  std::size_t count_ = 0;
};

}  // namespace felt
