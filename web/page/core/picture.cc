#include "web/page/core/picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace felt::page {
namespace {

constexpr double kEdgePx = 2.0;  // the edge of a stroke may colour pixels so far from its geometry

PixelRect united(PixelRect a, PixelRect b) noexcept {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

std::uint8_t* at(Pixels pixels, int x, int y) noexcept {
  return pixels.data + pixels.stride * y + std::ptrdiff_t{4} * x;
}

void copy(Pixels from, PixelRect part, Pixels to) noexcept {
  for (int y = part.y0; y < part.y1; ++y) {
    std::memcpy(at(to, part.x0, y), at(from, part.x0, y),
                4 * static_cast<std::size_t>(part.width()));
  }
}

/// Blends `part` of a premultiplied picture, whose (0, 0) is at (x0, y0) of `to`, over opaque
/// pixels.
void blend_over(Pixels from, int x0, int y0, PixelRect part, Pixels to) noexcept {
  for (int y = part.y0; y < part.y1; ++y) {
    const std::uint8_t* ink = at(from, part.x0 - x0, y - y0);
    std::uint8_t* under = at(to, part.x0, y);
    for (int x = part.x0; x < part.x1; ++x, ink += 4, under += 4) {
      const unsigned left = 255U - ink[3];
      if (left == 255U) continue;
      for (int k = 0; k < 3; ++k) {
        const unsigned v = under[k] * left + 128U;
        under[k] = static_cast<std::uint8_t>(ink[k] + ((v + (v >> 8U)) >> 8U));
      }
    }
  }
}

}  // namespace

Picture::Picture()
    : scene_(std::make_unique<InkScene>()), tile_(std::size_t{4} * kTileSide * kTileSide) {}

Pixels Picture::of(std::vector<std::uint8_t>& bytes) const noexcept {
  return {bytes.data(), width_, height_, std::ptrdiff_t{4} * width_, PixelOrder::kRgba};
}

PixelRect Picture::pixels_of(const Rect& mm) const noexcept {
  const Rect px = view_.area_px(mm);
  const auto whole = [](double x) { return static_cast<int>(std::clamp(x, -1e8, 1e8)); };
  return PixelRect{whole(std::floor(px.x0 - kEdgePx)), whole(std::floor(px.y0 - kEdgePx)),
                   whole(std::ceil(px.x1 + kEdgePx)), whole(std::ceil(px.y1 + kEdgePx))}
      .intersected(all());
}

PixelRect Picture::rect_of(std::size_t tile) const noexcept {
  const int x = static_cast<int>(tile) % columns_ * kTileSide;
  const int y = static_cast<int>(tile) / columns_ * kTileSide;
  return PixelRect{x, y, x + kTileSide, y + kTileSide}.intersected(all());
}

// --- Changes

void Picture::open(const Document& document) {
  scene_ = std::make_unique<InkScene>(document);
  scene_->set_styles(style_.grain.styles());
  drop_splits();
  damage(all(), false);
}

void Picture::apply(const Edit& edit) {
  InkDamage areas;
  drop_splits();
  static_cast<void>(scene_->apply(edit, areas));
  damage(areas);
}

void Picture::show(const std::optional<Edit>& preview) {
  if (!preview && scene_->previewed().empty()) return;
  InkDamage areas;
  static_cast<void>(scene_->show(preview, areas));
  damage(areas);
  if (scene_->previewed().empty()) drop_splits();
}

void Picture::show_wet(const Overlay& overlay, const std::string& medium, double opacity) {
  InkDamage areas;
  wet_opacity_ = opacity;
  wet_.update(overlay, medium, areas);
  for (const Rect& area : areas) wet_dirty_ = united(wet_dirty_, pixels_of(area));
}

void Picture::drop_splits() {
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    if (tiles_[i].split.is_rounded) tiles_[i].dirty = rect_of(i);
    if (!tiles_[i].split.valid.empty()) tiles_[i].split = {};
  }
}

void Picture::damage(const InkDamage& areas) {
  for (const Rect& area : areas) damage(pixels_of(area), false);
}

