#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "felt/geometry/lean.h"

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

}  // namespace felt
