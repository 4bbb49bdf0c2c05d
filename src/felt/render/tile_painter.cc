#include "felt/render/tile_painter.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <utility>

namespace felt {
namespace {

/// If fewer strokes than this would be kept as a picture, drawing them is as fast as copying it.
constexpr std::size_t kWorthKeeping = 4;

/// Up to this many strokes above those of a preview are drawn one after another, which is exact.
constexpr std::size_t kFewAbove = 24;

/// A split is made larger than requested by this margin, because strokes of a preview move.
constexpr int kMarginPx = 48;

constexpr PixelRect kTile{0, 0, kTileSide, kTileSide};

Rect area_of(const View& view, PixelRect part) noexcept {
  return view.area_mm({part.x0 - 2.0, part.y0 - 2.0}, {part.x1 + 2.0, part.y1 + 2.0});
}

bool contains(PixelRect outer, PixelRect inner) noexcept {
  return outer.intersected(inner) == inner;
}

/// Returns a vector with the pixels of `valid` as a picture with (0, 0) at the tile's corner.
Pixels pixels_of(std::vector<std::uint8_t>& bytes, PixelRect valid, PixelOrder order) noexcept {
  return {bytes.data(), valid.width(), valid.height(), std::ptrdiff_t{4} * valid.width(), order};
}

void blend_row(const std::uint8_t* from, std::uint8_t* to, int pixels) noexcept {
  for (int x = 0; x < pixels; ++x, from += 4, to += 4) {
    const unsigned left = 255U - from[3];
    if (left == 255U) continue;
    for (int k = 0; k < 4; ++k) {
      const unsigned under = to[k] * left + 128U;
      to[k] = static_cast<std::uint8_t>(from[k] + ((under + (under >> 8U)) >> 8U));
    }
  }
}

/// Height limits of a split: strokes strictly between them are drawn again.
struct Gap {
  InkHeight above;  ///< height of the lowest stroke in TileSplit::above
  InkHeight below;  ///< height of the highest stroke in TileSplit::below
  bool has_above = false;
  bool has_below = false;

