#pragma once

#include <vector>

#include "felt/tools/width/arc_places.h"
#include "felt/tools/width/profile_knots.h"

namespace felt {

/// Replaces the width of a stroke where a pen has drawn along it (peers.md, "redraw width"); a pure
/// function of the stroke at the touch and of the pen's way.
///
/// Between the first and the last place reached, the width is what was drawn there last, linear
/// between places 0.25 mm apart. Over 2 mm at both ends it goes over into the old one by S(x),
/// unless that is where the stroke ends; around the place where newer ink meets older of the same
/// trace the mean over 2 mm is taken. Outside, the profile stays bit for bit.
class WidthRetrace {
 public:
  static constexpr double kSpacingMm = 0.25;
  static constexpr double kToleranceMm = 0.05;
  static constexpr double kBlendMm = 2.0;
  /// A trace that comes this near to the end of an open stroke goes up to it.
  static constexpr double kEndMm = 1.0;
  /// Less than this is no way: a pen that is lifted leaves no thin place.
  static constexpr double kStepMm = 0.1;

  /// Both must outlive this.
  WidthRetrace(const Stroke& stroke, const ArcMap& map);

  /// The pen is here now without having drawn on the way.
  void jump(double length_mm, double width_mm);
  /// It has drawn on by a signed way along the stroke.
  void go(double way_mm, double width_mm);

  /// True once something was drawn.
  [[nodiscard]] bool has_drawn() const noexcept { return has_drawn_; }
  /// Lengths between which it was; the second may lie beyond the seam, the first before it.
  [[nodiscard]] double first_mm() const noexcept { return first_mm_; }
  [[nodiscard]] double last_mm() const noexcept { return last_mm_; }
  /// Linear in the breakpoints and in the length of the stroke.
  [[nodiscard]] std::vector<WidthKnot> profile() const;

 private:
  void mark(double from_mm, double from_width_mm, double to_mm, double to_width_mm);
  [[nodiscard]] double share_at(double length_mm) const noexcept;
  [[nodiscard]] double drawn_at(long k) const noexcept;
  [[nodiscard]] double drawn_between(double length_mm) const noexcept;
  [[nodiscard]] std::vector<ProfileKnot> new_knots() const;

  const Stroke& stroke_;
  const ArcMap& map_;
  ArcPlaces places_;
  std::vector<double> base_lengths_;         // of the stroke's own breakpoints
  std::vector<double> drawn_;                // by slot; NaN where the pen was not
  double at_mm_ = 0.0;                       // unwrapped
  double mark_mm_ = 0.0, mark_width_ = 0.0;  // where the last step ended
  double first_mm_ = 0.0, last_mm_ = 0.0;
  bool has_drawn_ = false;
};

}  // namespace felt
