#include "felt/render/ink_scene.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>

#include "felt/document/reorder.h"

namespace felt {
namespace {

tl::unexpected<Error> misfit(StrokeId id, const char* why) {
  return fail(ErrorCode::kInvalidArgument, "stroke " + std::to_string(id.value) + " " + why);
}

/// Returns true if every change only replaces the shape of a stroke, at the same position.
bool only_replaces(const Edit& edit) noexcept {
  return edit.layers.empty() && edit.fills.empty() &&
         std::all_of(edit.changes.begin(), edit.changes.end(), [](const StrokeChange& c) {
           return c.before && c.after && c.before_place == c.after_place;
         });
}

void add_fill_ids(const Edit& edit, std::vector<FillId>& ids) {
  for (const FillChange& c : edit.fills) ids.push_back(c.id);
}

void add_ids(const Edit& edit, std::vector<StrokeId>& ids) {
  for (const StrokeChange& c : edit.changes) ids.push_back(c.id);
}

/// The strokes that one layer gains and loses.
struct LayerWork {
  std::vector<std::size_t> removed;                                // positions before
  std::vector<std::pair<std::size_t, const StrokeChange*>> added;  // positions after
  std::vector<const StrokeChange*> kept;
};

/// Groups the changes by layer. If a layer gains or loses strokes, its replaced strokes are removed
/// and inserted again too, so that they keep the positions in the edit, as in Moves (reorder.h).
std::map<LayerId, LayerWork> plan(const Edit& edit) {
  std::map<LayerId, LayerWork> work;
  for (const StrokeChange& c : edit.changes) {
    if (c.before && c.after && c.before_place == c.after_place) {
      work[c.before_place.layer].kept.push_back(&c);
      continue;
    }
    if (c.before) work[c.before_place.layer].removed.push_back(c.before_place.index);
    if (c.after) work[c.after_place.layer].added.emplace_back(c.after_place.index, &c);
  }
  for (auto& [id, w] : work) {
    if (w.removed.empty() && w.added.empty()) continue;
    for (const StrokeChange* c : w.kept) {
      w.removed.push_back(c->before_place.index);
      w.added.emplace_back(c->after_place.index, c);
    }
    std::sort(w.removed.rbegin(), w.removed.rend());
    std::sort(w.added.begin(), w.added.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
  }
  return work;
}

}  // namespace

InkScene::InkScene(const Document& document) {
  for (const Layer& from : document.layers()) {
    SceneLayer& layer = layers_[from.id];
    layer.id = from.id;
    set_look(layer, from.state());
    layer.position = layer_order_.size();
    layer_order_.push_back(from.id);
    layer.fills = from.fills;
    for (const FillId id : from.fills) {
      const FillPtr fill = document.find_fill(id);
      fills_[id] = {fill, fill_bounds(*fill), from.id};
    }
    for (const StrokeId id : from.strokes) {
      SceneStroke& stroke = strokes_[id];
      stroke.id = id;
      stroke.stroke = document.find(id);
      stroke.box = stroke.stroke->bounds();
      stroke.layer = &layer;
      layer.order.append(stroke);
      layer.grid.add(stroke);
    }
  }
}

Result<void> InkScene::apply(const Edit& edit, InkDamage& damage) {
  return change(&edit, false, damage);
}

Result<void> InkScene::show(const std::optional<Edit>& preview, InkDamage& damage) {
  if (!preview && !preview_) return {};
  return change(preview ? &*preview : nullptr, true, damage);
}

/// Undoes the preview and applies the next edit. Compares the strokes that the preview and the edit
/// change, as they looked before and as they look after, and adds only visible differences to the
/// damage.
Result<void> InkScene::change(const Edit* next, bool is_preview, InkDamage& damage) {
  std::vector<StrokeId> ids;
  if (preview_) add_ids(*preview_, ids);
  if (next) add_ids(*next, ids);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<FillId> fill_ids;
  if (preview_) add_fill_ids(*preview_, fill_ids);
  if (next) add_fill_ids(*next, fill_ids);
  SeenStrokes before = look(ids);
  const SeenFills fills_before = look_at_fills(fill_ids);
  mark_previewed(false);
  if (preview_) {
    const Edit back = preview_->inverse();
    add_layers(back, damage);
    only_replaces(back) ? replace(back) : carry_out(back);
    add_layers(back, damage);
    if (!back.layers.empty()) ++revision_;
  }
  preview_.reset();
  previewed_.clear();
  Result<void> fits = next ? check(*next) : Result<void>();
  if (next && fits) {
    add_layers(*next, damage);
    only_replaces(*next) ? replace(*next) : carry_out(*next);
    add_layers(*next, damage);
    if (is_preview) {
      preview_ = *next;
      add_ids(*next, previewed_);
      std::sort(previewed_.begin(), previewed_.end());
      mark_previewed(true);
    }
    if (!is_preview || !next->layers.empty()) ++revision_;
  }
  compare(std::move(before), look(ids), damage);
  compare_fills(fills_before, look_at_fills(fill_ids), damage);
  return fits;
}

void InkScene::mark_previewed(bool on) {
  for (const StrokeId id : previewed_) {
    const auto found = strokes_.find(id);
    if (found != strokes_.end()) found->second.is_previewed = on;
  }
}

InkScene::SeenStrokes InkScene::look(const std::vector<StrokeId>& ids) const {
  SeenStrokes seen;
  for (const StrokeId id : ids) {
    const auto found = strokes_.find(id);
    if (found == strokes_.end()) continue;
    const SceneStroke& s = found->second;
    seen.push_back({id, s.stroke, s.layer->id, s.layer->is_visible, height(s), 0});
  }
  std::sort(seen.begin(), seen.end(),
            [](const Seen& a, const Seen& b) { return a.height < b.height; });
  std::size_t in_layer = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    in_layer = i > 0 && seen[i].layer == seen[i - 1].layer ? in_layer + 1 : 0;
    seen[i].below = seen[i].height.rank - in_layer;
  }
  return seen;
}

/// Adds the area of a stroke.
void InkScene::add_seen(const Stroke& stroke, InkDamage& damage) const {
  styles_.find(stroke.medium()) ? damage.push_back(stroke.bounds()) : add_ink(stroke, damage);
}

/// Adds the area in which two shapes of a stroke differ. A style depends on the whole stroke.
void InkScene::add_change(const Stroke& before, const Stroke& after, InkDamage& damage) const {
  const bool has_style = styles_.find(before.medium()) || styles_.find(after.medium());
  if (!has_style) return add_difference(before, after, damage);
  damage.push_back(before.bounds());
  damage.push_back(after.bounds());
}

/// Adds the visible differences. A stroke looks the same if neither its shape nor the strokes below
/// it change, even if its index does.
void InkScene::compare(SeenStrokes before, SeenStrokes after, InkDamage& damage) const {
  const auto by_id = [](const Seen& a, const Seen& b) { return a.id < b.id; };
  const auto stays = [&](const SeenStrokes& in, const SeenStrokes& other) {
    SeenStrokes sorted = other;
    std::sort(sorted.begin(), sorted.end(), by_id);
    std::vector<StrokeId> ids;
    for (const Seen& s : in) {
      if (std::binary_search(sorted.begin(), sorted.end(), s, by_id)) ids.push_back(s.id);
    }
    return ids;
  };
  const bool same_order = stays(before, after) == stays(after, before);
  std::sort(before.begin(), before.end(), by_id);
  std::sort(after.begin(), after.end(), by_id);
  auto b = before.begin(), a = after.begin();
  while (b != before.end() || a != after.end()) {
    if (a == after.end() || (b != before.end() && b->id < a->id)) {
      if (b->is_visible) add_seen(*b->stroke, damage);
      ++b;
    } else if (b == before.end() || a->id < b->id) {
      if (a->is_visible) add_seen(*a->stroke, damage);
      ++a;
    } else {
      const bool same_place = same_order && a->layer == b->layer && a->below == b->below &&
                              a->is_visible && b->is_visible;
      if (!same_place) {
        if (b->is_visible) add_seen(*b->stroke, damage);
        if (a->is_visible) add_seen(*a->stroke, damage);
      } else if (a->stroke != b->stroke) {
        add_change(*b->stroke, *a->stroke, damage);
      }
      ++a;
      ++b;
    }
  }
}

void InkScene::set_look(SceneLayer& layer, const LayerState& state) {
  layer.is_visible = felt::is_visible(state);
  layer.opacity = state.opacity;
  layer.blend = state.blend;
  layer.group = state.group;
  const bool is_decoded =
      layer.picture && state.picture &&
      (layer.picture->data == state.picture->data || *layer.picture->data == *state.picture->data);
  layer.picture = state.picture;
  if (!is_decoded) layer.pixels = pixels_of(layer);
}

/// Decodes the picture of a layer, or returns the pixels that another layer has of it.
std::shared_ptr<const PicturePixels> InkScene::pixels_of(const SceneLayer& layer) const {
  if (!layer.picture) return nullptr;
  const PictureData& data = *layer.picture->data;
  for (const auto& [id, other] : layers_) {
    const bool is_same = other.id != layer.id && other.pixels && other.picture &&
                         (other.picture->data.get() == &data || *other.picture->data == data);
    if (is_same) return other.pixels;
  }
  return PicturePixels::decode(data).value_or(nullptr);
}

/// Adds the area of the layers that look different: all ink of those that are shown, hidden, moved
/// or faded, and the pictures. Call before and after the change.
void InkScene::add_layers(const Edit& edit, InkDamage& damage) const {
  for (const LayerChange& c : edit.layers) {
    const auto found = layers_.find(c.id);
    if (found == layers_.end() || !found->second.is_visible) continue;
    const bool same_ink =
        c.before && c.after && c.before->visible == c.after->visible &&
        c.before_index == c.after_index && c.before->opacity == c.after->opacity &&
        c.before->blend == c.after->blend && equal_groups(c.before->group, c.after->group);
    if (same_ink && c.before->picture == c.after->picture) continue;
    const SceneLayer& layer = found->second;
    Rect all = layer.picture ? bounds_of(*layer.picture) : Rect{};
    if (!same_ink) layer.order.for_each([&all](const SceneStroke& s) { all.extend(s.box); });
    if (!same_ink) {
      for (const FillId id : layer.fills) all.extend(fills_.at(id).box);
    }
    if (!all.empty()) damage.push_back(all);
  }
}

/// Returns the order of layers after the edit. Fails if a layer does not match the edit.
Result<std::vector<LayerId>> InkScene::new_order(const Edit& edit) const {
  Moves<LayerId> moves;
  for (const LayerChange& c : edit.layers) {
    const bool is_there = layers_.count(c.id) > 0;
    const bool fits = c.before ? is_there && c.before_index < layer_order_.size() &&
                                     layer_order_[c.before_index] == c.id
                               : !is_there;
    if (!fits) {
      return fail(ErrorCode::kInvalidArgument,
                  "layer " + std::to_string(c.id.value) + " does not match the edit");
    }
    if (c.before) moves.remove(c.before_index);
    if (c.after) moves.add(c.after_index, c.id);
  }
  std::vector<LayerId> order = layer_order_;
  return moves.reorder<LayerId>(layer_order_).map([&order](const Reordered<LayerId>& change) {
    change.apply_to(order);
    return std::move(order);
  });
}

Result<void> InkScene::check(const Edit& edit) const {
  if (const auto order = new_order(edit); !order) return tl::unexpected(order.error());
  if (const auto lists = new_fills(edit); !lists) return tl::unexpected(lists.error());
  for (const FillChange& c : edit.fills) {
    const bool is_made = std::any_of(edit.layers.begin(), edit.layers.end(), [&c](const auto& l) {
      return l.id == c.after_place.layer && l.after;
    });
    if (c.after && !is_made && !layers_.contains(c.after_place.layer)) {
      return fail(ErrorCode::kInvalidArgument,
                  "layer " + std::to_string(c.after_place.layer.value) + " does not exist");
    }
  }
  for (const StrokeChange& c : edit.changes) {
    const SceneStroke* present = find(c.id);
    if (!c.before && present) return misfit(c.id, "already exists");
    if (!c.before) continue;
    if (!present) return misfit(c.id, "does not exist");
    if (present->layer->id != c.before_place.layer || present->rank() != c.before_place.index) {
      return misfit(c.id, "is not at the index in the edit");
    }
  }
  return check_places(edit);
}

Result<void> InkScene::check_places(const Edit& edit) const {
  if (only_replaces(edit)) return {};
  const std::map<LayerId, LayerWork> plans = plan(edit);
  for (const LayerChange& c : edit.layers) {
    const auto found = layers_.find(c.id);
    if (c.after || found == layers_.end()) continue;
    const auto work = plans.find(c.id);
    const std::size_t gone = work == plans.end() ? 0 : work->second.removed.size();
    if (found->second.order.size() != gone) {
      return fail(ErrorCode::kInvalidArgument, "layer " + std::to_string(c.id.value) +
                                                   " cannot be removed, because it has strokes");
    }
  }
  for (const auto& [id, work] : plans) {
    const auto found = layers_.find(id);
    const bool is_made = std::any_of(edit.layers.begin(), edit.layers.end(),
                                     [id = id](const auto& c) { return c.id == id && c.after; });
    if (found == layers_.end() && !is_made) {
      return fail(ErrorCode::kInvalidArgument,
                  "layer " + std::to_string(id.value) + " does not exist");
    }
    const std::size_t size = (found == layers_.end() ? 0 : found->second.order.size()) -
                             work.removed.size() + work.added.size();
    for (std::size_t i = 0; i < work.added.size(); ++i) {
      const bool is_twice = i > 0 && work.added[i - 1].first == work.added[i].first;
      if (work.added[i].first >= size || is_twice) {
        return misfit(work.added[i].second->id, "cannot be moved to the index in the edit");
      }
    }
  }
  return {};
}

void InkScene::set_shape(SceneStroke& stroke, const StrokePtr& shape) {
  if (stroke.stroke == shape) return;
  stroke.stroke = shape;
  stroke.box = shape->bounds();
}

void InkScene::replace(const Edit& edit) {
  for (const StrokeChange& c : edit.changes) {
    SceneStroke& stroke = strokes_.at(c.id);
    stroke.layer->grid.remove(stroke);
    set_shape(stroke, c.after);
    stroke.layer->grid.add(stroke);
  }
}

/// Applies the edit. Requires that it is valid.
void InkScene::carry_out(const Edit& edit) {
  std::vector<LayerId> order_after = *new_order(edit);
  for (const LayerChange& c : edit.layers) {
    SceneLayer& layer = layers_[c.id];
    layer.id = c.id;
    if (c.after) set_look(layer, *c.after);
  }
  change_fills(edit);
  const std::map<LayerId, LayerWork> work = plan(edit);
  for (const auto& [id, w] : work) {
    StrokeOrder& order = layers_.at(id).order;
    for (const std::size_t index : w.removed) order.erase(index);
  }
  for (const StrokeChange& c : edit.changes) {
    if (c.before) {
      SceneStroke& stroke = strokes_.at(c.id);
      stroke.layer->grid.remove(stroke);
      if (!c.after) strokes_.erase(c.id);
    }
    if (!c.after) continue;
    SceneStroke& stroke = strokes_[c.id];
    stroke.id = c.id;
    set_shape(stroke, c.after);
    stroke.layer = &layers_.at(c.after_place.layer);
    stroke.layer->grid.add(stroke);
  }
  for (const auto& [id, w] : work) {
    StrokeOrder& order = layers_.at(id).order;
    for (const auto& [index, c] : w.added) order.insert(index, strokes_.at(c->id));
    order.number();
  }
  layer_order_ = std::move(order_after);
  for (const LayerChange& c : edit.layers) {
    if (!c.after) layers_.erase(c.id);
  }
  for (std::size_t i = 0; i < layer_order_.size(); ++i) layers_.at(layer_order_[i]).position = i;
}

void InkScene::find(const Rect& area, std::vector<const SceneStroke*>& found,
                    std::optional<LayerId> above) const {
  found.clear();
  const bool covers = above.has_value();
  for (const LayerId id : layer_order_) {
    if (above) {
      if (id == *above) above.reset();
      continue;
    }
    const SceneLayer& layer = layers_.at(id);
    if (!layer.is_visible || (covers && layer.is_blended())) continue;
    const auto first = static_cast<std::ptrdiff_t>(found.size());
    layer.grid.find(area, found);
    std::sort(found.begin() + first, found.end(),
              [](const SceneStroke* a, const SceneStroke* b) { return a->rank() < b->rank(); });
  }
}

void InkScene::find_ink(const Rect& area, std::vector<SceneInk>& found,
                        std::optional<LayerId> above) const {
  std::vector<const SceneStroke*> strokes;
  find(area, strokes, above);
  found.clear();
  auto next = strokes.begin();
  const bool covers = above.has_value();
  for (const LayerId id : layer_order_) {
    if (above) {
      if (id == *above) above.reset();
      continue;
    }
    const SceneLayer& layer = layers_.at(id);
    if (!layer.is_visible || (covers && layer.is_blended())) continue;
    for (const FillId fill_id : layer.fills) {
      const SceneFill& fill = fills_.at(fill_id);
      if (fill.box.intersects(area)) found.push_back({nullptr, &fill, &layer});
    }
    for (; next != strokes.end() && (*next)->layer == &layer; ++next) {
      found.push_back({*next, nullptr, &layer});
    }
  }
}

std::vector<const SceneLayer*> InkScene::special_layers(std::optional<LayerId> above) const {
  std::vector<const SceneLayer*> special;
  const bool covers = above.has_value();
  for (const LayerId id : layer_order_) {
    if (above) {
      if (id == *above) above.reset();
      continue;
    }
    const SceneLayer& layer = layers_.at(id);
    if (covers && layer.is_blended()) continue;
    if (layer.is_visible && layer.is_special()) special.push_back(&layer);
  }
  return special;
}

const SceneStroke* InkScene::find(StrokeId id) const {
  const auto found = strokes_.find(id);
  return found == strokes_.end() ? nullptr : &found->second;
}

}  // namespace felt
