#include "felt/render/raster.h"

#include <agg2/agg_pixfmt_rgba.h>
#include <agg2/agg_rasterizer_scanline_aa.h>
#include <agg2/agg_renderer_base.h>
#include <agg2/agg_renderer_scanline.h>
#include <agg2/agg_rendering_buffer.h>
#include <agg2/agg_scanline_u.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "felt/render/pressure_map.h"
#include "felt/render/segment_runs.h"

namespace felt {
namespace {

/// AGG silently drops what exceeds its limit of 4096-cell blocks; 64 million cells are the edge
/// pixels of any stroke on the largest picture.
constexpr unsigned kCellBlocks = 16384;

/// Of the tolerance, for the centre line: as much as StrokeOutliner gives it.
constexpr double kTraceShare = 0.5;

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

/// What of the sheet a part of a picture shows, and two pixels more.
Rect shown_by(PixelRect part, const View& view) noexcept {
  return view.area_mm({part.x0 - 2.0, part.y0 - 2.0}, {part.x1 + 2.0, part.y1 + 2.0});
}

/// The pixels that a stroke may touch.
PixelRect pixels_of(const Stroke& stroke, const View& view, PixelRect clip) noexcept {
  const Rect area = view.area_px(rough_bounds(stroke));
  const Vec from{area.x0, area.y0}, to{area.x1, area.y1};
  const auto whole = [](double px, int least, int most) {
    return static_cast<int>(std::clamp(px, static_cast<double>(least), static_cast<double>(most)));
  };
  return {whole(std::floor(from.x) - 1.0, clip.x0, clip.x1),
          whole(std::floor(from.y) - 1.0, clip.y0, clip.y1),
          whole(std::ceil(to.x) + 1.0, clip.x0, clip.x1),
          whole(std::ceil(to.y) + 1.0, clip.y0, clip.y1)};
}

/// Ink with alpha 0..1 over a premultiplied pixel.
void blend_over(std::uint8_t* pixel, PixelOrder order, Rgba color, double alpha) noexcept {
  const bool rgba = order == PixelOrder::kRgba;
  const double source[4] = {static_cast<double>(rgba ? color.r : color.b),
                            static_cast<double>(color.g),
                            static_cast<double>(rgba ? color.b : color.r), 255.0};
  for (int k = 0; k < 4; ++k) {
    const double mixed = alpha * source[k] + (1.0 - alpha) * pixel[k];
    pixel[k] = static_cast<std::uint8_t>(std::clamp(mixed + 0.5, 0.0, 255.0));
  }
}

}  // namespace

struct Rasterizer::State {
  /// Rows that are worked on at a time, so that the masks of a large stroke stay small.
  static constexpr int kBandRows = 128;

