#include "felt/sound/rubbing.h"

#include <algorithm>

#include "felt/material/relief.h"

namespace felt {

RubbingPair rubbing_pair(const SurfaceMaterial& surface, const Medium& medium) {
  const auto unit = [](double value) { return value > 0.0 ? std::min(value, 1.0) : 0.0; };
  RubbingPair pair;
  pair.relief = surface_grain(surface);
  pair.grain_um = pair.relief ? surface.grain_um : 0.0;
  pair.stiffness_n_per_m = surface.stiffness_n_per_m;
  pair.friction = friction_of(medium, surface);
  pair.through = unit(medium.grain);
  pair.wear = unit(medium.wear);
  pair.loudness = unit(medium.sound.loudness) * unit(surface.sound.loudness);
  pair.surface_brightness = unit(surface.sound.brightness);
  pair.medium_brightness = unit(medium.sound.brightness);
  // A dull surface damps the squeak.
  pair.squeak = unit(medium.sound.squeak) * unit(1.3 * pair.surface_brightness);
  pair.seed = surface.grain_seed;
  return pair;
}

}  // namespace felt
