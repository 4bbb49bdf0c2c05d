#pragma once

#include "felt/render/plot.h"
#include "felt/render/plot_axis.h"
#include "felt/render/plot_canvas.h"

namespace felt {

/// What a value axis shows.
struct PlotRange {
  double low = 0.0;
  double high = 1.0;
};

/// One panel of a plot while it is drawn: knows where times and values lie. Drawn in this order.
class PlotPanelDrawing {
 public:
  /// The axes fill the rectangle from (x0, y0) to (x1, y0 + panel.height), in units.
  PlotPanelDrawing(PlotCanvas& canvas, const PlotPanel& panel, const Plot& plot, double x0,
                   double y0, double x1);

  /// Shades, grid, the numbers at the left, title and legend above.
  void draw_background();
  /// Signals and limits.
  void draw_signals();
  /// Times below the axes.
  void draw_times(bool with_name);

  [[nodiscard]] double bottom() const noexcept { return y0_ + panel_.height; }

 private:
  [[nodiscard]] double x_of(double time_s) const noexcept;
  [[nodiscard]] double y_of(double value) const noexcept;
  void draw_shades();
  void draw_grid();
  void draw_heading();
  void draw_line(const PlotLine& line);
  void add_column(double x, const PlotTrace::Stretch& column, std::vector<Vec>& points) const;
  void draw_limit(const PlotLimit& limit);

  PlotCanvas& canvas_;
  const PlotPanel& panel_;
  const Plot& plot_;
  double x0_, y0_, x1_;
  PlotSpan span_;
  PlotRange range_;
  PlotTicks values_, times_;
};

}  // namespace felt