  Cells cells{kCellBlocks};
  agg::scanline_u8 line;
  StrokeOutliner outliner;
  SegmentRuns runs;
  std::vector<Dab> dabs, more_dabs;
  Outline joined;
  std::vector<std::uint8_t> mask;  // RGBA; its alpha is the coverage
  PressureMap pressure;
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

/// The outline of what a stroke inks in `shown`; of a stroke that lies there as a whole, its own.
const Outline& Rasterizer::trace_near(const Stroke& stroke, const View& view, const Rect& shown) {
  State& s = *state_;
  const double tolerance_mm = kRasterTolerancePx / view.px_per_mm;
  s.runs.find(stroke, shown);
  if (s.runs.is_whole(stroke)) return s.outliner.trace(stroke, tolerance_mm);
  s.joined.clear();
  const auto& runs = s.runs.runs();
  // Of a ring the last run goes on with the first.
  const bool goes_round = stroke.closed() && runs.size() > 1 && runs.front().first == 0 &&
                          runs.back().last == stroke.segment_count();
  for (std::size_t i = goes_round ? 1 : 0; i < runs.size(); ++i) {
    flatten(stroke, runs[i].first, runs[i].last, kTraceShare * tolerance_mm, s.dabs);
    if (goes_round && i + 1 == runs.size()) {
      flatten(stroke, 0, runs.front().last, kTraceShare * tolerance_mm, s.more_dabs);
      s.dabs.insert(s.dabs.end(), s.more_dabs.begin(), s.more_dabs.end());
    }
    const Outline& part = s.outliner.trace(s.dabs, false, tolerance_mm);
    const std::size_t size = s.joined.points.size();
    s.joined.points.insert(s.joined.points.end(), part.points.begin(), part.points.end());
    for (const std::size_t end : part.ends) s.joined.ends.push_back(size + end);
  }
  return s.joined;
}

void Rasterizer::draw(const Stroke& stroke, const View& view, PixelRect clip, Pixels target) {
  const PixelRect part = clip.intersected(target.rect());
  if (part.empty()) return;
  const Rect shown = shown_by(part, view);
  if (!shown.intersects(rough_bounds(stroke))) return;
  fill(trace_near(stroke, view, shown), view, part, stroke.color(), target);
}

void Rasterizer::draw_center_line(const Stroke& stroke, const View& view, PixelRect clip,
                                  double width_px, Pixels target) {
  const PixelRect part = clip.intersected(target.rect());
  if (part.empty() || !shown_by(part, view).intersects(rough_bounds(stroke))) return;
  State& s = *state_;
  const double tolerance_mm = kRasterTolerancePx / view.px_per_mm;
  flatten(stroke, kTraceShare * tolerance_mm, s.dabs);
  for (Dab& dab : s.dabs) dab.radius_mm = 0.5 * width_px / view.px_per_mm;
  const Rgba color = stroke.color();
  fill(s.outliner.trace(s.dabs, stroke.closed(), tolerance_mm), view, part,
       {color.r, color.g, color.b, 255}, target);
}

void Rasterizer::draw(const Stroke& stroke, const View& view, PixelRect clip, const Grain& grain,
                      Pixels target) {
  const double share = grain_share(stroke.material());
  if (grain.is_smooth() || !(share > 0.0)) return draw(stroke, view, clip, target);
  const PixelRect part = pixels_of(stroke, view, clip.intersected(target.rect()));
  if (part.empty() || stroke.color().a == 0) return;
  const Outline& outline = trace_near(stroke, view, shown_by(part, view));
  const double opacity = stroke.color().a / (255.0 * 255.0);
  for (int top = part.y0; top < part.y1; top += State::kBandRows) {
    const PixelRect band{part.x0, top, part.x1, std::min(part.y1, top + State::kBandRows)};
    std::vector<std::uint8_t>& mask = state_->mask;
    mask.assign(std::size_t{4} * static_cast<std::size_t>(band.width()) *
                    static_cast<std::size_t>(band.height()),
                0);
    const Pixels coverage{mask.data(), band.width(), band.height(),
                          std::ptrdiff_t{4} * band.width(), PixelOrder::kRgba};
    const View shifted = view.from({static_cast<double>(band.x0), static_cast<double>(band.y0)});
    fill(outline, shifted, coverage.rect(), {255, 255, 255, 255}, coverage);
    state_->pressure.make(stroke, view, band);
    for (int y = band.y0; y < band.y1; ++y) {
      for (int x = band.x0; x < band.x1; ++x) {
        const std::uint8_t covered =
            coverage.data[(y - band.y0) * coverage.stride + std::ptrdiff_t{4} * (x - band.x0) + 3];
        if (covered == 0) continue;
        const double seen = grain.alpha(view.to_mm({x + 0.5, y + 0.5}),
                                        static_cast<double>(state_->pressure.at(x, y)), share);
        blend_over(target.data + y * target.stride + std::ptrdiff_t{4} * x, target.order,
                   stroke.color(), opacity * covered * seen);
      }
    }
  }
}

}  // namespace felt
