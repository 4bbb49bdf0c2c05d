#pragma once

#include <span>
#include <vector>

#include "felt/tools/width/arc_places.h"
#include "felt/tools/width/profile_knots.h"

namespace felt {

/// Broadens and narrows a stroke around a point. The result is a pure function of the stroke at the
/// touch and of the amounts added since then. Changes only breakpoints of the width, never the
/// curve (docs/design/editing.md#width-brush; paper, "Change curve width"; R46).
///
/// An amount dW at u adds dW S(s/reach) / S_u to the profile. Here s is the arc length from u, and
/// S is bump() of brush_bump.h. S is evaluated at places about 0.5 mm apart (less if the reach is
/// short) and is linear between them; this replaces the paper's splitting of width segments. S_u is
/// the interpolated value of S at u itself, so that W(u) changes by exactly dW; the paper's
/// division by (1-tw)^2 + tw^2 has the same effect. Beyond the reach nothing changes. Widths stay
/// between kMinWidthMm and max_width_mm; ink that was already broader than max_width_mm does not
/// get broader, but may keep its width.
class WidthBrush {
 public:
  static constexpr double kSpacingMm = 0.5;
  /// Minimum number of places per reach, so that a short reach can represent its bump.
  static constexpr double kPlacesPerReach = 8.0;
  static constexpr double kToleranceMm = 0.01;

  /// `stroke` and `map` must outlive this object. Requires reach_mm > 0.
  WidthBrush(const Stroke& stroke, const ArcMap& map, double reach_mm, double max_width_mm);

  /// Changes W(u) by amount_mm, as far as the limits allow. length_mm is the arc length at u. Takes
  /// time linear in the reach.
  void add(double u, double length_mm, double amount_mm);
  /// Returns the current W(u).
  [[nodiscard]] double width_mm(double u, double length_mm) const;
  [[nodiscard]] double max_width_mm() const noexcept { return max_width_mm_; }
  /// Returns the current profile. It is exact at the parameters `pinned` (ascending) and in parts
  /// where nothing was added, and within kToleranceMm elsewhere. Takes time linear in the
  /// breakpoints and the length of the stroke.
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
