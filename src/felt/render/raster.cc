#include "felt/render/raster.h"

#include <agg2/agg_pixfmt_rgba.h>
#include <agg2/agg_rasterizer_scanline_aa.h>
#include <agg2/agg_renderer_base.h>
#include <agg2/agg_renderer_scanline.h>
#include <agg2/agg_rendering_buffer.h>
#include <agg2/agg_scanline_u.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "felt/render/ink_look.h"
#include "felt/render/pressure_map.h"
#include "felt/render/segments_in_area.h"
#include "felt/render/stroke_measures.h"
#include "felt/render/styled_outline.h"
#include "felt/render/tip_travel.h"
#include "felt/render/visit_map.h"
#include "felt/render/wide_vectors.h"

namespace felt {
namespace {

/// AGG silently drops cells beyond its limit of 4096-cell blocks. 64 million cells are the edge
/// pixels of any stroke on the largest picture.
constexpr unsigned kRasterCellBlocks = 16384;

/// Fraction of the tolerance for the centre line, the same as in StrokeOutliner.
constexpr double kTraceShare = 0.5;

/// Largest distance between the path of a tip and its approximation; the look of a medium is soft.
constexpr double kWayTolerancePx = 0.25;

/// The rasterizer of AGG. It clips in floating point, so that no coordinate overflows AGG's
/// integers.
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

/// Returns a rectangle around the ink. It is not the smallest one, but much faster to compute.
Rect rough_bounds(const Stroke& stroke) noexcept {
  Rect area;
  for (const Point& p : stroke.data().points) area.extend(p);
  double widest = 0.0;
  for (const WidthKnot& k : stroke.widths()) widest = std::max(widest, k.width_mm);
  return area.inflated(0.5 * widest);
}

/// Returns the area of the page that a part of a picture shows, with a margin of two pixels.
Rect shown_by(PixelRect part, const View& view) noexcept {
  return view.area_mm({part.x0 - 2.0, part.y0 - 2.0}, {part.x1 + 2.0, part.y1 + 2.0});
}

/// Returns the pixels that a stroke with these bounds may touch.
PixelRect pixels_of(const Rect& bounds, const View& view, PixelRect clip) noexcept {
  const Rect area = view.area_px(bounds);
  const Vec from{area.x0, area.y0}, to{area.x1, area.y1};
  const auto whole = [](double px, int smallest, int largest) {
    return static_cast<int>(
        std::clamp(px, static_cast<double>(smallest), static_cast<double>(largest)));
  };
  return {whole(std::floor(from.x) - 1.0, clip.x0, clip.x1),
          whole(std::floor(from.y) - 1.0, clip.y0, clip.y1),
          whole(std::ceil(to.x) + 1.0, clip.x0, clip.x1),
          whole(std::ceil(to.y) + 1.0, clip.y0, clip.y1)};
}

constexpr unsigned over_255(unsigned product) noexcept {  // rounded
  return (product + 128U + ((product + 128U) >> 8U)) >> 8U;
}

/// Selects every other byte of a pixel, so that each has 16 bits of space.
constexpr std::uint32_t kEveryOther = 0x00FF00FFU;

/// Blends two channels of ink over two of a pixel, each as in over_255. The alpha of the ink and
/// the weight of the pixel add up to 255, so no sum exceeds 255 * 255, and no channel overflows
/// into the next.
constexpr std::uint32_t over_two(std::uint32_t ink, std::uint32_t alpha,
                                 std::uint32_t under) noexcept {
  const std::uint32_t sum = ink * alpha + under * (255U - alpha) + 0x00800080U;
  return ((sum + ((sum >> 8U) & kEveryOther)) >> 8U) & kEveryOther;
}

/// Blends ink with these alphas over premultiplied pixels. `ink` is one pixel of the ink.
FELT_WIDE_VECTORS void blend_row(std::uint8_t* __restrict pixels, std::uint32_t ink,
                                 unsigned opacity, const std::uint8_t* __restrict alphas,
                                 int count) noexcept {
  const std::uint32_t even = ink & kEveryOther, odd = (ink >> 8U) & kEveryOther;
  for (int x = 0; x < count; ++x) {
    const std::uint32_t alpha = over_255(opacity * alphas[x]);
    std::uint32_t under = 0;
    std::memcpy(&under, pixels + std::ptrdiff_t{4} * x, 4);
    const std::uint32_t over = over_two(even, alpha, under & kEveryOther) |
                               over_two(odd, alpha, (under >> 8U) & kEveryOther) << 8U;
    std::memcpy(pixels + std::ptrdiff_t{4} * x, &over, 4);
  }
}

/// Returns a pixel of solid ink.
std::uint32_t solid(Rgba color, PixelOrder order) noexcept {
  const bool rgba = order == PixelOrder::kRgba;
  return std::bit_cast<std::uint32_t>(std::array<std::uint8_t, 4>{rgba ? color.r : color.b, color.g,
                                                                  rgba ? color.b : color.r, 255});
}

}  // namespace

struct Rasterizer::State {
  /// Rows that are processed at a time, so that the map of a large stroke stays small.
  static constexpr int kBandRows = 64;
  static constexpr std::size_t kMaxLooks = 32;
  /// A piece of the tip's path. If it is a part of a ring, `into` and `out` are the directions of
  /// the tip before and after it.
  struct Way {
    std::vector<TipAt> tips;
    std::vector<std::size_t> ends;  // the last dab of each segment
    Vec into, out;
  };

