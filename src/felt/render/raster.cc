#include "felt/render/raster.h"

#include <agg2/agg_pixfmt_rgba.h>
#include <agg2/agg_rasterizer_scanline_aa.h>
#include <agg2/agg_renderer_base.h>
#include <agg2/agg_renderer_scanline.h>
#include <agg2/agg_rendering_buffer.h>
#include <agg2/agg_scanline_u.h>

#include <algorithm>

namespace felt {
namespace {

/// AGG silently drops what exceeds its limit of 4096-cell blocks; 64 million cells are the edge
/// pixels of any stroke on the largest picture.
constexpr unsigned kCellBlocks = 16384;

/// Clips in floating point, so that no coordinate overflows AGG's integers.
using Cells = agg::rasterizer_scanline_aa<agg::rasterizer_sl_clip_dbl>;

template <class Format>
void blend(Cells& cells, agg::scanline_u8& line, PixelRect clip, Rgba color, Pixels target) {
  agg::rendering_buffer buffer(target.data, static_cast<unsigned>(target.width),
                               static_cast<unsigned>(target.height),
                               static_cast<int>(target.stride));
  Format format(buffer);
  agg::renderer_base<Format> renderer(format);
  renderer.clip_box(clip.x0, clip.y0, clip.x1 - 1, clip.y1 - 1);
  agg::rgba8 ink(color.r, color.g, color.b, color.a);
  agg::render_scanlines_aa_solid(cells, line, renderer, ink.premultiply());
}

/// A rectangle around the ink, not the smallest one, in a fraction of the time of that.
Rect rough_bounds(const Stroke& stroke) noexcept {
  Rect area;
  for (const Point& p : stroke.data().points) area.extend(p);
  double widest = 0.0;
  for (const WidthKnot& k : stroke.widths()) widest = std::max(widest, k.width_mm);
  return area.inflated(0.5 * widest);
}

}  // namespace

struct Rasterizer::State {
  Cells cells{kCellBlocks};
  agg::scanline_u8 line;
  StrokeOutliner outliner;
};

Rasterizer::Rasterizer() : state_(std::make_unique<State>()) {}
Rasterizer::~Rasterizer() = default;
Rasterizer::Rasterizer(Rasterizer&&) noexcept = default;
Rasterizer& Rasterizer::operator=(Rasterizer&&) noexcept = default;

void Rasterizer::fill(const Outline& outline, const View& view, PixelRect clip, Rgba color,
                      Pixels target) {
  const PixelRect part = clip.intersected(target.rect());
  if (part.empty() || color.a == 0) return;
  Cells& cells = state_->cells;
  cells.reset();
  cells.clip_box(part.x0, part.y0, part.x1, part.y1);
  cells.filling_rule(agg::fill_non_zero);
  for (std::size_t k = 0; k < outline.contour_count(); ++k) {
    bool first = true;
    for (Point p : outline.contour(k)) {
      const Vec px = view.to_px(p);
      first ? cells.move_to_d(px.x, px.y) : cells.line_to_d(px.x, px.y);
      first = false;
    }
    cells.close_polygon();
  }
  if (target.order == PixelOrder::kRgba) {
    blend<agg::pixfmt_rgba32_pre>(cells, state_->line, part, color, target);
  } else {
    blend<agg::pixfmt_bgra32_pre>(cells, state_->line, part, color, target);
  }
}

void Rasterizer::draw(const Stroke& stroke, const View& view, PixelRect clip, Pixels target) {
  const PixelRect part = clip.intersected(target.rect());
  Rect shown;
  shown.extend(view.to_mm({static_cast<double>(part.x0), static_cast<double>(part.y0)}));
  shown.extend(view.to_mm({static_cast<double>(part.x1), static_cast<double>(part.y1)}));
  if (part.empty() || !shown.intersects(rough_bounds(stroke))) return;
  fill(state_->outliner.trace(stroke, kRasterTolerancePx / view.px_per_mm), view, part,
       stroke.color(), target);
}

}  // namespace felt
