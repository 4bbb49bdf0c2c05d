#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/height_field.h"
#include "felt/material/medium_style.h"

namespace felt {

/// The largest coefficient of friction: the limit for the values in texts, including `pairs`, and
/// for the values that friction_of computes. Rubber on rubber is about 1.
inline constexpr double kMaxFriction = 1.5;

/// How the line depends on the pressure p and the tilt of the pen. In these formulas, `tilt` is the
/// tilt converted to 0..1 (`tilt_share`, geometry/tilt.h).
///
///   width = (min + (max - min) p^gamma) (1 + (tilt_width - 1) tilt)
///   tone  = (tone_light + (tone_heavy - tone_light) p^tone_gamma) (1 + (tilt_tone - 1) tilt)
struct MediumLine {
  double min_mm = 0.3;  ///< range of widths; set in the pencil tool when the medium is selected
  double max_mm = 6.0;
  double gamma = 1.0;
  double tilt_width = 1.0;  ///< width at full tilt, as a multiple of the upright width, >= 1
  double tone_light = 0.0;  ///< tone without pressure, 0..1
  double tone_heavy = 1.0;  ///< tone at full pressure, 0..1
  double tone_gamma = 1.0;
  double tilt_tone = 1.0;  ///< tone at full tilt, as a share of the upright tone, 0..1

  friend bool operator==(const MediumLine&, const MediumLine&) = default;
};

/// How the medium looks on the surface, depending on the tone (WidthKnot::tone); used by
/// render/grain.h. Heights are in multiples of the RMS of the relief.
struct MediumLook {
  double opacity_light = 1.0;  ///< opacity of the inked parts at tone 0
  double opacity_heavy = 1.0;  ///< opacity of the inked parts at tone 1
  double grain = 1.0;          ///< visible share of the surface's relief; 0 for wet media
  double cut_light = 0.35;     ///< the surface stays bare below this height, in RMS, at tone 0
  double cut_heavy = -2.6;     ///< height below which the surface stays bare at tone 1
  double soft = 0.9;           ///< the ink fades in from `soft` below the cut to `soft` above
  double crumb = 0.0;          ///< amount of grain that the medium itself adds (dust, crumbs), 0..1
  double crumb_mm = 0.3;       ///< wavelength of that grain
  double edge = 0.0;           ///< width of the soft edge of the line, as a share of its radius
  double rim = 0.0;            ///< how much darker a wet line dries at its rim, 0..1
  double streaks = 0.0;        ///< amount of dry-brush streaking, 0..1

  friend bool operator==(const MediumLook&, const MediumLook&) = default;
};

/// The sound of rubbing with the medium.
struct MediumSound {
  double loudness = 1.0;    ///< 0..1
  double brightness = 0.5;  ///< 0..1
  double squeak = 0.0;      ///< how easily it squeaks by stick-slip (chalk, felt-tip), 0..1

  friend bool operator==(const MediumSound&, const MediumSound&) = default;
};

/// The coefficient of friction of a medium on one surface. For surfaces without an entry,
/// friction_of() computes the coefficient.
struct PairFriction {
  std::string surface;  ///< id of the surface
  double coefficient = 0.25;

  friend bool operator==(const PairFriction&, const PairFriction&) = default;
};

/// A medium to draw or erase with: how it slides (docs/design/forces.md#friction), how its line
/// depends on force and tilt, how it looks on a relief, how it sounds, and how it stylises lines.
struct Medium {
  std::string id;                  ///< its name in strokes, documents and events: "pencil"
  std::string label;               ///< its name in the user interface: "Pencil"
  double friction = 0.25;          ///< coefficient of friction (mu) on paper
  double bristle_n_per_m = 600.0;  ///< stiffness of the friction model while the pen sticks
  double bristle_n_s_per_m = 2.0;  ///< damping of the friction model while the pen sticks
  double grain = 1.0;              ///< share of the surface's relief that the hand feels
  double wear = 0.0;  ///< share of the relief that a firm press flattens (relief_left), 0..1
  std::vector<PairFriction> pairs{};
  double strength = 1.0;  ///< multiplies every friction; set by tools, not stored
  /// A friction up to this one is not reduced by `strength`; set by tools, not stored.
  double kept_friction = 0.0;
  MediumLine line{};
  MediumLook look{};
  MediumSound sound{};
  MediumStyle style{};
  std::uint32_t color_rgb = 0x202020;  ///< its usual colour, 0xRRGGBB
  bool draws = true;                   ///< false for the eraser