  /// Returns true if the last run of a closed stroke continues with the first.
  [[nodiscard]] bool goes_round(const Stroke& stroke) const noexcept {
    const auto& found = runs.runs();
    return stroke.closed() && found.size() > 1 && found.front().first == 0 &&
           found.back().last == stroke.segment_count();
  }
  /// Computes the path of the stroke's tip, in pixels, in the runs that trace_near() found last.
  void walk(const Stroke& stroke, const View& view);
  /// Sets TipAt::travel of the paths of walk(), and `ring_travel`. Its time depends only on these
  /// paths, not on the whole stroke, if `measures` has kept the stroke.
  void measure(const Stroke& stroke, const View& view);
  /// Adds the lines of the hatching to the paths of walk().
  void walk_hatching(const View& view);
  /// Computes the push in a band of rows from the paths of walk(), and the visits if the look
  /// builds up.
  void lay_tip(PixelRect band, const InkLook& look);
  /// Shades the scanline that was swept last, and blends it over `part` of the target.
  void blend_line(const InkShade& shade, PixelRect part, std::uint32_t ink, std::uint8_t alpha,
                  Pixels target);

  std::optional<PixelRect> window;
  Cells cells{kRasterCellBlocks};
  agg::scanline_u8 line;
  StrokeOutliner outliner;
  std::optional<StrokeStyler> styler;  // made for the first stroke with a style
  const StyledInk* styled = nullptr;   // of the stroke that is drawn, if it has a style
  SegmentsInArea runs;
  std::vector<Dab> dabs, more_dabs;
  Outline joined;
  PressureMap pressure;
  VisitMap visits;
  std::vector<Way> ways;
  StrokeMeasures measures;
  double ring_travel = 0.0;  // of a closed stroke
  Grain grain;               // the grain of the cached looks
  double looks_px_per_mm = 0.0;
  std::vector<std::pair<std::string, std::shared_ptr<const InkLook>>> looks;
};

void Rasterizer::State::walk(const Stroke& stroke, const View& view) {
  const std::size_t count = runs.runs().size();
  ways.resize(count);
  for (std::size_t n = 0; n < count; ++n) {
    const SegmentRun& run = runs.runs()[n];
    flatten(stroke, run.first, run.last, kWayTolerancePx / view.px_per_mm, dabs, ways[n].ends);
    ways[n].into = ways[n].out = {};
    ways[n].tips.clear();
    for (const Dab& dab : dabs) {
      ways[n].tips.push_back({view.to_px(dab.center), view.px_per_mm * dab.radius_mm, dab.tone});
    }
  }
  if (!stroke.closed() || !(runs.is_whole(stroke) || goes_round(stroke))) return;
  const std::vector<TipAt>&first = ways.front().tips, &last = ways.back().tips;
  const auto direction = [](const TipAt& from, const TipAt& to) {
    const Vec way = to.center_px - from.center_px;
    const double length = norm(way);
    return length > 0.0 ? way / length : Vec{};
  };
  ways.front().into = direction(last[last.size() - 2], last.back());
  ways.back().out = direction(first[0], first[1]);
}

void Rasterizer::State::walk_hatching(const View& view) {
  const std::vector<Dab>& lines = styled->hatching;
  for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
    Way& way = ways.emplace_back();
    for (const Dab& dab : {lines[i], lines[i + 1]}) {
      way.tips.push_back({view.to_px(dab.center), view.px_per_mm * dab.radius_mm, dab.tone});
    }
  }
}

