#pragma once

#include <array>
#include <cstddef>

#include "felt/stroke/outline/outline.h"

namespace felt::npm {

/// What getStroke() does with one end of a stroke.
struct PenTip {
  /// The number of equal parts of the taper between the values of `share`.
  static constexpr std::size_t kSteps = 16;

  double taper_mm = 0.0;  ///< arc length of the taper, 0 for none
  bool is_flat = false;   ///< true to cut the cap off, false for a round cap
  /// The share of the width at 0, 1/16, ..., 1 of the taper, counted from the end of the stroke.
  std::array<double, kSteps + 1> share{};

  /// Returns the share of the width at a point that is `distance_mm` away from this end.
  [[nodiscard]] double share_at(double distance_mm) const noexcept;
};

/// What getStroke() does with both ends.
struct PenLook {
  PenTip start, end;

  /// Reads both tips: taper_mm, is_flat and the 17 shares of the start, then those of the end.
  static PenLook from_numbers(const double* numbers) noexcept;
};

/// Returns the outline of an open stroke with its ends changed. Has one contour.
Outline pen_outline(const Stroke& stroke, const PenLook& look, double tolerance_mm);

}  // namespace felt::npm
