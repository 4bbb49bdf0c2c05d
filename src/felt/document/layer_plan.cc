#include "felt/document/layer_plan.h"

#include <algorithm>
#include <string>
#include <utility>

namespace felt {
namespace {

tl::unexpected<Error> layer_misfit(LayerId id, const std::string& what) {
  return fail(ErrorCode::kInvalidArgument, "layer " + std::to_string(id.value) + ' ' + what);
}

tl::unexpected<Error> group_misfit(const LayerGroupPtr& group, const std::string& what) {
  return fail(ErrorCode::kInvalidArgument,
              "the layers of group " + std::to_string(group->id.value) + ' ' + what);
}

/// Returns true if the change leaves the layer at its index, as far as it is alone.
bool stays_in_place(const LayerChange& c) {
  return c.before && c.after && c.before_index == c.after_index;
}

void set_state_of(Layer& layer, const LayerState& state) {
  layer.name = state.name;
  layer.visible = is_visible(state);
  layer.locked = is_locked(state);
  layer.own_visible = state.visible;
  layer.own_locked = state.locked;
  layer.group = state.group;
  layer.opacity = state.opacity;
  layer.picture = state.picture;
  layer.blend = state.blend;
  layer.timing = state.timing;
}

}  // namespace

Result<void> LayerPlan::check_layer(const LayerChange& c) const {
  const Layer* present = table_.find(c.id);
  if (!c.before) {
    return present ? Result<void>(layer_misfit(c.id, "already exists")) : Result<void>();
  }
  if (!present) return layer_misfit(c.id, "does not exist");
  if (table_.index_of(c.id) != c.before_index) {
    return layer_misfit(c.id, "is not at index " + std::to_string(c.before_index));
  }
  if (present->state() != *c.before) return layer_misfit(c.id, "has changed in the meantime");
  return {};
}

Result<void> LayerPlan::prepare() {
  Moves<LayerId> moves;
  for (const LayerChange& c : changes_) {
    if (Result<void> fits = check_layer(c); !fits) return fits;
    by_id_[c.id] = &c;
    if (c.after) placed_.push_back(&c);
    if (stays_in_place(c)) {
      moves.keep(c.before_index, c.id);
      continue;
    }
    moves_ = true;
    if (c.before) moves.remove(c.before_index);
    if (c.after) moves.add(c.after_index, c.id);
  }
  Result<Reordered<LayerId>> order = moves.reorder<LayerId>(table_.ids());
  if (!order) return tl::unexpected(order.error());
  order_ = *std::move(order);
  if (order_.size == 0) return fail(ErrorCode::kInvalidArgument, "no layer would be left");
  std::sort(placed_.begin(), placed_.end(), [](const LayerChange* a, const LayerChange* b) {
    return a->after_index < b->after_index;
  });
  return check_groups();
}

bool LayerPlan::is_kept(LayerId id) const {
  const auto changed = by_id_.find(id);
  return changed == by_id_.end() ? table_.find(id) != nullptr : changed->second->after.has_value();
}

/// Checks that the layers of every group are neighbours and have equal groups after the edit. The
/// unchanged layers fulfil this among themselves, so only the runs of changed layers are visited,
/// each with the unchanged layers directly below and above it.
Result<void> LayerPlan::check_groups() const {
  const bool changes_groups =
      moves_ || std::any_of(placed_.begin(), placed_.end(), [](const LayerChange* c) {
        return !equal_groups(c->before->group, c->after->group);
      });
  if (!changes_groups) return {};
  std::set<GroupId> apart;  // groups of runs that the layers next to the run do not have
  for (std::size_t first = 0; first < placed_.size();) {
    std::size_t last = first + 1;
    while (last < placed_.size() &&
           placed_[last]->after_index == placed_[last - 1]->after_index + 1) {
      ++last;
    }
    if (Result<void> fits = check_run({first, last}, apart); !fits) return fits;
    first = last;
  }
  if (apart.empty()) return {};
  for (const Layer& l : table_.layers()) {
    if (l.group && apart.contains(l.group->id) && !by_id_.contains(l.id)) {
      return group_misfit(l.group, "are not neighbours");
    }
  }
  return {};
}

Result<void> LayerPlan::check_run(Run run, std::set<GroupId>& apart) const {
  const std::size_t lowest = placed_[run.first]->after_index;
  const std::size_t above_index = placed_[run.last - 1]->after_index + 1;
  const LayerGroupPtr below = lowest > 0 ? unchanged_group(lowest - 1) : nullptr;
  const LayerGroupPtr above = above_index < order_.size ? unchanged_group(above_index) : nullptr;
  LayerGroupPtr last = below;
  const auto go_on = [&](const LayerGroupPtr& group) -> Result<void> {
    if (same_group(group, last)) {
      return equal_groups(group, last) ? Result<void>() : group_misfit(group, "differ in it");
    }
    // The block of `last` ends here.
    if (last && same_group(last, above)) return group_misfit(last, "are not neighbours");
    if (group && same_group(group, below)) return group_misfit(group, "are not neighbours");
    if (group && !same_group(group, above) && !apart.insert(group->id).second) {
      return group_misfit(group, "are not neighbours");
    }
    last = group;
    return {};
  };
  for (std::size_t i = run.first; i < run.last; ++i) {
    const LayerGroupPtr& group = placed_[i]->after->group;
    if (group && !group->id) return fail(ErrorCode::kInvalidArgument, "a group without an id");
    if (Result<void> fits = go_on(group); !fits) return fits;
  }
  return above ? go_on(above) : Result<void>();
}

/// Returns the group of the layer at this index after the edit, which the edit does not change.
LayerGroupPtr LayerPlan::unchanged_group(std::size_t index) const {
  const LayerId id = index < order_.from ? table_.ids()[index] : order_.tail[index - order_.from];
  return table_.find(id)->group;
}

void LayerPlan::carry_out(LayerTable& table) const {
  if (moves_) {
    std::vector<LayerTable::Move> moves;
    for (const LayerChange& c : changes_) {
      LayerTable::Move& move = moves.emplace_back(LayerTable::Move{c.id, {}, {}});
      if (c.before) move.from = c.before_index;
      if (c.after) move.to = c.after_index;
    }
    table.rearrange(moves);
  }
  for (const LayerChange* c : placed_) set_state_of(*table.find(c->id), *c->after);
}

}  // namespace felt