void Rasterizer::State::measure(const Stroke& stroke, const View& view) {
  const std::span<const double> travels = measures.travels(stroke, view.px_per_mm);
  ring_travel = stroke.closed() ? travels.back() : 0.0;
  for (std::size_t n = 0; n < runs.runs().size(); ++n) {
    const std::span<TipAt> tips = ways[n].tips;
    auto segment = static_cast<std::size_t>(runs.runs()[n].first);
    std::size_t first = 0;
    for (const std::size_t end : ways[n].ends) {
      set_travel(tips.subspan(first, end + 1 - first), travels[segment],
                 travels[segment + 1] - travels[segment]);
      first = end;
      ++segment;
    }
  }
}

void Rasterizer::State::lay_tip(PixelRect band, const InkLook& look) {
  pressure.begin(band, look.edge);
  for (const Way& way : ways) pressure.lay(way.tips, way.into, way.out);
  look.builds_up ? visits.find(pressure, ring_travel) : visits.clear();
}

void Rasterizer::State::blend_line(const InkShade& shade, PixelRect part, std::uint32_t ink,
                                   std::uint8_t alpha, Pixels target) {
  std::uint8_t* row = target.data + line.y() * target.stride;
  const auto* span = line.begin();
  for (unsigned left = line.num_spans(); left > 0; --left, ++span) {
    const int from = std::max<int>(span->x, part.x0);
    const int count = std::min(span->x + span->len, part.x1) - from;
    if (count <= 0) continue;
    std::uint8_t* alphas = span->covers + (from - span->x);
    shade.row(pressure, visits, from, line.y(), count, alphas);
    blend_row(row + std::ptrdiff_t{4} * from, ink, alpha, alphas, count);
  }
}

Rasterizer::Rasterizer() : state_(std::make_unique<State>()) {}
Rasterizer::~Rasterizer() = default;
Rasterizer::Rasterizer(Rasterizer&&) noexcept = default;
Rasterizer& Rasterizer::operator=(Rasterizer&&) noexcept = default;

void Rasterizer::set_window(std::optional<PixelRect> window) noexcept {
  state_->window = window;
}

PixelRect Rasterizer::visible(PixelRect part) const noexcept {
  return state_->window ? part.intersected(*state_->window) : part;
}

void Rasterizer::fill(const Outline& outline, const View& view, PixelRect clip, Rgba color,
                      Pixels target) {
  const PixelRect part = clip.intersected(target.rect());
  if (visible(part).empty() || color.a == 0) return;
  load(outline, view, part);
  blend_loaded(visible(part), color, target);
}

/// Blends the coverage that was loaded last in one colour.
void Rasterizer::blend_loaded(PixelRect part, Rgba color, Pixels target) {
  Cells& cells = state_->cells;
  if (target.order == PixelOrder::kRgba) {
    blend<agg::pixfmt_rgba32_pre>(cells, state_->line, part, color, target);
  } else {
    blend<agg::pixfmt_bgra32_pre>(cells, state_->line, part, color, target);
  }
}

/// Loads the outline as cells of its coverage within a part.
void Rasterizer::load(const Outline& outline, const View& view, PixelRect part) {
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
}

