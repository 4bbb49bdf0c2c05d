#pragma once

#include <optional>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/render/image.h"
#include "felt/render/plot_trace.h"

namespace felt {

/// Returns colour `i` of a palette that people with any kind of colour vision can distinguish
/// (Okabe, Ito, "Color universal design", 2008). A plot should use the colours in this order. The
/// palette repeats, so `i` may be any number.
Rgba plot_color(std::size_t i) noexcept;

/// An interval of time.
struct PlotSpan {
  double start_s = 0.0;
  double end_s = 1.0;
};

/// A signal with its name for the legend.
struct PlotLine {
  std::string name;
  Rgba color;
  PlotTrace trace;
  double width = 1.3;
};

/// A limit on signals, drawn as a dashed line.
struct PlotLimit {
  std::string name;
  double value = 0.0;
};

/// Signals of the same unit over time, with their own axes.
struct PlotPanel {
  std::string title;
  std::string unit;
  std::vector<PlotLine> lines{};
  std::vector<PlotLimit> limits{};
  double height = 110.0;           ///< height of the axes, in units of the plot
  bool from_zero = false;          ///< start the axis at 0, even if the smallest value is larger
  std::optional<PlotSpan> span{};  ///< the panel's own time interval, if any; the
                                   ///< interval of the plot is marked in it
};

/// Panels below each other that share a time axis, for example pose, width and each force term over
/// time (R53).
struct Plot {
  std::string title;
  std::string note;  ///< a second line in a lighter colour
  PlotSpan span;
  std::vector<PlotPanel> panels;
  /// All panels are shaded at the times at which this signal is above 0.
  PlotTrace shade;
  std::string shade_name;
};

struct PlotOptions {
  double width = 900.0;  ///< width of the picture, in units; text is 9 units high
  double scale = 2.0;    ///< pixels per unit
};

/// Draws a plot. The same plot gives the same pixels. Text is ASCII. Fails if the plot has no
/// panel, if a time interval is empty or not finite, or if the size is invalid or more than
/// Image::kMaxPixels.
Result<Image> draw_plot(const Plot& plot, const PlotOptions& options = {});

}  // namespace felt