  friend bool operator==(const Medium&, const Medium&) = default;
};

/// Returns the share of the relief that remains under a medium that fills or crushes it: 1 if the
/// user presses lightly, 1 - wear if the user presses firmly, linear in between. The same rule
/// applies to what the user feels and sees. For the force, `firmness` is the pressing force divided
/// by flattening_push_n() (haptics/bricks/drawing_feel.h), the force that flattens the relief as
/// far as the medium can. For the display it is the tone of the ink (render/grain.h), because a
/// stroke stores no other measure of the pressing force. Clamps both arguments to 0..1; NaN counts
/// as 0.
constexpr double relief_left(double wear, double firmness) noexcept {
  const auto share = [](double x) { return x > 0.0 ? (x < 1.0 ? x : 1.0) : 0.0; };
  return 1.0 - share(wear) * share(firmness);
}

/// How a surface sounds when it is rubbed, in addition to the sound of its relief.
struct SurfaceSound {
  double loudness = 1.0;    ///< 0..1, 0 is silent
  double brightness = 0.5;  ///< 0 dull (felt) .. 1 bright (glass)

  friend bool operator==(const SurfaceSound&, const SurfaceSound&) = default;
};

/// A surface to draw on (docs/design/forces.md#surfaces): its stiffness, its friction, and the
/// relief, which is the same in display, force and sound.
struct SurfaceMaterial {
  std::string id;     ///< its name in documents and events: "rough-paper"
  std::string label;  ///< its name in the user interface: "Rough paper"
  double stiffness_n_per_m = 500.0;
  double damping_n_s_per_m = 2.0;
  double friction = 0.25;  ///< mu of the pencil, the reference medium, on this surface
  /// RMS height and wavelength of its height field (docs/design/forces.md#texture); 0 means smooth.
  double grain_um = 0.0;
  double grain_mm = 0.0;
  HeightCharacter grain_character = HeightCharacter::kGrain;
  std::uint32_t grain_seed = 1;
  /// The custom relief if the character is kPicture; it is scaled to `grain_um` and `grain_mm`.
  std::shared_ptr<const HeightField> picture{};
  SurfaceSound sound{};
  std::uint32_t color_rgb = 0xFFFFFF;  ///< default colour, 0xRRGGBB; a page can have another

  /// Returns the parameters of the surface's relief.
  [[nodiscard]] HeightFieldSpec grain() const noexcept {
    return {grain_mm, grain_um, grain_seed, grain_character};
  }
  friend bool operator==(const SurfaceMaterial&, const SurfaceMaterial&) = default;
};

/// All surfaces and media, built-in and user-defined, by their ids. A value type; do not change it
/// while another thread reads it. The first surface is paper, and the first medium is the pencil.
class Materials {
 public:
  /// Returns the built-in surfaces (paper, rough-paper, watercolour, canvas, blackboard, felt,
  /// wood, glass) and media.
  static const Materials& built_in();

  [[nodiscard]] std::span<const SurfaceMaterial> surfaces() const noexcept { return surfaces_; }
  [[nodiscard]] std::span<const Medium> media() const noexcept { return media_; }
  /// Returns the material with this id, or null.
  [[nodiscard]] const SurfaceMaterial* find_surface(std::string_view id) const noexcept;
  [[nodiscard]] const Medium* find_medium(std::string_view id) const noexcept;

  /// Adds a material. If a material has the same id, replaces it and keeps its position.
  void put(SurfaceMaterial surface);
  void put(Medium medium);

 private:
  std::vector<SurfaceMaterial> surfaces_;
  std::vector<Medium> media_;
};

// Shorthands for surfaces(), find_surface() and find_medium() of Materials::built_in().
std::span<const SurfaceMaterial> surface_materials() noexcept;
/// Returns the built-in media without a style. A medium with a style feels and sounds like one of
/// them; it is at the end of Materials::built_in().media().
std::span<const Medium> media() noexcept;
const SurfaceMaterial* find_surface(std::string_view id) noexcept;
const Medium* find_medium(std::string_view id) noexcept;

/// Returns the colour of new ink on a surface (0xRRGGBB). This is `ink_rgb`, the usual colour of
/// the medium, unless it is hardly visible on the surface, like white chalk on white paper. Then it
/// is blue on a light surface, and nearly white on a dark one.
std::uint32_t ink_color_on(std::uint32_t ink_rgb, std::uint32_t surface_rgb) noexcept;

/// Returns the friction coefficient of a pair: the medium's entry for that surface if it has one,
/// otherwise mu_medium mu_surface / mu_paper (the `friction` of the medium, of the surface and of
/// the surface "paper"), at most kMaxFriction (docs/design/forces.md#surfaces), times the strength
/// of the medium.
double friction_of(const Medium& medium, const SurfaceMaterial& surface) noexcept;

}  // namespace felt