/// Returns the outline of the segments of a stroke that may ink `shown`.
const Outline& Rasterizer::trace_near(const Stroke& stroke, const View& view, const Rect& shown) {
  State& s = *state_;
  const double tolerance_mm = kRasterTolerancePx / view.px_per_mm;
  s.measures.use(stroke);
  s.runs.find(s.measures.areas(), shown);
  if (s.runs.is_whole(stroke)) return s.outliner.trace(stroke, tolerance_mm);
  s.joined.clear();
  const auto& runs = s.runs.runs();
  const bool goes_round = s.goes_round(stroke);
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

const Outline& Rasterizer::trace_ink(const Stroke& stroke, const StrokeStyle* style,
                                     const View& view, const Rect& shown) {
  State& s = *state_;
  s.styled = nullptr;
  if (!style) return trace_near(stroke, view, shown);
  s.measures.use(stroke);
  s.runs.find(s.measures.areas(), shown);
  if (!s.styler) s.styler.emplace();
  s.styled = &s.styler->ink(stroke, *style, kRasterTolerancePx / view.px_per_mm);
  return s.styled->outline;
}

void Rasterizer::draw(const Stroke& stroke, const View& view, PixelRect clip, Pixels target) {
  const PixelRect part = clip.intersected(target.rect());
  if (visible(part).empty()) return;
  if (!shown_by(visible(part), view).intersects(rough_bounds(stroke))) return;
  fill(trace_near(stroke, view, shown_by(part, view)), view, part, stroke.color(), target);
}

void Rasterizer::draw_fill(const Fill& fill, const View& view, PixelRect clip, Pixels target) {
  const PixelRect part = clip.intersected(target.rect());
  if (visible(part).empty() || fill.color.a == 0) return;
  if (!shown_by(visible(part), view).intersects(fill_bounds(fill))) return;
  State& s = *state_;
  flatten_fill(fill, kRasterTolerancePx / view.px_per_mm, s.joined);
  load(s.joined, view, part);
  s.cells.filling_rule(agg::fill_even_odd);
  blend_loaded(visible(part), fill.color, target);
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

/// Returns the look of the stroke's medium. Caches looks, because the medium is usually that of the
/// stroke before.
const InkLook* Rasterizer::look_of(const Stroke& stroke, const View& view, const Grain& grain) {
  State& s = *state_;
  if (!(grain == s.grain) || view.px_per_mm != s.looks_px_per_mm) {
    s.looks.clear();
    s.grain = grain;
    s.looks_px_per_mm = view.px_per_mm;
  }
  const auto found = std::find_if(s.looks.begin(), s.looks.end(), [&](const auto& known) {
    return known.first == stroke.medium();
  });
  if (found != s.looks.end()) return found->second.get();
  if (s.looks.size() >= State::kMaxLooks) s.looks.clear();
  s.looks.emplace_back(stroke.medium(), grain.look(stroke.medium(), view.px_per_mm));
  return s.looks.back().second.get();
}

void Rasterizer::draw(const Stroke& stroke, const View& view, PixelRect clip, const Grain& grain,
                      Pixels target) {
  const InkLook* look = grain.is_plain() ? nullptr : look_of(stroke, view, grain);
  const StrokeStyle* style = grain.styles().find(stroke.medium());
  if (look == nullptr && !style) return draw(stroke, view, clip, target);
  const Rect bounds = rough_bounds(stroke);
  const PixelRect part = pixels_of(bounds, view, clip.intersected(target.rect()));
  const PixelRect seen = visible(part);
  if (seen.empty() || stroke.color().a == 0) return;
  if (!shown_by(seen, view).intersects(bounds)) return;
  State& s = *state_;
  load(trace_ink(stroke, style, view, shown_by(part, view)), view, part);
  if (look == nullptr) return blend_loaded(seen, stroke.color(), target);
  if (!s.cells.rewind_scanlines()) return;
  s.line.reset(s.cells.min_x(), s.cells.max_x());
  s.walk(stroke, view);
  if (style) s.walk_hatching(view);
  if (look->builds_up) s.measure(stroke, view);
  const InkShade shade(*look, view);
  const std::uint32_t ink = solid(stroke.color(), target.order);
  PixelRect band{seen.x0, seen.y0, seen.x1, seen.y0};
  while (s.cells.sweep_scanline(s.line)) {
    const int y = s.line.y();
    if (y < seen.y0 || y >= seen.y1) continue;
    if (y >= band.y1) {
      band.y0 = y;
      band.y1 = std::min(seen.y1, y + State::kBandRows);
      s.lay_tip(band, *look);
    }
    s.blend_line(shade, seen, ink, stroke.color().a, target);
  }
}

}  // namespace felt
