#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "felt/geometry/point.h"
#include "felt/render/image.h"

namespace felt {

/// Where a text stands relative to the point it is given.
enum class PlotAlign { kLeft, kCenter, kRight };

/// How a line looks: `on` and `off` are the lengths of dashes and gaps, 0 for none.
struct PlotPen {
  double width = 1.0;
  Rgba color;
  double on = 0.0;
  double off = 0.0;
};

/// How a text looks: `size` is the height of a capital letter, `weight` makes its strokes broader.
struct PlotFont {
  double size = 8.0;
  Rgba color;
  PlotAlign align = PlotAlign::kLeft;
  double weight = 1.0;
};

/// The pen that plots are drawn with: lines and plain ASCII text into a picture, in units that are
/// `scale` pixels each, x right, y down. Text is made of strokes, so it needs no font of the
/// machine and looks the same everywhere.
class PlotCanvas {
 public:
  /// Draws into `target`, which must outlive it.
  PlotCanvas(Pixels target, double scale);
  ~PlotCanvas();
  PlotCanvas(const PlotCanvas&) = delete;
  PlotCanvas& operator=(const PlotCanvas&) = delete;

  /// Nothing is drawn outside this rectangle until it is set again.
  void clip(double x0, double y0, double x1, double y1);
  /// The whole picture again.
  void clip_nothing();

  void rectangle(double x0, double y0, double x1, double y1, Rgba color);
  void line(Vec from, Vec to, const PlotPen& pen);
  /// Joined lines; fewer than two points are nothing.
  void polyline(std::span<const Vec> points, const PlotPen& pen);
  /// One line of text whose base line runs through `at`.
  void text(Vec at, std::string_view text, const PlotFont& font);
  /// The same, turned so that it reads upwards; `at` is on its base line.
  void text_upwards(Vec at, std::string_view text, const PlotFont& font);
  /// How long a text is.
  [[nodiscard]] double text_width(std::string_view text, double size) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace felt
