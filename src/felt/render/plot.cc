#include "felt/render/plot.h"

#include <array>
#include <cmath>

#include "felt/render/plot_panel.h"

namespace felt {
namespace {

constexpr Rgba kText{38, 38, 42, 255};
constexpr Rgba kLightText{105, 105, 112, 255};
constexpr Rgba kShadeKey{226, 205, 160, 150};

// Units.
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
  if (plot.panels.empty()) return fail(ErrorCode::kInvalidArgument, "a plot without a panel");
  if (!(options.width >= 200.0 && options.width <= 1e5 && options.scale >= 0.1 &&
        options.scale <= 100.0)) {
    return fail(ErrorCode::kInvalidArgument,
                "a plot is 200 to 100000 units wide, of 0.1 to 100 px");
  }
  bool sound = is_sound(plot.span);
  for (const PlotPanel& panel : plot.panels) {
    sound = sound && (!panel.span || is_sound(*panel.span));
    if (!(panel.height >= 20.0 && panel.height <= 1e5)) {
      return fail(ErrorCode::kInvalidArgument, "a panel is 20 to 100000 units high");
    }
  }
  if (sound) return {};
  return fail(ErrorCode::kInvalidArgument, "a plot over a stretch of time that is empty");
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
