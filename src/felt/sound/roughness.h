#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "felt/geometry/point.h"

namespace felt {

/// The roughness of a surface at wavelengths shorter than those of its relief. It is noise as a
/// function of *position*, not of time (Siira and Pai 1996), so that the same path sounds the same
/// again. It is a sum of octaves, each with half the wavelength of the previous one, down to
/// kFinestMm, and never repeats. The weight of an octave depends on the speed. An octave whose
/// frequency is too high for the sample rate is left out to prevent aliasing. A slow pen sounds
/// duller.
///
/// A value type that does not allocate. Use it on one thread at a time.
class Roughness {
 public:
  static constexpr double kFinestMm = 0.006;
  static constexpr std::size_t kMaxOctaves = 12;

  /// Sets the longest wavelength in mm, and the seed.
  void set(double longest_mm, std::uint32_t seed) noexcept;
  /// Sets the speed in mm/s. The weights change linearly over the next `samples` samples.
  void set_speed(double mm_per_s, double rate_hz, int samples) noexcept;
  /// Returns the noise at p; RMS about 1 for a fast pen. Call it once for each sample, because it
  /// advances the weights.
  double next(Point p) noexcept;

 private:
  struct Octave {
    double per_mm = 1.0;
    double dx = 0.0, dy = 0.0;  // offset of its lattice
    double weight = 0.0, step = 0.0;
    std::uint64_t seed = 0;
  };
  std::array<Octave, kMaxOctaves> octaves_{};
  std::size_t count_ = 0;
};

}  // namespace felt
