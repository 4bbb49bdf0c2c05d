#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/height_field.h"

namespace felt {

/// The largest coefficient of friction, of pairs too: what a text may say, and what the rule for
/// pairs that nobody spoke of may come to. Rubber on rubber is about 1.
inline constexpr double kMaxFriction = 1.5;

/// How a line answers the hand. Lean is a share of 0..1 here (`lean_share`, geometry/lean.h).
///
///   width = (min + (max - min) p^gamma) (1 + (lean_width - 1) lean)
///   tone  = (tone_light + (tone_heavy - tone_light) p^tone_gamma) (1 + (lean_tone - 1) lean)
struct MediumLine {
  double min_mm = 0.3;  ///< its own range of widths: what the pencil is set to when it is taken
  double max_mm = 6.0;
  double gamma = 1.0;
  double lean_width = 1.0;  ///< width of a leaning pen, in widths of an upright one, >= 1
  double tone_light = 0.0;  ///< tone without pressure, 0..1
  double tone_heavy = 1.0;  ///< at full pressure
  double tone_gamma = 1.0;
  double lean_tone = 1.0;  ///< likewise of the tone: 0..1

  friend bool operator==(const MediumLine&, const MediumLine&) = default;
};

/// How it lies on the sheet, by its tone (WidthKnot::tone): what render/grain.h makes of a relief
/// counted in its own RMS.
struct MediumLook {
  double opacity_light = 1.0;  ///< of what is inked, at tone 0
  double opacity_heavy = 1.0;  ///< at tone 1
  double grain = 1.0;          ///< how much of the sheet's relief is seen; 0 for what is wet
  double cut_light = 0.35;     ///< what lies below so many RMS stays bare, at tone 0
  double cut_heavy = -2.6;     ///< at tone 1
  double soft = 0.9;           ///< half of the width of the edge of a grain, in RMS
  double crumb = 0.0;          ///< share of the medium's own coarseness: dust, crumbs; 0..1
  double crumb_mm = 0.3;       ///< its wavelength
  double edge = 0.0;           ///< how far the rim of the line is soft, in shares of its radius
  double rim = 0.0;            ///< how much darker (> 0) a wet line dries at its rim, 0..1
  double streaks = 0.0;        ///< how far a line falls apart into hairs along its way, 0..1

  friend bool operator==(const MediumLook&, const MediumLook&) = default;
};

/// What rubbing it sounds like.
struct MediumSound {
  double loudness = 1.0;    ///< 0..1
  double brightness = 0.5;  ///< 0..1
  double squeak = 0.0;      ///< 0..1: how readily stick and slip sing (chalk, felt-tip)

  friend bool operator==(const MediumSound&, const MediumSound&) = default;
};

/// mu measured or set for one pair; without one it is mu_medium mu_surface / mu_paper.
struct PairFriction {
  std::string surface;  ///< id
  double coefficient = 0.25;

  friend bool operator==(const PairFriction&, const PairFriction&) = default;
};

/// What is drawn, or rubbed out, with: how it slides (specification 5f), how its line answers force
/// and lean, how it looks on a relief, how it sounds.
struct Medium {
  std::string id;                  ///< "pencil": what strokes, documents and events say
  std::string label;               ///< "Pencil", for people
  double friction = 0.25;          ///< mu on paper
  double bristle_n_per_m = 600.0;  ///< stiffness of the friction before it slides
  double bristle_n_s_per_m = 2.0;
  double grain = 1.0;  ///< how much of the surface's relief the hand feels through it
  double wear = 0.0;   ///< share of the relief that a firm push flattens (relief_left); 0..1
  std::vector<PairFriction> pairs{};
  MediumLine line{};
  MediumLook look{};
  MediumSound sound{};
  std::uint32_t color_rgb = 0x202020;  ///< its usual colour, 0xRRGGBB
  bool draws = true;                   ///< false: the eraser

  friend bool operator==(const Medium&, const Medium&) = default;
};

/// What is left of the relief under a medium that fills, crushes or crumbles over it: 1 where it is
/// hardly touched, 1 - wear under a firm push, straight in between. One law for hand and eye. The
/// hand's `firmness` is its push in shares of that which flattens all of it (flattening_push_n in
/// haptics/drawing_feel.h, Texture); the eye's is the tone of the ink (render/grain.h), which is
/// all that a stroke remembers of the push. 0..1, clamped, as is wear; what is not a number is 0.
constexpr double relief_left(double wear, double firmness) noexcept {
  const auto share = [](double x) { return x > 0.0 ? (x < 1.0 ? x : 1.0) : 0.0; };
  return 1.0 - share(wear) * share(firmness);
}

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

/// Sheets and media by their ids: those that Feltline brings, and a person's own. A value;
/// immutable while anything reads it. The first sheet is paper, the first medium the pencil.
class Materials {
 public:
  /// paper, rough-paper, watercolour, canvas, blackboard, felt, wood, glass; and the media.
  static const Materials& built_in();

  [[nodiscard]] std::span<const SurfaceMaterial> surfaces() const noexcept { return surfaces_; }
  [[nodiscard]] std::span<const Medium> media() const noexcept { return media_; }
  /// By id, or null.
  [[nodiscard]] const SurfaceMaterial* find_surface(std::string_view id) const noexcept;
  [[nodiscard]] const Medium* find_medium(std::string_view id) const noexcept;

  /// Adds one, or replaces the one of that id in its place.
  void put(SurfaceMaterial surface);
  void put(Medium medium);

 private:
  std::vector<SurfaceMaterial> surfaces_;
  std::vector<Medium> media_;
};

// Of Materials::built_in().
std::span<const SurfaceMaterial> surface_materials() noexcept;
std::span<const Medium> media() noexcept;
const SurfaceMaterial* find_surface(std::string_view id) noexcept;
const Medium* find_medium(std::string_view id) noexcept;

/// Friction coefficient of a pair: the medium's own entry for that surface, else
/// mu_medium mu_surface / mu_paper (architecture section 10).
double friction_of(const Medium& medium, const SurfaceMaterial& surface) noexcept;

}  // namespace felt
