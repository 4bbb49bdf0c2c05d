#include "felt/render/plot_canvas.h"

#include <agg2/agg_conv_dash.h>
#include <agg2/agg_conv_stroke.h>
#include <agg2/agg_conv_transform.h>
#include <agg2/agg_gsv_text.h>
#include <agg2/agg_path_storage.h>
#include <agg2/agg_pixfmt_rgba.h>
#include <agg2/agg_rasterizer_scanline_aa.h>
#include <agg2/agg_renderer_base.h>
#include <agg2/agg_renderer_scanline.h>
#include <agg2/agg_rendering_buffer.h>
#include <agg2/agg_scanline_u.h>
#include <agg2/agg_trans_affine.h>

#include <array>
#include <numbers>
#include <string>

namespace felt {
namespace {

/// AGG's default of 1024 blocks loses parts of a long jagged line on a large picture.
constexpr unsigned kCellBlocks = 16384;

using Format = agg::pixfmt_rgba32_pre;

/// Line width of a letter, as a fraction of the height of a capital.
constexpr double kTextWeight = 0.125;
/// Width of a letter relative to the font's own proportion. Letters that are slightly narrower are
/// easier to read.
constexpr double kTextNarrowing = 0.92;

agg::rgba8 to_agg(Rgba color) {
  agg::rgba8 c(color.r, color.g, color.b, color.a);
  return c.premultiply();
}

double offset_of(PlotAlign align, double width) {
  return align == PlotAlign::kLeft ? 0.0 : align == PlotAlign::kCenter ? -0.5 * width : -width;
}

}  // namespace

struct PlotCanvas::State {
  State(Pixels pixels, double px_per_unit)
      : buffer(pixels.data, static_cast<unsigned>(pixels.width),
               static_cast<unsigned>(pixels.height), static_cast<int>(pixels.stride)),
        format(buffer),
        renderer(format),
        scale(px_per_unit),
        area(pixels.rect()) {}

  template <class Path>
  void blend(Path& shape, Rgba color) {
    cells.reset();
    cells.add_path(shape);
    agg::render_scanlines_aa_solid(cells, scanline, renderer, to_agg(color));
  }

  template <class Source>
  void stroke(Source& source, double width, Rgba color) {
    agg::conv_stroke<Source> outline(source);
    outline.width(width * scale);
    outline.line_cap(agg::round_cap);
    outline.line_join(agg::round_join);
    blend(outline, color);
  }

  /// Draws text. `turn` is applied to the text before it is moved to `at`.
  void text(Vec at, std::string_view string, const PlotFont& font, agg::trans_affine turn) {
    agg::gsv_text letters;
    letters.size(font.size * scale, font.size * scale * kTextNarrowing);
    letters.flip(true);
    letters.text(std::string(string).c_str());
    letters.start_point(offset_of(font.align, letters.text_width()), 0.0);
    turn *= agg::trans_affine_translation(at.x * scale, at.y * scale);
    agg::conv_transform<agg::gsv_text> placed(letters, turn);
    stroke(placed, kTextWeight * font.size * font.weight, font.color);
  }

  agg::rendering_buffer buffer;
  Format format;
  agg::renderer_base<Format> renderer;
  agg::rasterizer_scanline_aa<agg::rasterizer_sl_clip_dbl> cells{kCellBlocks};
  agg::scanline_u8 scanline;
  agg::path_storage path;
  double scale;
  PixelRect area;
};

PlotCanvas::PlotCanvas(Pixels target, double scale)
    : state_(std::make_unique<State>(target, scale)) {
  clip_nothing();
}
PlotCanvas::~PlotCanvas() = default;

void PlotCanvas::clip(double x0, double y0, double x1, double y1) {
  const double s = state_->scale;
  state_->cells.clip_box(x0 * s, y0 * s, x1 * s, y1 * s);
}

void PlotCanvas::clip_nothing() {
  state_->cells.clip_box(0, 0, state_->area.x1, state_->area.y1);
}

void PlotCanvas::rectangle(double x0, double y0, double x1, double y1, Rgba color) {
  const double s = state_->scale;
  agg::path_storage& path = state_->path;
  path.remove_all();
  path.move_to(x0 * s, y0 * s);
  path.line_to(x1 * s, y0 * s);
  path.line_to(x1 * s, y1 * s);
  path.line_to(x0 * s, y1 * s);
  path.close_polygon();
  state_->blend(path, color);
}

void PlotCanvas::line(Vec from, Vec to, const PlotPen& pen) {
  const std::array<Vec, 2> points = {from, to};
  polyline(points, pen);
}

void PlotCanvas::polyline(std::span<const Vec> points, const PlotPen& pen) {
  if (points.size() < 2) return;
  const double s = state_->scale;
  agg::path_storage& path = state_->path;
  path.remove_all();
  path.move_to(points[0].x * s, points[0].y * s);
  for (const Vec& p : points.subspan(1)) path.line_to(p.x * s, p.y * s);
  if (pen.on > 0.0) {
    agg::conv_dash<agg::path_storage> dash(path);
    dash.add_dash(pen.on * s, pen.off * s);
    state_->stroke(dash, pen.width, pen.color);
  } else {
    state_->stroke(path, pen.width, pen.color);
  }
}

void PlotCanvas::text(Vec at, std::string_view text, const PlotFont& font) {
  state_->text(at, text, font, agg::trans_affine());
}

void PlotCanvas::text_upwards(Vec at, std::string_view text, const PlotFont& font) {
  state_->text(at, text, font, agg::trans_affine_rotation(-0.5 * std::numbers::pi));
}

double PlotCanvas::text_width(std::string_view text, double size) const {
  agg::gsv_text letters;
  letters.size(size * state_->scale, size * state_->scale * kTextNarrowing);
  letters.text(std::string(text).c_str());
  return letters.text_width() / state_->scale;
}

}  // namespace felt