void Picture::damage(PixelRect px, bool is_missing) {
  px = px.intersected(all());
  if (px.empty()) return;
  for (int y = px.y0 / kTileSide; y <= (px.y1 - 1) / kTileSide; ++y) {
    for (int x = px.x0 / kTileSide; x <= (px.x1 - 1) / kTileSide; ++x) {
      const auto index = static_cast<std::size_t>(y * columns_ + x);
      Tile& tile = tiles_[index];
      tile.dirty = united(tile.dirty, px.intersected(rect_of(index)));
      tile.is_missing = tile.is_missing || is_missing;
    }
  }
}

// --- The view

void Picture::resize(int width, int height) {
  width_ = std::clamp(width, 1, 16384);
  height_ = std::clamp(height, 1, 16384);
  columns_ = (width_ + kTileSide - 1) / kTileSide;
  const int rows = (height_ + kTileSide - 1) / kTileSide;
  tiles_.assign(static_cast<std::size_t>(columns_ * rows), Tile{});
  base_.assign(
      std::size_t{4} * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 255);
  shown_ = base_;
  paint_ground(all(), of(base_));
  moved_ = all();
  damage(all(), true);
}

void Picture::set_ground(const Page& page, Rgba desk) {
  if (page == page_ && desk == desk_) return;
  page_ = page;
  desk_ = desk;
  style_.paper = page.paper.a < 255 ? Rgba{255, 255, 255, 255} : page.paper;
  drop_splits();
  damage(all(), false);
}

void Picture::set_grain(const Grain& grain) {
  if (grain == style_.grain) return;
  style_.grain = grain;
  scene_->set_styles(grain.styles());
  for (Tile& tile : tiles_) tile.split = {};
  damage(all(), false);
}

void Picture::set_view(const View& view) {
  if (view == view_) return;
  const View before = std::exchange(view_, view);
  for (Tile& tile : tiles_) tile.split = {};
  const Vec shift = view.to_px(before.origin_mm);
  const bool is_moved = before.px_per_mm == view.px_per_mm && before.turn == view.turn &&
                        before.is_mirrored == view.is_mirrored &&
                        std::fabs(shift.x - std::round(shift.x)) < 1e-6 &&
                        std::fabs(shift.y - std::round(shift.y)) < 1e-6 &&
                        std::fabs(shift.x) < width_ && std::fabs(shift.y) < height_;
  const bool is_complete =
      std::none_of(tiles_.begin(), tiles_.end(), [](const Tile& t) { return !t.dirty.empty(); });
  moved_ = all();
  if (is_moved && is_complete) {
    move(static_cast<int>(std::lround(shift.x)), static_cast<int>(std::lround(shift.y)));
  } else {
    scale_from(before);
    damage(all(), true);
  }
}

/// Moves the picture, and marks the strips that come into view.
void Picture::move(int dx, int dy) {
  const Pixels pixels = of(base_);
  const PixelRect kept = PixelRect{dx, dy, width_ + dx, height_ + dy}.intersected(all());
  const auto row = [&](int y) {
    std::memmove(at(pixels, kept.x0, y), at(pixels, kept.x0 - dx, y - dy),
                 4 * static_cast<std::size_t>(kept.width()));
  };
  if (dy > 0) {
    for (int y = kept.y1 - 1; y >= kept.y0; --y) row(y);
  } else {
    for (int y = kept.y0; y < kept.y1; ++y) row(y);
  }
  for (const PixelRect strip :
       {PixelRect{0, 0, width_, kept.y0}, PixelRect{0, kept.y1, width_, height_},
        PixelRect{0, kept.y0, kept.x0, kept.y1}, PixelRect{kept.x1, kept.y0, width_, kept.y1}}) {
    if (strip.empty()) continue;
    paint_ground(strip, pixels);
    damage(strip, true);
  }
}

/// Fills the picture with the previous one, scaled without smoothing, until the tiles are painted.
void Picture::scale_from(const View& before) {
  std::vector<std::uint8_t> old = base_;
  const Pixels from = of(old), to = of(base_);
  paint_ground(all(), to);
  const Vec origin = before.to_px(view_.to_mm({0.5, 0.5}));
  const Vec dx = before.to_px(view_.to_mm({1.5, 0.5})) - origin;
  const Vec dy = before.to_px(view_.to_mm({0.5, 1.5})) - origin;
  for (int y = 0; y < height_; ++y) {
    Vec p = origin + static_cast<double>(y) * dy;
    std::uint8_t* pixel = at(to, 0, y);
    for (int x = 0; x < width_; ++x, p = p + dx, pixel += 4) {
      if (!(p.x >= 0.0 && p.y >= 0.0 && p.x < width_ && p.y < height_)) continue;
      std::memcpy(pixel, at(from, static_cast<int>(p.x), static_cast<int>(p.y)), 4);
    }
  }
}

