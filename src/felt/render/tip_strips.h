#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/render/image.h"

namespace felt {

/// A dab of the tip of a medium, in pixels: its middle, and the tone there, 0..1.
struct TipAt {
  Vec center_px;
  double radius_px = 0.0;
  double tone = 1.0;
  /// Distance along the path of the tip, in widths of the line (TravelMeter). Only VisitMap uses
  /// it.
  double travel = 0.0;
};

/// Number of pixels that are processed together.
inline constexpr int kTipLanes = 8;

/// A line reaches this far beyond its radius, because its outermost pixels are covered only in
/// part.
inline constexpr double kRimPx = 1.0;
/// The tip counts as this much wider than its ink, so that on a hairline the pixels next to the
/// middle are not the rim.
inline constexpr double kSoftPx = 0.5;

/// The ink between two dabs, in single precision, and how to go through its rows of pixels.
/// Positions are relative to the strip's start, so that the numbers do not depend on where the
/// picture begins.
struct TipStrip {
  float dx = 0.0F, dy = 0.0F, len = 0.0F, per_length = 0.0F, low = 0.0F, high = 0.0F;
  float r0 = 0.0F, dr = 0.0F, tone0 = 0.0F, dtone = 0.0F;
  float taper = 0.0F;  // change of radius per length
  float travel0 = 0.0F, dtravel = 0.0F;
  float rest_x = 0.0F, rest_y = 0.0F, widest2 = 0.0F;
  int home_x = 0, home_y = 0;
  // Positions in x: the ends of the strip; its middle line at row 0, and the change of that per
  // row; half of the strip's extent in a row.
  double from = 0.0, to = 0.0, cut_x = 0.0, per_row = 0.0, reach = 0.0;
  bool is_steep = false, tapers = false;
  int y0 = 0, y1 = 0;
};

/// The pixels of a row that a strip may touch.
struct PixelSpan {
  int x0 = 0, x1 = 0;
};
inline PixelSpan span_in_row(const TipStrip& strip, int y, int x0, int x1) noexcept {
  double from = strip.from, to = strip.to;
  if (strip.is_steep) {  // only the part of the row within the strip's width
    const double middle = strip.cut_x + strip.per_row * y;
    from = from > middle - strip.reach ? from : middle - strip.reach;
    to = to < middle + strip.reach ? to : middle + strip.reach;
  }
  const int first = static_cast<int>(std::floor(from > -1e6 ? from : -1e6));
  const int last = static_cast<int>(std::ceil(to < 1e6 ? to : 1e6)) + 1;
  return {first > x0 ? first : x0, last < x1 ? last : x1};
}

/// Appends the strips of the path of a tip that reach into `area`, with straight lines from dab to
/// dab. If the path is a part of a closed stroke, `into` and `out` are the directions, of length 1,
/// in which the tip arrives at the path and leaves it. Without them the path begins and ends with a
/// cap.
void append_strips(std::span<const TipAt> path, Vec into, Vec out, PixelRect area,
                   std::vector<TipStrip>& strips);

}  // namespace felt
