#pragma once

#include <vector>

#include "felt/tools/width/arc_places.h"
#include "felt/tools/width/profile_knots.h"

namespace felt {

/// Replaces the width of the parts of a stroke that a pen has drawn along
/// (docs/design/editing.md#retrace). The result is a pure function of the stroke at the touch and
/// the pen's path.
///
/// The width is sampled at places that are 0.25 mm apart, and is linear between them. In the part
/// between the first and the last point that the pen reached, each place has the width that was
/// drawn there last. Over 2 mm at both ends of that part, the width blends smoothly into the old
/// width, except at an end of the stroke. Within 1 mm of the pen the width is the mean over 2 mm,
/// because there newer widths meet older ones of the same gesture. Elsewhere the profile stays bit
/// for bit.
class WidthRetrace {
 public:
  static constexpr double kSpacingMm = 0.25;
  static constexpr double kToleranceMm = 0.05;
  static constexpr double kBlendMm = 2.0;
  /// If a trace comes within kEndMm of the end of an open stroke, it extends to the end.
  static constexpr double kEndMm = 1.0;
  /// Steps shorter than kStepMm are ignored, so that the lift of the pen leaves no thin spot.
  static constexpr double kStepMm = 0.1;

  /// `stroke` and `map` must outlive this object.
  WidthRetrace(const Stroke& stroke, const ArcMap& map);

  /// Moves the pen to this arc length without drawing.
  void jump(double length_mm, double width_mm);
  /// Continues to draw by a signed arc length along the stroke.
  void go(double way_mm, double width_mm);

  /// Returns true if something was drawn.
  [[nodiscard]] bool has_drawn() const noexcept { return has_drawn_; }
  /// Return the arc lengths at which the drawn part begins and ends. On a closed stroke the first
  /// may lie before the seam and the second beyond it.
  [[nodiscard]] double first_mm() const noexcept { return first_mm_; }
  [[nodiscard]] double last_mm() const noexcept { return last_mm_; }
  /// Returns the new profile, in time linear in the breakpoints and the length of the stroke.
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
  std::vector<double> base_lengths_;         // arc lengths of the stroke's own breakpoints
  std::vector<double> drawn_;                // by slot; NaN if not drawn
  double at_mm_ = 0.0;                       // unwrapped arc length of the pen
  double mark_mm_ = 0.0, mark_width_ = 0.0;  // end of the last step
  double first_mm_ = 0.0, last_mm_ = 0.0;
  bool has_drawn_ = false;
};

}  // namespace felt
