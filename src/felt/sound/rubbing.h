#pragma once

#include <cstdint>

#include "felt/geometry/point.h"
#include "felt/material/materials.h"

namespace felt {

class HeightField;

/// What rubs on what, for the ear: numbers only, and the relief, which lives for good.
struct RubbingPair {
  const HeightField* relief =
      nullptr;                       ///< surface_grain(surface): hand, eye and ear have one (R47)
  double grain_um = 0.0;             ///< its RMS height; also how rough it is below its waves
  double stiffness_n_per_m = 500.0;  ///< of the sheet: where it booms
  double friction = 0.25;            ///< mu of the pair
  double through = 1.0;              ///< how much of the relief comes through the medium, 0..1
  double wear = 0.0;                 ///< share of it that a firm push flattens (relief_left)
  double firm_push_n = 2.0;          ///< the push that is firm
  double loudness = 1.0;             ///< of both, 0..1
  double surface_brightness = 0.5;   ///< 0..1
  double medium_brightness = 0.5;    ///< 0..1
  double squeak = 0.0;               ///< 0..1
  std::uint32_t seed = 1;            ///< of the roughness

  friend bool operator==(const RubbingPair&, const RubbingPair&) = default;
};

/// Of a medium on a surface. Makes the relief where nobody asked for it yet (material/relief.h):
/// any thread but the haptic one.
RubbingPair rubbing_pair(const SurfaceMaterial& surface, const Medium& medium);

/// The pen at one sample. The speed is that of the way from sample to sample, whatever a device
/// says: what is heard cannot contradict what is drawn.
struct RubbingSample {
  std::int64_t time_ns = 0;  ///< of the session
  Point at{};                ///< mm, on the sheet
  double push_n = 0.0;       ///< on the sheet, N; 0 in the air
  /// How fast the pen came down, where it just did, mm/s; 0 where that is not known.
  double strike_mm_per_s = 0.0;
};

}  // namespace felt
