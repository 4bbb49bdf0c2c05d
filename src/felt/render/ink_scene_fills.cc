// The fills of a scene.

#include <algorithm>
#include <string>

#include "felt/document/reorder.h"
#include "felt/render/ink_scene.h"

namespace felt {

/// Returns how fills look. A fill that is not visible is null.
InkScene::SeenFills InkScene::look_at_fills(const std::vector<FillId>& ids) const {
  SeenFills seen;
  for (const FillId id : ids) {
    SeenFill& s = seen[id];
    const auto found = fills_.find(id);
    if (found == fills_.end()) continue;
    const SceneLayer& layer = layers_.at(found->second.layer);
    if (!layer.is_visible) continue;
    const auto at = std::find(layer.fills.begin(), layer.fills.end(), id);
    s = {found->second.fill,
         found->second.box,
         {layer.position, static_cast<std::size_t>(at - layer.fills.begin())}};
  }
  return seen;
}

void InkScene::compare_fills(const SeenFills& before, const SeenFills& after, InkDamage& damage) {
  for (const auto& [id, was] : before) {
    const SeenFill& is = after.at(id);
    if (was.fill == is.fill && was.height == is.height) continue;
    if (was.fill) damage.push_back(was.box);
    if (is.fill) damage.push_back(is.box);
  }
}

/// Returns the lists of fills of the layers in which the edit changes fills. Fails if a fill does
/// not match the edit, or if a removed layer would keep fills.
Result<InkScene::FillLists> InkScene::new_fills(const Edit& edit) const {
  std::map<LayerId, Moves<FillId>> moves;
  const auto list = [this](LayerId id) {
    const auto found = layers_.find(id);
    return found == layers_.end() ? std::vector<FillId>() : found->second.fills;
  };
  for (const FillChange& c : edit.fills) {
    bool fits = fills_.contains(c.id) == (c.before != nullptr);
    if (fits && c.before) {
      const std::vector<FillId> present = list(c.before_place.layer);
      fits = c.before_place.index < present.size() && present[c.before_place.index] == c.id;
    }
    if (!fits) {
      return fail(ErrorCode::kInvalidArgument,
                  "fill " + std::to_string(c.id.value) + " does not match the edit");
    }
    if (c.before) moves[c.before_place.layer].remove(c.before_place.index);
    if (c.after) moves[c.after_place.layer].add(c.after_place.index, c.id);
  }
  FillLists lists;
  for (auto& [id, m] : moves) {
    std::vector<FillId>& fills = lists[id] = list(id);
    const auto order = m.reorder<FillId>(fills);
    if (!order) return tl::unexpected(order.error());
    order->apply_to(fills);
  }
  for (const LayerChange& c : edit.layers) {
    if (!c.after && !(lists.contains(c.id) ? lists[c.id] : list(c.id)).empty()) {
      return fail(ErrorCode::kInvalidArgument, "layer " + std::to_string(c.id.value) +
                                                   " cannot be removed, because it has fills");
    }
  }
  return lists;
}

/// Applies the changes of fills. Requires that they are valid and that their layers exist.
void InkScene::change_fills(const Edit& edit) {
  const FillLists lists = *new_fills(edit);
  for (const auto& [id, fills] : lists) layers_.at(id).fills = fills;
  for (const FillChange& c : edit.fills) {
    if (c.after) {
      fills_[c.id] = {c.after, fill_bounds(*c.after), c.after_place.layer};
    } else {
      fills_.erase(c.id);
    }
  }
}

bool InkScene::has_fill(const Rect& area) const {
  return std::any_of(fills_.begin(), fills_.end(), [&](const auto& entry) {
    return entry.second.box.intersects(area) && layers_.at(entry.second.layer).is_visible;
  });
}

}  // namespace felt
