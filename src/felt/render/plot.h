#pragma once

#include <optional>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/render/image.h"
#include "felt/render/plot_trace.h"

namespace felt {

/// Colours that people with any colour vision tell apart (Okabe, Ito, "Color universal design",
/// 2008), in the order in which a plot should use them. `i` may be any number.
Rgba plot_color(std::size_t i) noexcept;

/// A stretch of time.
struct PlotSpan {
  double start_s = 0.0;
  double end_s = 1.0;
};

/// A signal with its name in the legend.
struct PlotLine {
  std::string name;
  Rgba color;
  PlotTrace trace;
  double width = 1.3;
};

/// A bound that signals keep to: a dashed line.
struct PlotLimit {
  std::string name;
  double value = 0.0;
};

/// Signals of one unit over time, in axes of their own.
struct PlotPanel {
  std::string title;
  std::string unit;
  std::vector<PlotLine> lines{};
  std::vector<PlotLimit> limits{};
  double height = 110.0;           ///< of the axes, in units of the plot
  bool from_zero = false;          ///< the axis begins at 0, whatever the smallest value
  std::optional<PlotSpan> span{};  ///< its own stretch of time; the plot's is marked in it
};

/// Panels, one below the other, that share a time axis (R53 and the issue of the command line:
/// pose, width and each force term over time).
struct Plot {
  std::string title;
  std::string note;  ///< a second, lighter line
  PlotSpan span;
  std::vector<PlotPanel> panels;
  /// Times at which this is above 0 are shaded in all panels.
  PlotTrace shade;
  std::string shade_name;
};

struct PlotOptions {
  double width = 900.0;  ///< of the picture, in units; text is 9 of them high
  double scale = 2.0;    ///< pixels a unit
};

/// Draws a plot. The same plot gives the same pixels. Text is ASCII. Error: no panel, a stretch of
/// time that is empty or not finite, a size that makes no sense or more pixels than
/// Image::kMaxPixels.
Result<Image> draw_plot(const Plot& plot, const PlotOptions& options = {});

}  // namespace felt
