#include "chart.h"

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/document/visible_strokes.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/render/page_painter.h"
#include "felt/render/plot_canvas.h"
#include "felt/session/player.h"
#include "felt/stroke/color_text.h"

namespace felt::bench {
namespace {

constexpr double kDpi = 200.0;
constexpr double kRowMm = 29.0;    // height of the row of one surface
constexpr double kLabelMm = 16.0;  // width of the labels on the left
constexpr double kHeadMm = 6.0;    // height of the heading
constexpr double kWidthMm = 203.0;
constexpr double kMarginMm = 4.5;  // margin of a cell on the left and on the right
constexpr double kForcesN[] = {0.25, 0.7, 1.6};

Rgba color_of(std::uint32_t rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16U), static_cast<std::uint8_t>(rgb >> 8U),
          static_cast<std::uint8_t>(rgb), 255};
}

void add(std::vector<Event>& events, double t_s, decltype(Event::what) what) {
  events.push_back({std::llround(1e9 * t_s), std::move(what)});
}

/// Adds a wavy line that starts at `t_s`. The hand aims `depth_mm` below the surface, which sets
/// its force. Returns the time at which the line ends.
double add_stroke(std::vector<Event>& events, double t_s, Point from, double line_mm,
                  double depth_mm) {
  constexpr double kHoverMm = 4.0, kSpeed = 60.0;
  add(events, t_s, HandEvent{{from.x, from.y, kHoverMm}, {}, 0});
  add(events, t_s + 0.5, HandEvent{{from.x, from.y, kHoverMm}, {}, 0});
  add(events, t_s + 0.7, HandEvent{{from.x, from.y, -depth_mm}, {}, 0});
  const double start_s = t_s + 0.8;
  const auto wave = [](double x) { return 1.6 * std::sin(0.42 * x); };
  for (int i = 0; i <= 60; ++i) {
    const double x = line_mm * i / 60.0;
    add(events, start_s + x / kSpeed, HandEvent{{from.x + x, from.y + wave(x), -depth_mm}, {}, 0});
  }
  const double end_s = start_s + line_mm / kSpeed;
  add(events, end_s + 0.15, HandEvent{{from.x + line_mm, from.y + wave(line_mm), kHoverMm}, {}, 0});
  return end_s + 0.4;
}

/// Sets the pencil tool's options for a medium.
void take(std::vector<Event>& events, double t_s, const Medium& medium, Rgba color) {
  add(events, t_s, SetOption{"pencil.medium", OptionValue(medium.id)});
  add(events, t_s, SetOption{"ink.color", OptionValue(color_to_text(color))});
  add(events, t_s, SetOption{"pencil.min_width_mm", OptionValue(medium.line.min_mm)});
  add(events, t_s, SetOption{"pencil.max_width_mm", OptionValue(medium.line.max_mm)});
  add(events, t_s, SetOption{"pencil.gamma", OptionValue(medium.line.gamma)});
}

Result<Document> draw_row(const SurfaceMaterial& surface, std::span<const Medium* const> media,
                          double cell_mm) {
  StylusPreset device = *find_stylus_preset("omega");
  device.capabilities.workspace_min = {-20.0, -20.0, -20.0};
  device.capabilities.workspace_max = {kWidthMm + 20.0, kRowMm + 20.0, 20.0};
  SimulatedStylus stylus(device, typical_hand());
  Session session(make_tools(), {.device = device.capabilities});
  std::vector<Event> events;
  add(events, 0.0, SetOption{"surface.material", OptionValue(surface.id)});
  add(events, 0.0, SetOption{"pencil.snap", OptionValue(std::string("off"))});
  const double area = plane_for(surface, device.capabilities).stiffness_n_per_m;
  double t_s = 0.6;
  double left = kMarginMm;
  for (const Medium* medium : media) {
    take(events, t_s, *medium, color_of(ink_color_on(medium->color_rgb, surface.color_rgb)));
    double y = 5.0;
    for (const double force_n : kForcesN) {
      const double depth = 1e3 * force_n * (1.0 / area + 1.0 / typical_hand().stiffness_n_per_m);
      t_s = add_stroke(events, t_s, {left, y}, cell_mm - 2.0 * kMarginMm, depth) + 0.3;
      y += 8.5;
    }
    left += cell_mm;
  }
  Player player(stylus, &stylus, session, {});
  const Result<PlayReport> report = player.play(events);
  if (!report) return tl::unexpected(report.error());
  return session.document();
}

void copy(const Image& from, Pixels to, int x0, int y0) {
  for (int y = 0; y < from.height() && y0 + y < to.height; ++y) {
    for (int x = 0; x < from.width() && x0 + x < to.width; ++x) {
      const Rgba pixel = from.at(x, y);
      std::uint8_t* p = to.data + (y0 + y) * to.stride + 4 * (x0 + x);
      p[0] = pixel.r;
      p[1] = pixel.g;
      p[2] = pixel.b;
      p[3] = pixel.a;
    }
  }
}

int px(double mm) {
  return static_cast<int>(std::lround(mm * kDpi / 25.4));
}

}  // namespace

Result<Image> draw_chart(std::span<const std::string_view> ids) {
  std::vector<const Medium*> media;
  for (const std::string_view id : ids) {
    media.push_back(find_medium(id));
    if (media.back() == nullptr) return fail(ErrorCode::kNotFound, std::string(id));
  }
  const double cell_mm = (kWidthMm - kLabelMm) / static_cast<double>(media.size());
  const double rows = static_cast<double>(surface_materials().size());
  auto chart = Image::create(px(kWidthMm), px(kHeadMm + kRowMm * rows));
  if (!chart) return chart;
  fill(chart->pixels(), chart->pixels().rect(), {255, 255, 255, 255});
  const PlotFont font{.size = 12.0, .color = {40, 44, 52, 255}, .weight = 1.4};
  PlotFont middle = font;
  middle.align = PlotAlign::kCenter;
  const auto write = [&](double x_mm, double y_mm, std::string_view text, const PlotFont& in) {
    PlotCanvas(chart->pixels(), 1.0).text({px(x_mm) + 0.0, px(y_mm) + 0.0}, text, in);
  };
  double x = kLabelMm + 0.5 * cell_mm;
  for (const Medium* medium : media) {
    write(x, 0.7 * kHeadMm, medium->label, middle);
    x += cell_mm;
  }
  double top = kHeadMm;
  for (const SurfaceMaterial& surface : surface_materials()) {
    const Result<Document> drawn = draw_row(surface, media, cell_mm);
    if (!drawn) return tl::unexpected(drawn.error());
    PageOptions page{.dpi = kDpi};
    page.area = Rect{0.0, 0.0, kWidthMm - kLabelMm, kRowMm - 0.5};
    page.paper = color_of(surface.color_rgb);
    page.grain = Grain(surface_grain(surface));
    const Result<Image> row = render_page(visible_strokes(*drawn), page);
    if (!row) return row;
    copy(*row, chart->pixels(), px(kLabelMm), px(top));
    // Writes one word per line.
    const std::size_t space = surface.label.find(' ');
    write(1.0, top + 0.47 * kRowMm, surface.label.substr(0, space), font);
    if (space != std::string::npos) {
      write(1.0, top + 0.47 * kRowMm + 3.2, surface.label.substr(space + 1), font);
    }
    top += kRowMm;
  }
  return chart;
}

}  // namespace felt::bench
