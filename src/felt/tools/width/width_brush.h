#pragma once

#include <span>
#include <vector>

#include "felt/tools/width/arc_places.h"
#include "felt/tools/width/profile_knots.h"

namespace felt {

/// Broadens and narrows a stroke around a place; a pure function of the stroke at the touch and of
/// what was added since. Only breakpoints of the width change, never the curve (specification 5h;
/// paper, "Change curve width"; R46).
///
/// An amount dW at u adds  dW S(way/reach) / S_u  to the profile, way along the arc, linear between
/// places 0.5 mm apart: this stands for the paper's splitting of width segments. S_u is the value
/// of that sum at u itself, so that W(u) changes by exactly dW, as 5h divides by (1-tw)^2 + tw^2.
/// Beyond the reach nothing changes. Widths stay between kMinWidthMm and the largest; ink that was
/// broader before may stay so.
class WidthBrush {
 public:
  static constexpr double kSpacingMm = 0.5;
  /// A short reach has places enough for its bump.
  static constexpr double kPlacesPerReach = 8.0;
  static constexpr double kToleranceMm = 0.01;

  /// Stroke and map must outlive this. Requires reach_mm > 0.
  WidthBrush(const Stroke& stroke, const ArcMap& map, double reach_mm, double max_width_mm);

  /// W(u) changes by amount_mm, as far as the limits allow; length_mm is where u is along the
  /// stroke. Bounded by the reach.
  void add(double u, double length_mm, double amount_mm);
  /// W(u) now.
  [[nodiscard]] double width_mm(double u, double length_mm) const;
  [[nodiscard]] double max_width_mm() const noexcept { return max_width_mm_; }
  /// The profile now: exact at the places `pinned` (u, ascending) and where nothing was added, else
  /// within kToleranceMm. Linear in the breakpoints and in the length of the stroke.
  [[nodiscard]] std::vector<WidthKnot> profile(std::span<const double> pinned) const;

 private:
  [[nodiscard]] double limited(double base_mm, double added_mm) const noexcept;
  [[nodiscard]] std::vector<WidthKnot> added_knots() const;

  const Stroke& stroke_;
  const ArcMap& map_;
  double reach_mm_;
  double max_width_mm_;
  ArcPlaces places_;
  std::vector<double> added_;  // by slot, mm
};

}  // namespace felt
