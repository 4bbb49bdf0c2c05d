#pragma once

#include <span>
#include <string>
#include <string_view>

#include "felt/geometry/point.h"
#include "felt/render/plot_canvas.h"

namespace felt::cli {

/// Draws what PlotCanvas draws as elements of an SVG, in the units of the element around them.
class SvgCanvas {
 public:
  /// Appends the elements to `out`, which must outlive this.
  explicit SvgCanvas(std::string& out) : out_(out) {}

  /// Draws connected lines. Draws nothing for fewer than two points.
  void polyline(std::span<const Vec> points, const PlotPen& pen);
  /// Draws one line of text with `at` on its base line. A font with a large weight is a halo.
  void text(Vec at, std::string_view text, const PlotFont& font);
  /// Returns about the length of a text: that of DejaVu Sans.
  [[nodiscard]] static double text_width(std::string_view text, double size) noexcept;

 private:
  std::string& out_;
};

}  // namespace felt::cli
