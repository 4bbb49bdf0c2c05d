#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "felt/material/materials.h"
#include "felt/render/pressure_map.h"
#include "felt/render/relief_texture.h"
#include "felt/render/view.h"
#include "felt/render/visit_map.h"

namespace felt {

/// How much of a relief is visible: `depth` is the factor of its height (Grain: d); `kept` and
/// `crumb_kept` are the fractions of the variance of relief and dust that pixels of this size can
/// show.
struct SeenRelief {
  double depth = 0.0;
  double kept = 1.0;
  double crumb_kept = 1.0;
};

/// Returns alpha of Grain's formula, 0..1, for r = `relief`, the weighted height of relief and
/// dust. `blur` is the RMS of the part of r that is too fine to see; the result is the mean over
/// that part.
double ink_alpha(const MediumLook& look, double wear, double push, double relief,
                 double blur) noexcept;

/// Weights of relief, dust and hairs in r; their squares add up to 1. `all` is G of Grain's
/// formula.
struct ReliefWeights {
  double surface = 0.0, crumb = 0.0, hairs = 0.0;
  double all = 0.0;
};
ReliefWeights relief_weights(const MediumLook& look) noexcept;

/// The look of a medium on a surface at one scale, as tables. An InkLook is immutable, so any
/// thread may use it.
struct InkLook {
  InkLook(const MediumLook& look, double wear, const SeenRelief& seen);

  static constexpr int kReliefs = 256;
  /// Alpha, indexed by the step of push (PressureMap::row_of), then by the height of the relief:
  /// index 128 is height 0, and 32 steps are one RMS.
  std::vector<std::uint8_t> alphas;
  std::array<std::uint16_t, 64> rim{};                     ///< factor of alpha in 1/256, by rho^2
  std::array<std::int16_t, PressureMap::kAcross> hairs{};  ///< height by position, in 1/32 RMS
  int surface_weight = 0, crumb_weight = 0, hair_weight = 0;  ///< in 1/256
  bool has_rim = false;
  /// True for dry media: tone builds up where a stroke crosses itself (VisitMap).
  bool builds_up = false;
  double edge = 0.0;
  std::shared_ptr<const ReliefLevel> surface, crumb;  ///< null if not visible
  double surface_tile_mm = 1.0, crumb_tile_mm = 1.0;
};

/// Gives the pixels of lines in a view the look of their medium. Requires that `look` outlives it.
class InkShade {
 public:
  InkShade(const InkLook& look, const View& view);
  /// Multiplies the alphas of `count` pixels, which begin at (x, y), by the fraction of the ink
  /// that is visible at each pixel. Where the tip visited a pixel several times, blends the visits
  /// like strokes above each other.
  void row(const PressureMap& pressure, const VisitMap& visits, int x, int y, int count,
           std::uint8_t* alphas) const noexcept;

 private:
  void build_up(const VisitMap& visits, int x, int y, int count, const int* reliefs,
                std::uint8_t* alphas) const noexcept;

  const InkLook* look_;
  ReliefPlane surface_, crumb_;
};

}  // namespace felt
