#include "desktop/canvas/ink_tile_store.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace felt::desktop {
namespace {

constexpr PixelRect kWhole{0, 0, kTileSide, kTileSide};

/// The edge of a stroke may colour pixels up to kEdgePx from its geometry.
constexpr double kEdgePx = 2.0;

PixelRect united(PixelRect a, PixelRect b) noexcept {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

/// Returns the smallest rectangle of whole pixels around an area. Clamps coordinates that do not
/// fit into an integer.
PlaneRect pixels_around(const Rect& px) noexcept {
  const auto whole = [](double x) { return static_cast<std::int64_t>(std::clamp(x, -1e15, 1e15)); };
  return {whole(std::floor(px.x0 - kEdgePx)), whole(std::floor(px.y0 - kEdgePx)),
          whole(std::ceil(px.x1 + kEdgePx)), whole(std::ceil(px.y1 + kEdgePx))};
}

/// Returns the part of a tile that lies in `area` of its plane.
PixelRect part_of(TilePlace place, const PlaneRect& area) noexcept {
  const PlaneRect tile = rect_of(place), both = tile.intersected(area);
  if (both.empty()) return {};
  return {static_cast<int>(both.x0 - tile.x0), static_cast<int>(both.y0 - tile.y0),
          static_cast<int>(both.x1 - tile.x0), static_cast<int>(both.y1 - tile.y0)};
}

View view_of(const PlaneSpec& plane, TilePlace place) noexcept {
  return plane.view.from(
      {static_cast<double>(place.x) * kTileSide, static_cast<double>(place.y) * kTileSide});
}

Pixels pixels_of(TilePicture& picture) noexcept {
  return {picture.bytes.data(), kTileSide, kTileSide, std::ptrdiff_t{4} * kTileSide,
          PixelOrder::kBgra};
}

void clear(TilePicture& picture, PixelRect part) noexcept {
  const std::size_t bytes = std::size_t{4} * static_cast<std::size_t>(part.width());
  for (int y = part.y0; y < part.y1; ++y) {
    std::memset(picture.bytes.data() + (std::ptrdiff_t{kTileSide} * y + part.x0) * 4, 0, bytes);
  }
}

}  // namespace

void InkTileStore::open(const Document& document) {
  scene_ = std::make_unique<InkScene>(document);
  begun_.reset();
  for (auto& [id, plane] : planes_) {
    for (auto& [place, tile] : plane.tiles) {
      tile.split.reset();
      damage(tile, kWhole);
    }
  }
}

void InkTileStore::apply(const Edit& edit) {
  InkDamage areas;
  drop_splits();
  // An error is ignored: an edit that is invalid here was also refused by the document. The preview
  // ends in any case.
  static_cast<void>(scene_->apply(edit, areas));
  damage(areas);
}

void InkTileStore::show(const std::optional<Edit>& preview) {
  InkDamage areas;
  static_cast<void>(scene_->show(preview, areas));
  damage(areas);
  if (scene_->previewed().empty()) drop_splits();
}

void InkTileStore::look(const PlaneSpec& plane, const PlaneRect& seen,
                        const std::optional<PlaneSpec>& over) {
  current_ = plane.id;
  over_ = over ? over->id : 0;
  seen_ = seen;
  ++uses_;
  const TileRange range = TileRange::of(seen);
  const auto use = [&](const PlaneSpec& spec) {
    Plane& known = planes_[spec.id];
    known.spec = spec;
    for (auto& [place, tile] : known.tiles) {
      if (range.contains(place)) tile.used = uses_;
    }
  };
  use(plane);
  if (over) use(*over);
}

void InkTileStore::forget(std::uint64_t plane) {
  const auto found = planes_.find(plane);
  if (found == planes_.end()) return;
  for (const auto& [place, tile] : found->second.tiles) {
    if (tile.picture) bytes_ -= TilePicture::kBytes;
  }
  planes_.erase(found);
}

std::size_t InkTileStore::tile_count() const noexcept {
  std::size_t count = 0;
  for (const auto& [id, plane] : planes_) count += plane.tiles.size();
  return count;
}

/// Drops the data that made repeated previews fast. Tiles with slightly inexact pixels, which are
/// the result of this method, are marked to be painted again.
void InkTileStore::drop_splits() {
  for (auto& [id, plane] : planes_) {
    for (auto& [place, tile] : plane.tiles) {
      if (tile.split && tile.split->is_rounded) damage(tile, kWhole);
      tile.split.reset();
    }
  }
}

void InkTileStore::damage(const InkDamage& areas) {
  for (auto& [id, plane] : planes_) {
    for (const Rect& area : areas) damage(plane, area);
  }
}

void InkTileStore::damage(Plane& plane, const Rect& area) {
  const PlaneRect px = pixels_around(plane.spec.view.area_px(area));
  const TileRange range = TileRange::of(px);
  const double count = (static_cast<double>(range.last.x - range.first.x) + 1.0) *
                       (static_cast<double>(range.last.y - range.first.y) + 1.0);
  if (count > static_cast<double>(plane.tiles.size())) {
    for (auto& [place, tile] : plane.tiles) damage(tile, part_of(place, px));
    return;
  }
  for (std::int64_t y = range.first.y; y <= range.last.y; ++y) {
    for (std::int64_t x = range.first.x; x <= range.last.x; ++x) {
      const auto found = plane.tiles.find({y, x});
      if (found != plane.tiles.end()) damage(found->second, part_of(found->first, px));
    }
  }
}

void InkTileStore::damage(Tile& tile, PixelRect part) {
  if (part.empty()) return;
  tile.dirty = united(tile.dirty, part);
  ++tile.damages;
}

/// How tiles are updated: an edit marks the parts of existing tiles that it changes as dirty.
/// plan() chooses one tile. It prefers outdated tiles in the view, then missing tiles in the view,
/// then tiles of the layers that cover new ink, then a ring around the view if memory permits, and
/// at last outdated tiles of other planes. work() paints the dirty part, stroke by stroke, into a
/// new picture, which replaces the old one when it is finished. If an interrupted picture became
/// outdated, the next attempt is not interrupted, so that the tile appears even if edits arrive
/// continuously.
InkTileStore::Need InkTileStore::plan() {
  choice_ = choose();
  return choice_.need;
}

/// Of the tiles in `area` that need work, returns the tile nearest to the middle of the view. If
/// `only_made`, considers only existing tiles that are outdated; otherwise also missing tiles.
std::optional<InkTileStore::Choice> InkTileStore::nearest(const Plane& plane, const PlaneRect& area,
                                                          bool only_made) const {
  if (area.empty()) return std::nullopt;
  const TileRange range = TileRange::of(area);
  const double x0 = 0.5 * static_cast<double>(seen_.x0 + seen_.x1) / kTileSide - 0.5;
  const double y0 = 0.5 * static_cast<double>(seen_.y0 + seen_.y1) / kTileSide - 0.5;
  std::optional<Choice> best;
  double best_distance = 0.0;
  for (std::int64_t y = range.first.y; y <= range.last.y; ++y) {
    for (std::int64_t x = range.first.x; x <= range.last.x; ++x) {
      const auto found = plane.tiles.find({y, x});
      const bool is_made = found != plane.tiles.end() && found->second.is_made;
      if (is_made ? found->second.dirty.empty() : only_made) continue;
      const double distance = std::hypot(static_cast<double>(x) - x0, static_cast<double>(y) - y0);
      if (best && distance >= best_distance) continue;
      best = Choice{Need::kNone, plane.spec.id, {y, x}};
      best_distance = distance;
    }
  }
  return best;
}

/// Returns a tile of the layers that cover new ink. It has lower priority than the view's own
/// tiles, because only new ink needs it.
std::optional<InkTileStore::Choice> InkTileStore::choose_over() const {
  const auto over = planes_.find(over_);
  if (over == planes_.end()) return std::nullopt;
  const auto wrong = nearest(over->second, seen_, true);
  return wrong ? wrong : nearest(over->second, seen_, false);
}

InkTileStore::Choice InkTileStore::choose() const {
  const auto current = planes_.find(current_);
  if (current == planes_.end()) return {};
  const Plane& plane = current->second;
  const auto as = [](Choice choice, Need need) {
    choice.need = need;
    return choice;
  };
  if (const auto wrong = nearest(plane, seen_, true)) return as(*wrong, Need::kRepair);
  if (const auto missing = nearest(plane, seen_, false)) return as(*missing, Need::kMissing);
  if (const auto over = choose_over()) return as(*over, Need::kMissing);
  const std::size_t ring = TilePicture::kBytes * 4;
  if (bytes_ + ring < max_bytes_ && !seen_.empty()) {
    if (const auto near = nearest(plane, seen_.inflated(kTileSide), false)) {
      return as(*near, Need::kAround);
    }
  }
  if (!scene_->previewed().empty()) return {};
  // Other planes are updated because the view may show them again, or show them scaled.
  for (const auto& [id, other] : planes_) {
    for (const auto& [place, tile] : other.tiles) {
      if (tile.is_made && !tile.dirty.empty()) return {Need::kAround, id, place};
    }
  }
  return {};
}

InkTileStore::Begun InkTileStore::begin(const Choice& choice, Plane& plane, Tile& tile) {
  Begun begun;
  begun.plane = choice.plane;
  begun.place = choice.place;
  begun.damages = tile.damages;
  begun.part = tile.is_made ? tile.dirty : kWhole;
  const View view = view_of(plane.spec, choice.place);
  begun.picture = std::make_shared<TilePicture>();
  if (tile.is_made && tile.picture) begun.picture->bytes = tile.picture->bytes;
  clear(*begun.picture, begun.part);
  begun.job.view = view;
  begun.job.part = begun.part;
  return begun;
}

/// Returns false if painting was interrupted.
bool InkTileStore::paint(Plane& plane, Tile& tile, Begun& begun,
                         const std::function<bool()>& should_stop) {
  const Pixels pixels = pixels_of(*begun.picture);
  const InkStyle& style = plane.spec.style;
  scene_->set_styles(style.grain.styles());
  if (!begun.job.has_begun()) {
    if (!scene_->previewed().empty() && !plane.spec.above) {
      if (!tile.split) tile.split = std::make_unique<TileSplit>();
      if (painter_.paint_split(*scene_, begun.job.view, begun.part, style, *tile.split, pixels)) {
        return true;
      }
    }
    begun.job = TilePainter::job_of(*scene_, begun.job.view, begun.part, plane.spec.above);
  }
  const bool may_stop = !tile.must_finish;
  while (!begun.job.is_done()) {
    painter_.draw_next(begun.job, style, pixels);
    if (may_stop && should_stop()) return begun.job.is_done();
  }
  return true;
}

void InkTileStore::work(std::uint64_t order, const std::function<bool()>& should_stop,
                        std::vector<TileNews>& news) {
  const Choice choice = std::exchange(choice_, {});
  if (choice.need == Need::kNone) return;
  Plane& plane = planes_.at(choice.plane);
  Tile& tile = plane.tiles[choice.place];
  tile.used = uses_;
  std::optional<Begun> begun = std::exchange(begun_, std::nullopt);
  const bool is_same = begun && begun->plane == choice.plane && begun->place == choice.place;
  if (is_same && begun->damages != tile.damages) tile.must_finish = true;
  if (!is_same || begun->damages != tile.damages) begun = begin(choice, plane, tile);
  if (!paint(plane, tile, *begun, should_stop)) {
    begun_ = std::move(begun);
    return;
  }
  const bool is_blank = begun->job.is_blank() && !tile.split && !tile.picture;
  if (tile.picture) bytes_ -= TilePicture::kBytes;
  const bool is_empty = is_blank || (begun->part == kWhole && begun->job.is_blank() &&
                                     !(tile.split && !tile.split->valid.empty()));
  tile.picture = is_empty ? nullptr : TilePtr(std::move(begun->picture));
  if (tile.picture) bytes_ += TilePicture::kBytes;
  tile.is_made = true;
  tile.must_finish = false;
  tile.dirty = {};
  news.push_back({choice.plane, choice.place, true, tile.picture, begun->part, order});
  drop_old(news);
}

/// Drops the tiles that were unused for the longest time until the others fit the memory limit.
void InkTileStore::drop_old(std::vector<TileNews>& news) {
  while (bytes_ > max_bytes_) {
    Plane* in = nullptr;
    std::map<TilePlace, Tile>::iterator oldest;
    const TileRange seen = TileRange::of(seen_);
    for (auto& [id, plane] : planes_) {
      for (auto at = plane.tiles.begin(); at != plane.tiles.end(); ++at) {
        const bool is_seen = (id == current_ || id == over_) && seen.contains(at->first);
        if (!at->second.picture || is_seen) continue;
        if (in && at->second.used >= oldest->second.used) continue;
        in = &plane;
        oldest = at;
      }
    }
    if (!in) return;
    news.push_back({in->spec.id, oldest->first, false, nullptr, kWhole, 0});
    in->tiles.erase(oldest);
    bytes_ -= TilePicture::kBytes;
  }
}

}  // namespace felt::desktop
