#include "felt/session/layered_edit.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "felt/base/check.h"

namespace felt {
namespace {

/// Returns one more than the largest id in these changes, or `next` if that is larger.
template <class Change>
std::uint64_t id_after(const std::vector<Change>& changes, std::uint64_t next) {
  for (const Change& c : changes) next = std::max(next, c.id.value + 1);
  return next;
}

}  // namespace

LayeredEdit::LayeredEdit(const Document& document, Edit& edit)
    : document_(document), edit_(edit), next_id_(document.new_id().value) {
  next_id_ = id_after(edit.changes, next_id_);
  next_id_ = id_after(edit.fills, next_id_);
  next_id_ = id_after(edit.guides, next_id_);
  next_id_ = id_after(edit.symmetries, next_id_);
  next_id_ = id_after(edit.body_edits, next_id_);
  for (const StrokeChange& c : edit.changes) {
    sequence_.push_back(c.id);
    changes_.emplace(c.id, c);
  }
  for (const StrokeChange& c : edit.changes) {
    if (c.before) order_of(c.before_place.layer);
    if (c.after) order_of(c.after_place.layer);
  }
}

/// Makes the order of a layer: its strokes before the edit, with the added and moved strokes of the
/// edit at their positions. A removed stroke keeps a place, so that others can be added above it.
LayeredEdit::Order& LayeredEdit::order_of(LayerId layer) {
  const auto [found, is_new] = orders_.try_emplace(layer, Order{layer, {}});
  if (!is_new) return found->second;
  std::map<std::size_t, StrokeId> placed;  // by position after the edit
  for (const auto& [id, c] : changes_) {
    if (c.after && c.after_place.layer == layer) placed.emplace(c.after_place.index, id);
  }
  std::vector<StrokeId>& order = found->second.strokes;
  std::size_t index = 0;  // of the next stroke that exists after the edit
  const auto place = [&] {
    for (auto at = placed.find(index); at != placed.end(); at = placed.find(++index)) {
      order.push_back(at->second);
    }
  };
  const Layer* present = document_.layer(layer);
  for (const StrokeId id : present ? present->strokes : std::vector<StrokeId>()) {
    const auto changed = changes_.find(id);
    if (changed != changes_.end() && !changed->second.after) {
      order.push_back(id);
      continue;
    }
    place();
    if (changed != changes_.end()) continue;  // has a position of its own
    order.push_back(id);
    ++index;
  }
  place();
  return found->second;
}

StrokePtr LayeredEdit::after(StrokeId id) const {
  const auto changed = changes_.find(id);
  return changed != changes_.end() ? changed->second.after : document_.find(id);
}

StrokeChange& LayeredEdit::change_of(StrokeId id) {
  const auto found = changes_.find(id);
  if (found != changes_.end()) return found->second;
  const LayerId layer = document_.layer_of(id);
  order_of(layer);
  sequence_.push_back(id);
  const StrokePtr stroke = document_.find(id);
  return changes_.emplace(id, StrokeChange{id, stroke, stroke, {layer, 0}, {layer, 0}})
      .first->second;
}

void LayeredEdit::set(StrokeId id, StrokePtr stroke) {
  StrokeChange& change = change_of(id);
  if (!change.after && stroke) change.after_place = {change.before_place.layer, 0};
  change.after = std::move(stroke);
}

void LayeredEdit::drop(StrokeId id) {
  const auto found = changes_.find(id);
  if (found == changes_.end() || found->second.before) return;
  std::erase(order_of(found->second.after_place.layer).strokes, id);
  std::erase(sequence_, id);
  changes_.erase(found);
}

StrokeId LayeredEdit::add_above(StrokeId below, StrokePtr stroke) {
  const auto known = changes_.find(below);
  const LayerId layer = known == changes_.end() ? document_.layer_of(below)
                        : known->second.after   ? known->second.after_place.layer
                                                : known->second.before_place.layer;
  std::vector<StrokeId>& order = order_of(layer).strokes;
  const auto at = std::find(order.rbegin(), order.rend(), below);
  FELT_CHECK(at != order.rend());
  const StrokeId id{next_id_++};
  order.insert(at.base(), id);
  sequence_.push_back(id);
  changes_.emplace(id, StrokeChange{id, nullptr, std::move(stroke), {}, {layer, 0}});
  return id;
}

void LayeredEdit::add_group(SymmetryGroup group) {
  edit_.symmetries.push_back(
      {{next_id_++}, nullptr, std::make_shared<const SymmetryGroup>(std::move(group))});
}

void LayeredEdit::set_group(SymmetryId id, SymmetryPtr group) {
  edit_.symmetries.push_back({id, document_.find_symmetry(id), std::move(group)});
}

void LayeredEdit::finish() {
  for (auto& [layer, order] : orders_) {
    std::map<StrokeId, std::size_t> before;
    const Layer* present = document_.layer(layer);
    if (present) {
      for (std::size_t i = 0; i < present->strokes.size(); ++i) {
        if (changes_.contains(present->strokes[i])) before[present->strokes[i]] = i;
      }
    }
    for (const auto& [id, index] : before) changes_.at(id).before_place = {layer, index};
    std::size_t index = 0;
    for (const StrokeId id : order.strokes) {
      const auto changed = changes_.find(id);
      const bool exists = changed == changes_.end() || changed->second.after;
      if (changed != changes_.end()) {
        changed->second.after_place = exists ? StrokePlace{layer, index} : StrokePlace{};
      }
      if (exists) ++index;
    }
  }
  edit_.changes.clear();
  for (const StrokeId id : sequence_) {
    StrokeChange& c = changes_.at(id);
    if (!c.before && !c.after) continue;
    if (c.before == c.after && c.before_place == c.after_place) continue;
    edit_.changes.push_back(c);
  }
}

}  // namespace felt
