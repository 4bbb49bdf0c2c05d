#pragma once

#include <string_view>

#include "felt/geometry/height_field.h"

namespace felt {

/// The relief of the sheet for the eye (paper, "future work"; specification 5i; R47): dry ink lies
/// on the hills and leaves the valleys bare, and the harder it is pressed on, the deeper it goes.
///
///   alpha = smoothstep((r - h_cut(p)) / soft),   r = h(x) + tooth (h(4.3 x) + h(8.3 x))
///
/// h is the very height that the hand feels at x. The tooth is the same map again at finer scales:
/// grain shorter than 1 mm cannot be given to a hand at 1 kHz, stable and strong enough to be felt
/// (specification, decision 10), but an eye misses it. r is counted in its own RMS, so that paper
/// of 3 um and a blackboard of 11 um are alike grainy; the wavelength differs. h_cut falls from a
/// light line, of which the hills alone are seen, to a heavy one that is nearly solid. Towards the
/// edge of a line, where the tip presses less, it rises.
class Grain {
 public:
  /// `field` must outlive this; null is smooth.
  explicit Grain(const HeightField* field = nullptr) noexcept : field_(field) {}

  /// Share of the ink that is seen at a place, 0..1, pressed on with p in 0..1. `share`: how much
  /// of the grain the material lets through, 0 for none.
  [[nodiscard]] double alpha(Point place, double pressure, double share) const noexcept;
  /// r in its RMS.
  [[nodiscard]] double relief(Point place) const noexcept;
  /// What it looks at: the same function of the same object that a Texture feels.
  [[nodiscard]] HeightField::Sample at(Point place) const noexcept;
  [[nodiscard]] bool is_smooth() const noexcept;

 private:
  const HeightField* field_;
};

/// How much of the grain a material of strokes lets through: pencil and chalk all, crayon, which is
/// wax and fills, less; felt-tip and all others, which are wet, none.
double grain_share(std::string_view material) noexcept;

/// How hard a line was pressed on, by its width: 0 at the pencil's thinnest of 0.3 mm, 1 at its
/// broadest of 6 mm. A stroke keeps its width and not the pressure.
double pressure_of_width(double width_mm) noexcept;

}  // namespace felt
