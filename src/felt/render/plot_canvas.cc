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

#include <numbers>
#include <string>

namespace felt {
namespace {

/// AGG's own default of 1024 blocks drops what a long jagged line needs on a large picture.
constexpr unsigned kCellBlocks = 16384;

using Format = agg::pixfmt_rgba32_pre;

/// Of a letter's strokes, as a part of the height of a capital.
constexpr double kTextWeight = 0.125;
/// Width of a letter relative to the font's own proportion: a little narrower reads better.
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

  /// `turned` by a quarter to the left around the point.
  void text(Vec at, const std::string& string, double size, Rgba color, PlotAlign align,
            double weight, bool turned) {
    agg::gsv_text letters;
    letters.size(size * scale, size * scale * kTextNarrowing);
    letters.flip(true);
    letters.text(string.c_str());
    letters.start_point(offset_of(align, letters.text_width()), 0.0);
    agg::trans_affine place;
    if (turned) place *= agg::trans_affine_rotation(-0.5 * std::numbers::pi);
    place *= agg::trans_affine_translation(at.x * scale, at.y * scale);
    agg::conv_transform<agg::gsv_text> placed(letters, place);
    stroke(placed, kTextWeight * size * weight, color);
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

void PlotCanvas::line(Vec from, Vec to, double width, Rgba color) {
  const Vec points[] = {from, to};
  polyline(points, width, color);
}

void PlotCanvas::dashed(Vec from, Vec to, double width, Rgba color, double on, double off) {
  const double s = state_->scale;
  agg::path_storage& path = state_->path;
  path.remove_all();
  path.move_to(from.x * s, from.y * s);
  path.line_to(to.x * s, to.y * s);
  agg::conv_dash<agg::path_storage> dash(path);
  dash.add_dash(on * s, off * s);
  agg::conv_stroke<agg::conv_dash<agg::path_storage>> outline(dash);
  outline.width(width * s);
  state_->blend(outline, color);
}

void PlotCanvas::polyline(std::span<const Vec> points, double width, Rgba color) {
  if (points.size() < 2) return;
  agg::path_storage& path = state_->path;
  path.remove_all();
  bool first = true;
  for (const Vec& p : points) {
    const double x = p.x * state_->scale, y = p.y * state_->scale;
    first ? path.move_to(x, y) : path.line_to(x, y);
    first = false;
  }
  state_->stroke(path, width, color);
}

void PlotCanvas::text(Vec at, std::string_view text, double size, Rgba color, PlotAlign align,
                      double weight) {
  state_->text(at, std::string(text), size, color, align, weight, false);
}

void PlotCanvas::text_upwards(Vec at, std::string_view text, double size, Rgba color,
                              PlotAlign align) {
  state_->text(at, std::string(text), size, color, align, 1.0, true);
}

double PlotCanvas::text_width(std::string_view text, double size) const {
  agg::gsv_text letters;
  letters.size(size * state_->scale, size * state_->scale * kTextNarrowing);
  letters.text(std::string(text).c_str());
  return letters.text_width() / state_->scale;
}

}  // namespace felt
