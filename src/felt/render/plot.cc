#include "felt/render/plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "felt/render/plot_axis.h"
#include "felt/render/plot_canvas.h"

namespace felt {
namespace {

/// The range of a value axis.
struct PlotRange {
  double low = 0.0;
  double high = 1.0;
};

/// Draws one panel of a plot: maps times and values to points. Call its functions in this order.
class PlotPanelDrawing {
 public:
  /// The axes fill the rectangle from (x0, y0) to (x1, y0 + panel.height), in units.
  PlotPanelDrawing(PlotCanvas& canvas, const PlotPanel& panel, const Plot& plot, double x0,
                   double y0, double x1);

  /// Draws shades, grid, the numbers at the left, title and legend.
  void draw_background();
  /// Draws signals and limits.
  void draw_signals();
  /// Draws the times below the axes.
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

constexpr Rgba kText{38, 38, 42, 255};
constexpr Rgba kLightText{105, 105, 112, 255};
constexpr PlotPen kAxisPen{.width = 0.9, .color = {120, 120, 126, 255}};
constexpr Rgba kGrid{0, 0, 0, 22};
constexpr Rgba kZero{0, 0, 0, 70};
constexpr Rgba kShade{226, 205, 160, 78};
constexpr Rgba kMark{40, 90, 160, 34};
constexpr Rgba kLimit{190, 30, 45, 210};

constexpr double kTextSize = 7.6;
constexpr double kPanelTitleSize = 8.4;
constexpr int kTimeTicks = 10;
constexpr double kUnitsPerValueTick = 26.0;

int value_ticks(const PlotPanel& panel) {
  return std::max(2, static_cast<int>(panel.height / kUnitsPerValueTick));
}

/// Returns the range of all values in the panel, with a small margin.
PlotRange range_of(const PlotPanel& panel, const PlotSpan& span) {
  PlotTrace::Stretch all;
  const auto extend = [&all](double value) {
    all = all.empty() ? PlotTrace::Stretch{value, value}
                      : PlotTrace::Stretch{std::min(all.low, value), std::max(all.high, value)};
  };
  for (const PlotLine& line : panel.lines) {
    const PlotTrace::Stretch shown = line.trace.range(span.start_s, span.end_s);
    if (shown.empty()) continue;
    extend(shown.low);
    extend(shown.high);
  }
  for (const PlotLimit& limit : panel.limits) extend(limit.value);
  if (panel.from_zero) extend(0.0);
  if (all.empty()) return {0.0, 1.0};
  if (!(all.high > all.low)) return {all.low - 1.0, all.high + 1.0};
  const double air = 0.08 * (all.high - all.low);
  const bool on_zero = panel.from_zero && all.low == 0.0;
  return {all.low - (on_zero ? 0.0 : air), all.high + air};
}

PlotPanelDrawing::PlotPanelDrawing(PlotCanvas& canvas, const PlotPanel& panel, const Plot& plot,
                                   double x0, double y0, double x1)
    : canvas_(canvas),
      panel_(panel),
      plot_(plot),
      x0_(x0),
      y0_(y0),
      x1_(x1),
      span_(panel.span.value_or(plot.span)),
      range_(range_of(panel, span_)),
      values_(plot_ticks(range_.low, range_.high, value_ticks(panel))),
      times_(plot_ticks(span_.start_s, span_.end_s, kTimeTicks)) {}

double PlotPanelDrawing::x_of(double time_s) const noexcept {
  return x0_ + (x1_ - x0_) * (time_s - span_.start_s) / (span_.end_s - span_.start_s);
}

double PlotPanelDrawing::y_of(double value) const noexcept {
  return bottom() - panel_.height * (value - range_.low) / (range_.high - range_.low);
}

void PlotPanelDrawing::draw_background() {
  draw_shades();
  draw_grid();
  draw_heading();
}

void PlotPanelDrawing::draw_shades() {
  canvas_.clip(x0_, y0_, x1_, bottom());
  const PlotTrace& shade = plot_.shade;
  const auto is_on = [&shade](std::size_t i) { return !shade[i].empty() && shade[i].high > 0.0; };
  for (std::size_t i = 0; i < shade.size();) {
    std::size_t end = i;
    while (end < shade.size() && is_on(end)) ++end;
    if (end > i) {
      canvas_.rectangle(x_of(shade.time_s(i)), y0_, x_of(shade.time_s(end)), bottom(), kShade);
    }
    i = end + 1;
  }
  if (panel_.span) {
    canvas_.rectangle(x_of(plot_.span.start_s), y0_, x_of(plot_.span.end_s), bottom(), kMark);
  }
  canvas_.clip_nothing();
}

void PlotPanelDrawing::draw_grid() {
  for (const double time : times_.values) {
    canvas_.line({x_of(time), y0_}, {x_of(time), bottom()}, {.width = 0.6, .color = kGrid});
  }
  for (const double value : values_.values) {
    const double y = y_of(value);
    const bool is_zero = std::abs(value) < 0.5 * values_.step;
    canvas_.line({x0_, y}, {x1_, y},
                 {.width = is_zero ? 0.8 : 0.6, .color = is_zero ? kZero : kGrid});
    canvas_.line({x0_ - 3.0, y}, {x0_, y}, kAxisPen);
    canvas_.text({x0_ - 6.0, y + 0.45 * kTextSize}, values_.label(value),
                 {.size = kTextSize, .color = kText, .align = PlotAlign::kRight});
  }
  canvas_.line({x0_, y0_}, {x0_, bottom()}, kAxisPen);
  canvas_.line({x0_, bottom()}, {x1_, bottom()}, kAxisPen);
  canvas_.text_upwards({x0_ - 38.0, 0.5 * (y0_ + bottom())}, panel_.unit,
                       {.size = kTextSize, .color = kLightText, .align = PlotAlign::kCenter});
}

void PlotPanelDrawing::draw_heading() {
  const double y = y0_ - 6.0;
  canvas_.text({x0_, y}, panel_.title, {.size = kPanelTitleSize, .color = kText, .weight = 1.35});
  double x = x1_;
  for (std::size_t i = panel_.lines.size(); i-- > 0;) {
    const PlotLine& line = panel_.lines[i];
    if (line.name.empty()) continue;
    x -= canvas_.text_width(line.name, kTextSize);
    canvas_.text({x, y}, line.name, {.size = kTextSize, .color = kText});
    x -= 6.0;
    canvas_.line({x - 14.0, y - 0.4 * kTextSize}, {x, y - 0.4 * kTextSize},
                 {.width = 2.2, .color = line.color});
    x -= 14.0 + 14.0;
  }
}

void PlotPanelDrawing::draw_signals() {
  canvas_.clip(x0_, y0_ - 1.0, x1_, bottom() + 1.0);
  for (const PlotLimit& limit : panel_.limits) draw_limit(limit);
  for (const PlotLine& line : panel_.lines) draw_line(line);
  canvas_.clip_nothing();
}

void PlotPanelDrawing::draw_line(const PlotLine& line) {
  const PlotTrace& trace = line.trace;
  // Merges intervals until each is at least half a unit wide. Each merged interval becomes a
  // vertical line from its smallest to its largest value.
  const double column_s = 0.5 * (span_.end_s - span_.start_s) / (x1_ - x0_);
  const auto merged = static_cast<std::size_t>(std::max(1.0, column_s / trace.stretch_s()));
  std::vector<Vec> points;
  for (std::size_t i = 0; i < trace.size(); i += merged) {
    const std::size_t end = std::min(i + merged, trace.size());
    if (trace.time_s(end) < span_.start_s || trace.time_s(i) > span_.end_s) continue;
    const PlotTrace::Stretch column = trace.merged(i, end);
    if (column.empty()) {
      canvas_.polyline(points, {.width = line.width, .color = line.color});
      points.clear();
    } else {
      add_column(x_of(0.5 * (trace.time_s(i) + trace.time_s(end))), column, points);
    }
  }
  canvas_.polyline(points, {.width = line.width, .color = line.color});
}

/// Adds a vertical line. It begins at the end that is closer to the last point of the line.
void PlotPanelDrawing::add_column(double x, const PlotTrace::Stretch& column,
                                  std::vector<Vec>& points) const {
  Vec near{x, y_of(column.low)}, far{x, y_of(column.high)};
  if (!points.empty() && std::abs(points.back().y - far.y) < std::abs(points.back().y - near.y)) {
    std::swap(near, far);
  }
  points.push_back(near);
  if (far.y != near.y) points.push_back(far);
}

void PlotPanelDrawing::draw_limit(const PlotLimit& limit) {
  const double y = y_of(limit.value);
  canvas_.line({x0_, y}, {x1_, y}, {.width = 1.1, .color = kLimit, .on = 6.0, .off = 4.0});
  const bool below = y - y0_ < kTextSize + 5.0;  // the space above is too small
  canvas_.text({x1_ - 4.0, below ? y + kTextSize + 4.0 : y - 4.0}, limit.name,
               {.size = kTextSize - 0.6, .color = kLimit, .align = PlotAlign::kRight});
}

void PlotPanelDrawing::draw_times(bool with_name) {
  for (const double time : times_.values) {
    const double x = x_of(time);
    canvas_.line({x, bottom()}, {x, bottom() + 3.0}, kAxisPen);
    canvas_.text({x, bottom() + 5.0 + kTextSize}, times_.label(time),
                 {.size = kTextSize, .color = kText, .align = PlotAlign::kCenter});
  }
  if (!with_name) return;
  canvas_.text({0.5 * (x0_ + x1_), bottom() + 12.0 + 2.0 * kTextSize}, "time, s",
               {.size = kTextSize, .color = kLightText, .align = PlotAlign::kCenter});
}

constexpr Rgba kShadeKey{226, 205, 160, 150};

// Lengths in units of the plot.
constexpr double kLeft = 58.0;
constexpr double kRight = 18.0;
constexpr double kTop = 20.0;
constexpr double kHeading = 24.0;     // above the axes of a panel
constexpr double kTimesBelow = 20.0;  // times below a panel that has its own
constexpr double kBottom = 36.0;      // times and their name below the last one
constexpr double kTitleSize = 11.5;
constexpr double kNoteSize = 8.0;

double title_height(const Plot& plot) {
  double height = kTop;
  if (!plot.title.empty()) height += kTitleSize + 6.0;
  if (!plot.note.empty() || !plot.shade_name.empty()) height += kNoteSize + 8.0;
  return height;
}

double whole_height(const Plot& plot) {
  double height = title_height(plot) + kBottom;
  for (const PlotPanel& panel : plot.panels) {
    height += kHeading + panel.height + (panel.span ? kTimesBelow : 0.0);
  }
  return height;
}

bool is_sound(const PlotSpan& span) {
  return std::isfinite(span.start_s) && std::isfinite(span.end_s) && span.end_s > span.start_s;
}

Result<void> check(const Plot& plot, const PlotOptions& options) {
  if (plot.panels.empty())
    return fail(ErrorCode::kInvalidArgument, "a plot needs at least one panel");
  if (!(options.width >= 200.0 && options.width <= 1e5 && options.scale >= 0.1 &&
        options.scale <= 100.0)) {
    return fail(ErrorCode::kInvalidArgument,
                "a plot must be 200 to 100000 units wide, of 0.1 to 100 px");
  }
  bool sound = is_sound(plot.span);
  for (const PlotPanel& panel : plot.panels) {
    sound = sound && (!panel.span || is_sound(*panel.span));
    if (!(panel.height >= 20.0 && panel.height <= 1e5)) {
      return fail(ErrorCode::kInvalidArgument, "a panel must be 20 to 100000 units high");
    }
  }
  if (sound) return {};
  return fail(ErrorCode::kInvalidArgument, "the time range of the plot is empty");
}

void draw_titles(PlotCanvas& canvas, const Plot& plot, double width) {
  const PlotFont light{.size = kNoteSize, .color = kLightText};
  double y = kTop;
  if (!plot.title.empty()) {
    canvas.text({kLeft, y + kTitleSize - 4.0}, plot.title,
                {.size = kTitleSize, .color = kText, .weight = 1.3});
    y += kTitleSize + 6.0;
  }
  const double base = y + kNoteSize - 2.0;
  canvas.text({kLeft, base}, plot.note, light);
  if (plot.shade_name.empty()) return;
  const double x = width - kRight - canvas.text_width(plot.shade_name, kNoteSize);
  canvas.text({x, base}, plot.shade_name, light);
  canvas.rectangle(x - 22.0, base - kNoteSize - 1.0, x - 6.0, base + 1.0, kShadeKey);
}

}  // namespace

Rgba plot_color(std::size_t i) noexcept {
  constexpr std::array<Rgba, 7> kColors = {Rgba{0, 114, 178}, {213, 94, 0},  {0, 158, 115},
                                           {204, 121, 167},   {230, 159, 0}, {86, 180, 233},
                                           {70, 70, 70}};
  return kColors[i % kColors.size()];
}

Result<Image> draw_plot(const Plot& plot, const PlotOptions& options) {
  if (Result<void> fine = check(plot, options); !fine) return tl::unexpected(fine.error());
  const double height = whole_height(plot);
  const double width_px = std::ceil(options.width * options.scale);
  const double height_px = std::ceil(height * options.scale);
  if (width_px * height_px > static_cast<double>(Image::kMaxPixels)) {
    return fail(ErrorCode::kLimitExceeded, "the plot has too many pixels");
  }
  Result<Image> image = Image::create(static_cast<int>(width_px), static_cast<int>(height_px));
  if (!image) return image;
  const Pixels pixels = image->pixels();
  fill(pixels, pixels.rect(), {255, 255, 255, 255});
  PlotCanvas canvas(pixels, options.scale);
  draw_titles(canvas, plot, options.width);
  double y = title_height(plot);
  for (const PlotPanel& panel : plot.panels) {
    y += kHeading;
    PlotPanelDrawing drawing(canvas, panel, plot, kLeft, y, options.width - kRight);
    drawing.draw_background();
    drawing.draw_signals();
    const bool is_last = &panel == &plot.panels.back();
    if (is_last || panel.span) drawing.draw_times(is_last);
    y = drawing.bottom() + (panel.span ? kTimesBelow : 0.0);
  }
  return image;
}

}  // namespace felt
