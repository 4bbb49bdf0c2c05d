#pragma once

#include "felt/geometry/point.h"

namespace felt {

inline constexpr double kMmPerInch = 25.4;

/// Which place of the sheet a picture shows, and how large.
struct View {
  Point origin_mm;         ///< what lies at the top left corner of the top left pixel
  double px_per_mm = 1.0;  ///< more is closer; > 0

  /// A picture of `dpi` dots per inch that begins at `origin_mm`.
  static constexpr View at_dpi(Point origin_mm, double dpi) noexcept {
    return {origin_mm, dpi / kMmPerInch};
  }
  /// Pixel coordinates of a place.
  [[nodiscard]] constexpr Vec to_px(Point p) const noexcept { return px_per_mm * (p - origin_mm); }
  /// The place at pixel coordinates.
  [[nodiscard]] constexpr Point to_mm(Vec px) const noexcept { return origin_mm + px / px_per_mm; }
};

}  // namespace felt