  [[nodiscard]] bool contains(InkHeight h) const noexcept {
    return (!has_below || h > below) && (!has_above || h < above);
  }
};

Gap gap_of(const InkScene& scene, const TileSplit& split) {
  Gap gap;
  if (const SceneStroke* below = scene.find(split.below_top)) {
    gap.has_below = true;
    gap.below = InkScene::height(*below);
  }
  if (const SceneStroke* above = scene.find(split.above_bottom)) {
    gap.has_above = true;
    gap.above = InkScene::height(*above);
  }
  return gap;
}

/// Adds the groups of layers that are drawn as a whole. `layers` are those of job.groups.
void add_folders(const std::vector<SceneInk>& ink, const std::vector<const SceneLayer*>& layers,
                 InkJob& job) {
  std::size_t item = 0, group = 0;
  while (item < ink.size() || group < layers.size()) {
    const SceneLayer* layer = item < ink.size() ? ink[item].layer : layers[group];
    if (group < layers.size() && layers[group]->position < layer->position) layer = layers[group];
    const auto is_same = [layer](const SceneLayer* other) {
      return other == layer || same_group(other->group, layer->group);
    };
    InkFolder folder{item, item, group, group};
    while (item < ink.size() && is_same(ink[item].layer)) ++item;
    while (group < layers.size() && is_same(layers[group])) ++group;
    if (!layer->group || !layer->group->is_whole()) continue;
    folder.last = item;
    folder.last_group = group;
    folder.opacity = layer->group->opacity;
    folder.blend = layer->group->blend;
    job.folders.push_back(folder);
  }
}

/// Returns the job that draws this ink, which is in drawing order, and the special layers.
InkJob job_from(const std::vector<SceneInk>& ink, const std::vector<const SceneLayer*>& special,
                const View& view, PixelRect part) {
  InkJob job;
  job.view = view;
  job.part = part;
  job.items.reserve(ink.size());
  for (const SceneInk& i : ink) {
    job.items.push_back({i.stroke ? i.stroke->stroke : nullptr, i.fill ? i.fill->fill : nullptr});
  }
  const Rect area = area_of(view, part);
  std::vector<const SceneLayer*> layers;
  for (const SceneLayer* layer : special) {
    const auto first = std::partition_point(ink.begin(), ink.end(), [layer](const SceneInk& i) {
      return i.layer->position < layer->position;
    });
    const auto last = std::partition_point(first, ink.end(),
                                           [layer](const SceneInk& i) { return i.layer == layer; });
    const bool shows_picture = layer->pixels && bounds_of(*layer->picture).intersects(area);
    if (first == last && !shows_picture) continue;
    InkGroup group{static_cast<std::size_t>(first - ink.begin()),
                   static_cast<std::size_t>(last - ink.begin()),
                   layer->opacity,
                   nullptr,
                   {},
                   layer->blend,
                   layer->order.size() > 0 || !layer->fills.empty()};
    if (shows_picture) {
      group.pixels = layer->pixels;
      group.place = layer->picture->place;
    }
    job.groups.push_back(std::move(group));
    layers.push_back(layer);
  }
  add_folders(ink, layers, job);
  return job;
}

/// Returns true if all special layers are below the strokes of the preview, so that a TileSplit can
/// contain them.
bool is_special_below(const InkScene& scene) {
  const std::vector<const SceneLayer*> special = scene.special_layers();
  if (special.empty()) return true;
  const SceneLayer& highest = *special.back();
  return std::all_of(scene.previewed().begin(), scene.previewed().end(), [&](StrokeId id) {
    const SceneStroke* stroke = scene.find(id);
    if (!stroke) return true;
    const std::size_t position = stroke->layer->position;
    return position > highest.position || (position == highest.position && !highest.is_whole());
  });
}

}  // namespace

InkJob TilePainter::job_of(const InkScene& scene, const View& view, PixelRect part,
                           std::optional<LayerId> above) {
  std::vector<SceneInk> found;
  scene.find_ink(area_of(view, part), found, above);
  return job_from(found, scene.special_layers(above), view, part);
}

void TilePainter::draw(const Stroke& stroke, const View& view, PixelRect part,
                       const InkStyle& style, Pixels target) {
  if (style.hair_px > 0.0) {
    rasterizer_.draw_center_line(stroke, view, part, style.hair_px, target);
  } else {
    rasterizer_.draw(stroke, view, part, style.grain, target);
  }
}

void TilePainter::draw_item(InkJob& job, const InkStyle& style, Pixels target) {
  const InkItem& item = job.items[job.next++];
  const PixelRect clip = style.is_seamless ? target.rect() : job.part;
  if (style.is_seamless) rasterizer_.set_window(job.part);
  if (item.stroke) {
    draw(*item.stroke, job.view, clip, style, target);
  } else if (style.hair_px == 0.0) {
    rasterizer_.draw_fill(*item.fill, job.view, clip, target);
  }
  rasterizer_.set_window(std::nullopt);
}

namespace {

enum class Buffer { kNew, kKept };

/// Returns pixels like those of `target` in a buffer. A new one is cleared.
Pixels whole_of(std::vector<std::uint8_t>& bytes, const Pixels& target, Buffer buffer) {
  if (buffer == Buffer::kNew) {
    bytes.assign(
        4 * static_cast<std::size_t>(target.width) * static_cast<std::size_t>(target.height), 0);
  }
  Pixels pixels = target;
  pixels.data = bytes.data();
  pixels.stride = std::ptrdiff_t{4} * target.width;
  return pixels;
}

}  // namespace

void TilePainter::draw_next(InkJob& job, const InkStyle& style, Pixels target) {
  const auto folder = [&job]() -> const InkFolder* {
    return job.next_folder < job.folders.size() ? &job.folders[job.next_folder] : nullptr;
  };
  const bool begins = folder() && job.next >= folder()->first &&
                      job.next_group >= folder()->first_group && !job.is_in_group;
  if (!begins && !job.is_in_folder) return draw_in_group(job, style, target);
  const Pixels to = whole_of(job.folder_pixels, target,
                             std::exchange(job.is_in_folder, true) ? Buffer::kKept : Buffer::kNew);
  InkStyle inside = style;
  inside.paper = InkStyle{}.paper;  // the folder is blended on its own
  draw_in_group(job, inside, to);
  if (job.next < folder()->last || job.next_group < folder()->last_group) return;
  blend(to, job.part, folder()->opacity, folder()->blend, style.paper, target);
  job.is_in_folder = false;
  ++job.next_folder;
}

void TilePainter::draw_in_group(InkJob& job, const InkStyle& style, Pixels target) {
  const bool is_grouped =
      job.next_group < job.groups.size() && job.next >= job.groups[job.next_group].first;
  if (!is_grouped) return draw_item(job, style, target);
  const InkGroup& group = job.groups[job.next_group];
  const bool has_mode = group.blend != BlendMode::kNormal;
  const bool has_ink = style.is_seamless ? group.has_ink : group.last > group.first;
  const bool is_whole = has_mode || (group.opacity < 1.0 && has_ink);
  Pixels to = target;
  if (is_whole) {
    to = whole_of(job.group_pixels, target, job.is_in_group ? Buffer::kKept : Buffer::kNew);
  }
  if (!std::exchange(job.is_in_group, true) && group.pixels) {
    group.pixels->draw(group.place, job.view, job.part, is_whole ? 1.0 : group.opacity, to);
  } else if (job.next < group.last) {
    draw_item(job, style, to);
  }
  if (job.next < group.last) return;
  if (is_whole) blend(to, job.part, group.opacity, group.blend, style.paper, target);
  job.is_in_group = false;
  ++job.next_group;
}

/// Returns true if the kept content still matches the scene without the preview.
bool TilePainter::is_valid(const InkScene& scene, const View& view, const TileSplit& split) {
  if (split.valid.empty() || split.revision != scene.revision()) return false;
  if (split.previewed == scene.previewed()) return true;
  std::vector<StrokeId> others;
  std::set_difference(scene.previewed().begin(), scene.previewed().end(), split.previewed.begin(),
                      split.previewed.end(), std::back_inserter(others));
  for (const StrokeId id : others) {
    if (std::binary_search(split.drawn.begin(), split.drawn.end(), id)) return false;
  }
  others.clear();
  std::set_difference(split.previewed.begin(), split.previewed.end(), scene.previewed().begin(),
                      scene.previewed().end(), std::back_inserter(others));
  const Rect area = area_of(view, split.valid);
  return std::none_of(others.begin(), others.end(), [&](StrokeId id) {
    const SceneStroke* stroke = scene.find(id);
    return stroke && area.intersects(stroke->box);
  });
}

/// Returns true if the split covers `part`, and the strokes of the preview in `found_` lie in its
/// gap.
bool TilePainter::fits(const InkScene& scene, const TileSplit& split, PixelRect part) const {
  if (!contains(split.valid, part)) return false;
  const Gap gap = gap_of(scene, split);
  return std::all_of(found_.begin(), found_.end(), [&](const SceneStroke* s) {
    return !s->is_previewed || gap.contains(InkScene::height(*s));
  });
}

bool TilePainter::make(const InkScene& scene, const View& view, PixelRect valid,
                       const InkStyle& style, TileSplit& split) {
  scene.find(area_of(view, valid), found_);
  const auto is_previewed = [](const SceneStroke* s) { return s->is_previewed; };
  const auto lowest = std::find_if(found_.begin(), found_.end(), is_previewed);
  const auto highest = std::find_if(found_.rbegin(), found_.rend(), is_previewed).base();
  if (lowest == found_.end()) return false;
  const auto kept = static_cast<std::size_t>((lowest - found_.begin()) + (found_.end() - highest));
  const std::vector<const SceneLayer*> special = scene.special_layers();
  if (kept < kWorthKeeping) return false;
  const View shifted = view.from({static_cast<double>(valid.x0), static_cast<double>(valid.y0)});
  const bool was_rounded = split.is_rounded;
  split = {};
  split.is_rounded = was_rounded;
  split.valid = valid;
  split.revision = scene.revision();
  split.previewed = scene.previewed();
  const auto draw_all = [&](auto first, auto last, std::vector<std::uint8_t>& bytes,
                            const std::vector<const SceneLayer*>& layers) {
    bytes.assign(std::size_t{4} * static_cast<std::size_t>(valid.width()) *
                     static_cast<std::size_t>(valid.height()),
                 0);
    const Pixels pixels = pixels_of(bytes, valid, PixelOrder::kBgra);
    std::vector<SceneInk> ink;
    for (; first != last; ++first) {
      ink.push_back({*first, nullptr, (*first)->layer});
      split.drawn.push_back((*first)->id);
    }
    InkJob job = job_from(ink, layers, shifted, pixels.rect());
    while (!job.is_done()) draw_next(job, style, pixels);
  };
  draw_all(found_.begin(), lowest, split.below, special);
  draw_all(highest, found_.end(), split.above, {});
  if (lowest != found_.begin()) split.below_top = (*std::prev(lowest))->id;
  if (highest != found_.end()) split.above_bottom = (*highest)->id;
  std::sort(split.drawn.begin(), split.drawn.end());
  return true;
}

// Copies the picture of the strokes below, draws the strokes in the gap, then blends the picture of
// the strokes above; if only a few strokes are above, draws these strokes instead. If the split
// does not fit, first makes it again for a larger area.
bool TilePainter::paint_split(const InkScene& scene, const View& view, PixelRect part,
                              const InkStyle& style, TileSplit& split, Pixels target) {
  if (scene.previewed().empty() || scene.has_fill(area_of(view, part)) ||
      !is_special_below(scene)) {
    return false;
  }
  if (!is_valid(scene, view, split)) split.valid = {};
  scene.find(area_of(view, part), found_);
  if (found_.size() < kWorthKeeping) return false;
  if (!fits(scene, split, part)) {
    PixelRect wide = part;
    if (!split.valid.empty()) {
      wide = {std::min(wide.x0, split.valid.x0), std::min(wide.y0, split.valid.y0),
              std::max(wide.x1, split.valid.x1), std::max(wide.y1, split.valid.y1)};
    }
    wide = kTile.intersected(
        {wide.x0 - kMarginPx, wide.y0 - kMarginPx, wide.x1 + kMarginPx, wide.y1 + kMarginPx});
    if (!make(scene, view, wide, style, split)) return false;
    scene.find(area_of(view, part), found_);
  }
  const PixelRect valid = split.valid;
  const std::ptrdiff_t stride = std::ptrdiff_t{4} * valid.width();
  const auto row_of = [&](std::vector<std::uint8_t>& bytes, int y) {
    return bytes.data() + (y - valid.y0) * stride + std::ptrdiff_t{4} * (part.x0 - valid.x0);
  };
  const auto target_row = [&](int y) {
    return target.data + y * target.stride + std::ptrdiff_t{4} * part.x0;
  };
  for (int y = part.y0; y < part.y1; ++y) {
    std::memcpy(target_row(y), row_of(split.below, y),
                std::size_t{4} * static_cast<std::size_t>(part.width()));
  }
  const Gap gap = gap_of(scene, split);
  const auto above = static_cast<std::size_t>(std::count_if(
      found_.begin(), found_.end(),
      [&gap](const SceneStroke* s) { return gap.has_above && InkScene::height(*s) >= gap.above; }));
  for (const SceneStroke* s : found_) {
    const InkHeight height = InkScene::height(*s);
    const bool is_over = !gap.has_below || height > gap.below;
    if (is_over && (above <= kFewAbove || gap.contains(height))) {
      draw(*s->stroke, view, part, style, target);
    }
  }
  if (above <= kFewAbove) return true;
  for (int y = part.y0; y < part.y1; ++y) {
    blend_row(row_of(split.above, y), target_row(y), part.width());
  }
  split.is_rounded = true;
  return true;
}

}  // namespace felt
