#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "felt/geometry/point.h"
#include "felt/render/image.h"

namespace felt {

/// Horizontal alignment of a text relative to its point.
enum class PlotAlign { kLeft, kCenter, kRight };

/// Style of a line. `on` and `off` are the lengths of dashes and gaps, 0 for none.
struct PlotPen {
  double width = 1.0;
  Rgba color;
  double on = 0.0;
  double off = 0.0;
};

/// Style of a text. `size` is the height of a capital letter; `weight` makes its strokes wider.
struct PlotFont {
  double size = 8.0;
  Rgba color;
  PlotAlign align = PlotAlign::kLeft;
  double weight = 1.0;
};

/// Draws the lines and plain ASCII text of plots into a picture, in units of `scale` pixels, with x
/// to the right and y down. Text is drawn as strokes, so it needs no installed font and looks the
/// same everywhere.
class PlotCanvas {
 public:
  /// Requires that `target` outlives it.
  PlotCanvas(Pixels target, double scale);
  ~PlotCanvas();
  PlotCanvas(const PlotCanvas&) = delete;
  PlotCanvas& operator=(const PlotCanvas&) = delete;

  /// Restricts drawing to this rectangle until the next call.
  void clip(double x0, double y0, double x1, double y1);
  /// Allows drawing in the whole picture again.
  void clip_nothing();

  void rectangle(double x0, double y0, double x1, double y1, Rgba color);
  void line(Vec from, Vec to, const PlotPen& pen);
  /// Draws connected lines. Draws nothing for fewer than two points.
  void polyline(std::span<const Vec> points, const PlotPen& pen);
  /// Draws one line of text with `at` on its base line.
  void text(Vec at, std::string_view text, const PlotFont& font);
  /// Draws one line of text rotated to read upwards, with `at` on its base line.
  void text_upwards(Vec at, std::string_view text, const PlotFont& font);
  /// Returns the length of a text.
  [[nodiscard]] double text_width(std::string_view text, double size) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace felt
