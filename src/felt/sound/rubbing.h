#pragma once

#include <cstdint>

#include "felt/geometry/point.h"
#include "felt/material/materials.h"

namespace felt {

class HeightField;

/// The sound parameters of a medium on a surface: numbers, and the relief, which is never deleted.
struct RubbingPair {
  const HeightField* relief = nullptr;  ///< surface_grain(surface), the same relief that is felt
                                        ///< and displayed (R47), or null
  double grain_um = 0.0;                ///< RMS height of the relief and of the roughness
  double stiffness_n_per_m = 500.0;     ///< of the surface; determines its lowest resonance
  double friction = 0.25;               ///< mu of the pair
  double through = 1.0;                 ///< share of the relief that the medium transmits, 0..1
  /// Share of the relief that a firm push flattens (relief_left).
  double wear = 0.0;
  double firm_push_n = 2.0;         ///< the push that counts as firm, N
  double loudness = 1.0;            ///< loudness of the medium on the surface, 0..1
  double surface_brightness = 0.5;  ///< 0..1
  double medium_brightness = 0.5;   ///< 0..1
  double squeak = 0.0;              ///< 0..1
  std::uint32_t seed = 1;           ///< seed of the roughness

  friend bool operator==(const RubbingPair&, const RubbingPair&) = default;
};

/// Returns the sound parameters of a medium on a surface. It may compute the relief, which takes up
/// to 60 ms (material/relief.h). Call it on any thread except the haptic thread.
RubbingPair rubbing_pair(const SurfaceMaterial& surface, const Medium& medium);

/// The pen at one sample. The speed is computed from the positions and not taken from the device,
/// so that the sound cannot contradict the drawing.
struct RubbingSample {
  std::int64_t time_ns = 0;  ///< session time
  Point at{};                ///< position on the page, mm
  double push_n = 0.0;       ///< force on the surface, N; 0 above the surface
  /// If the pen has just come down, the speed at which it landed, mm/s; 0 if unknown.
  double strike_mm_per_s = 0.0;
};

}  // namespace felt
