#pragma once

#include <array>
#include <cstdint>

#include "felt/geometry/vec.h"

namespace felt::cli {

/// Physiological tremor: a displacement of 0.03 mm rms on each axis at 8 to 12 Hz (specification
/// section 0), different for each seed and the same for the same one. Seed 0 is none.
class Tremor {
 public:
  explicit Tremor(std::uint64_t seed);
  /// In mm, at a time.
  [[nodiscard]] Vec at(std::int64_t time_ns) const noexcept;

 private:
  struct Tone {
    double hz = 0.0, phase_x = 0.0, phase_y = 0.0;
  };
  std::array<Tone, 5> tones_;
  double amplitude_mm_ = 0.0;
};

}  // namespace felt::cli