// --- Painting

void Picture::paint_ground(PixelRect part, Pixels target) const {
  fill(target, part, desk_);
  const Rgba paper = style_.paper;
  if (view_.turn == Vec{1.0, 0.0}) {
    const Rect px = view_.area_px(page_.area());
    const auto whole = [](double x) {
      return static_cast<int>(std::lround(std::clamp(x, -1e8, 1e8)));
    };
    fill(target,
         PixelRect{whole(px.x0), whole(px.y0), whole(px.x1), whole(px.y1)}.intersected(part),
         paper);
    return;
  }
  for (int y = part.y0; y < part.y1; ++y) {
    for (int x = part.x0; x < part.x1; ++x) {
      const Point mm = view_.to_mm({x + 0.5, y + 0.5});
      if (mm.x < 0 || mm.y < 0 || mm.x > page_.width_mm || mm.y > page_.height_mm) continue;
      std::uint8_t* pixel = at(target, x, y);
      pixel[0] = paper.r;
      pixel[1] = paper.g;
      pixel[2] = paper.b;
    }
  }
}

void Picture::paint_tile(std::size_t index) {
  Tile& tile = tiles_[index];
  const PixelRect whole = rect_of(index);
  const PixelRect part{tile.dirty.x0 - whole.x0, tile.dirty.y0 - whole.y0, tile.dirty.x1 - whole.x0,
                       tile.dirty.y1 - whole.y0};
  const Pixels pixels{tile_.data(), kTileSide, kTileSide, std::ptrdiff_t{4} * kTileSide,
                      PixelOrder::kRgba};
  fill(pixels, part, {0, 0, 0, 0});
  const View view = view_.from({static_cast<double>(whole.x0), static_cast<double>(whole.y0)});
  const bool is_split = !scene_->previewed().empty() &&
                        painter_.paint_split(*scene_, view, part, style_, tile.split, pixels);
  if (!is_split) {
    InkJob job = TilePainter::job_of(*scene_, view, part);
    while (!job.is_done()) painter_.draw_next(job, style_, pixels);
  }
  paint_ground(tile.dirty, of(base_));
  blend_over(pixels, whole.x0, whole.y0, tile.dirty, of(base_));
  painted_ = united(painted_, tile.dirty);
  tile.dirty = {};
  tile.is_missing = false;
}

/// Copies a part of the picture and draws the wet ink over it.
void Picture::paint_wet(PixelRect part) {
  part = part.intersected(all());
  if (part.empty()) return;
  copy(of(base_), part, of(shown_));
  if (wet_.is_empty()) return;
  if (wet_opacity_ >= 1.0) {
    for (const StrokePtr& stroke : wet_.strokes()) {
      painter_.draw(*stroke, view_, part, style_, of(shown_));
    }
    return;
  }
  std::vector<std::uint8_t> ink(base_.size(), 0);
  for (const StrokePtr& stroke : wet_.strokes())
    painter_.draw(*stroke, view_, part, style_, of(ink));
  blend(of(ink), part, wet_opacity_, BlendMode::kNormal, style_.paper, of(shown_));
}

bool Picture::is_stale() const noexcept {
  return !wet_dirty_.empty() || !moved_.empty() ||
         std::any_of(tiles_.begin(), tiles_.end(), [](const Tile& t) { return !t.dirty.empty(); });
}

/// Changed tiles come before missing ones, and those in the middle before those at the edge.
bool Picture::paint(const std::function<bool()>& is_late) {
  painted_ = united(std::exchange(moved_, {}), std::exchange(wet_dirty_, {}));
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    if (tiles_[i].dirty.empty()) continue;
    const PixelRect r = rect_of(i);
    const double away = std::hypot(r.x0 + r.x1 - width_, r.y0 + r.y1 - height_);
    order.emplace_back(tiles_[i].is_missing ? 1e9 + away : away, i);
  }
  std::sort(order.begin(), order.end());
  std::size_t done = 0;
  while (done < order.size()) {
    paint_tile(order[done++].second);
    if (is_late()) break;
  }
  paint_wet(painted_);
  return done < order.size();
}

}  // namespace felt::page
