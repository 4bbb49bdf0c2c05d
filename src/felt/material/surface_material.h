#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "felt/geometry/height_field.h"

namespace felt {

/// What a surface adds to the sound of a pen that rubs on it; the relief does the rest.
struct SurfaceSound {
  double loudness = 1.0;    ///< 0..1, 0 is silent
  double brightness = 0.5;  ///< 0 dull (felt) .. 1 bright (glass)

  friend bool operator==(const SurfaceSound&, const SurfaceSound&) = default;
};

/// A sheet to draw on (specification 5b): the plane's resistance, the friction on it, and the one
/// relief that eye, hand and ear share.
struct SurfaceMaterial {
  std::string id;     ///< "rough-paper": what documents and events say
  std::string label;  ///< "Rough paper", for people
  double stiffness_n_per_m = 500.0;
  double damping_n_s_per_m = 2.0;
  double friction = 0.25;  ///< mu of the reference medium, the pencil, on it
  /// Grain: RMS height and wavelength of its height field (specification 5i); 0 = smooth.
  double grain_um = 0.0;
  double grain_mm = 0.0;
  HeightCharacter grain_character = HeightCharacter::kGrain;
  std::uint32_t grain_seed = 1;
  /// A person's own relief, where the character is kPicture; any size, it takes that of the above.
  std::shared_ptr<const HeightField> picture{};
  SurfaceSound sound{};
  std::uint32_t color_rgb = 0xFFFFFF;  ///< of the sheet, 0xRRGGBB; a wish, the page has its own

  /// What its relief is made from.
  [[nodiscard]] HeightFieldSpec grain() const noexcept {
    return {grain_mm, grain_um, grain_seed, grain_character};
  }
  friend bool operator==(const SurfaceMaterial&, const SurfaceMaterial&) = default;
};

}  // namespace felt
