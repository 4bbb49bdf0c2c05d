#include "felt/session/group_edit.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "felt/document/edit_builder.h"
#include "felt/session/layer_edit.h"

namespace felt {
namespace {

using Do = LayerEvent::Do;

tl::unexpected<Error> refused_group(std::string why) {
  return fail(ErrorCode::kInvalidArgument, std::move(why));
}

/// The layers of a document while an event changes their order and their states.
class LayerStack {
 public:
  struct Entry {
    LayerId id;
    std::size_t before = 0;  // index in the document
    bool is_moved = false;
    std::unique_ptr<LayerState> changed = {};  // null: as in the document
  };
  /// Indices of neighbours; `last` is not included.
  struct Range {
    std::size_t first = 0, last = 0;
    [[nodiscard]] std::size_t size() const noexcept { return last - first; }
  };

  explicit LayerStack(const Document& document) : document_(document) {
    entries_.reserve(document.layers().size());
    for (const Layer& l : document.layers()) entries_.push_back({l.id, entries_.size()});
  }

  [[nodiscard]] std::size_t size() const noexcept { return entries_.size(); }
  /// Returns the state of a layer, to change it.
  [[nodiscard]] LayerState& state(Entry& entry) const {
    if (!entry.changed) {
      entry.changed = std::make_unique<LayerState>(document_.layers()[entry.before].state());
    }
    return *entry.changed;
  }
  [[nodiscard]] LayerState& state(std::size_t i) { return state(entries_[i]); }
  [[nodiscard]] const LayerGroupPtr& group(const Entry& entry) const {
    return entry.changed ? entry.changed->group : document_.layers()[entry.before].group;
  }
  [[nodiscard]] const LayerGroupPtr& group(std::size_t i) const { return group(entries_[i]); }

  /// Returns the layers of a group; an empty range if the group does not exist.
  [[nodiscard]] Range range_of(GroupId id) const {
    const auto is_in = [this, id](const Entry& e) {
      const LayerGroupPtr& own = group(e);
      return own && own->id == id;
    };
    const auto first = std::find_if(entries_.begin(), entries_.end(), is_in);
    const auto last = std::find_if_not(first, entries_.end(), is_in);
    return {static_cast<std::size_t>(first - entries_.begin()),
            static_cast<std::size_t>(last - entries_.begin())};
  }
  /// Returns the layer with this index, and the others of its group.
  [[nodiscard]] Range unit_of(std::size_t i) const {
    Range unit{i, i + 1};
    while (unit.first > 0 && same_group(group(unit.first - 1), group(i))) --unit.first;
    while (unit.last < size() && same_group(group(unit.last), group(i))) ++unit.last;
    return unit;
  }

  /// Returns true if a layer that is inserted at this index would be between two layers of the same
  /// group.
  [[nodiscard]] bool splits(std::size_t i) const {
    return i > 0 && i < size() && same_group(group(i - 1), group(i));
  }
  /// Returns the nearest index that splits no group.
  [[nodiscard]] std::size_t outside(std::size_t i) const {
    if (!splits(i)) return std::min(i, size());
    const Range group = unit_of(i);
    return i - group.first < group.last - i ? group.first : group.last;
  }

  /// Takes layers out of the order. Their order does not change.
  std::vector<Entry> take(Range range) {
    const auto first = entries_.begin() + static_cast<std::ptrdiff_t>(range.first);
    const auto last = entries_.begin() + static_cast<std::ptrdiff_t>(range.last);
    std::vector<Entry> taken(std::make_move_iterator(first), std::make_move_iterator(last));
    entries_.erase(first, last);
    return taken;
  }
  /// Takes the layers with these ids, which are ascending, out of the order. Their order does not
  /// change.
  std::vector<Entry> take(std::span<const LayerId> ids) {
    const auto first = std::stable_partition(entries_.begin(), entries_.end(), [&](const Entry& e) {
      return !std::binary_search(ids.begin(), ids.end(), e.id);
    });
    return take(Range{static_cast<std::size_t>(first - entries_.begin()), size()});
  }
  void insert(std::size_t index, std::vector<Entry> taken) {
    for (Entry& e : taken) e.is_moved = true;
    entries_.insert(entries_.begin() + static_cast<std::ptrdiff_t>(std::min(index, size())),
                    std::make_move_iterator(taken.begin()), std::make_move_iterator(taken.end()));
  }

  /// Returns the changes since the document as an edit; an empty edit if nothing has changed.
  [[nodiscard]] Edit edit(std::string label) const {
    Edit edit{std::move(label), {}, {}};
    bool is_same = true;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const Entry& e = entries_[i];
      is_same = is_same && e.before == i;
      if (!e.is_moved && !e.changed) continue;
      const LayerState before = document_.layers()[e.before].state();
      const LayerState& after = e.changed ? *e.changed : before;
      const bool is_equal = before == after;
      is_same = is_same && is_equal;
      if (e.is_moved || !is_equal) edit.layers.push_back({e.id, before, after, e.before, i});
    }
    return is_same ? Edit{} : edit;
  }

 private:
  const Document& document_;
  std::vector<Entry> entries_;
};

using LayerRange = LayerStack::Range;

/// Returns the index to which kRaise or kLower moves these layers, in the order without them. In a
/// group, they pass one layer; outside of groups (`group` is null), a layer or a whole group.
std::size_t passed(const LayerStack& stack, LayerRange range, Do what, const LayerGroup* group) {
  const LayerRange all = group ? stack.range_of(group->id) : LayerRange{0, stack.size()};
  if (what == Do::kRaise) {
    if (range.last >= all.last) return range.first;
    return range.first + (group ? 1 : stack.unit_of(range.last).size());
  }
  if (range.first <= all.first) return range.first;
  return group ? range.first - 1 : stack.unit_of(range.first - 1).first;
}

Result<Edit> moved_group(LayerStack& stack, LayerRange range, const LayerEvent& event) {
  std::size_t index = event.index;
  if (event.what != Do::kMove) index = passed(stack, range, event.what, nullptr);
  auto layers = stack.take(range);
  stack.insert(stack.outside(std::min(index, stack.size())), std::move(layers));
  return stack.edit(label_of(event.what));
}

/// Gives all layers of the group the same changed group.
Result<Edit> changed_group(LayerStack& stack, LayerRange range, const LayerEvent& event) {
  LayerGroup group = *stack.group(range.first);
  switch (event.what) {
    case Do::kRename:
      if (event.name.empty()) return refused_group("name: is empty");
      group.name = event.name;
      break;
    case Do::kShow:
    case Do::kHide:
      group.visible = event.what == Do::kShow;
      break;
    case Do::kLock:
    case Do::kUnlock:
      group.locked = event.what == Do::kLock;
      break;
    case Do::kOpacity:
      if (!(event.opacity >= 0.0 && event.opacity <= 1.0)) {
        return refused_group("opacity: is not a number from 0 to 1");
      }
      group.opacity = event.opacity;
      break;
    case Do::kBlend:
      group.blend = event.mode;
      break;
    default:
      return refused_group("a group of layers cannot do this");
  }
  const auto shared = std::make_shared<const LayerGroup>(std::move(group));
  for (std::size_t i = range.first; i < range.last; ++i) stack.state(i).group = shared;
  return stack.edit(label_of(event.what));
}

/// Takes the layers out of their group. Its visibility, lock and opacity go to the layers, and so
/// does its blend mode, unless a layer has one of its own.
Result<Edit> dissolved_group(LayerStack& stack, LayerRange range) {
  for (std::size_t i = range.first; i < range.last; ++i) {
    LayerState& state = stack.state(i);
    const LayerGroup& group = *state.group;
    state.visible = is_visible(state);
    state.locked = is_locked(state);
    state.opacity *= group.opacity;
    if (state.blend == BlendMode::kNormal) state.blend = group.blend;
    state.group = nullptr;
  }
  return stack.edit(label_of(Do::kUngroup));
}

Edit removed_group(const Document& document, LayerRange range) {
  EditBuilder builder(document);
  const std::span<const Layer> layers = document.layers();
  for (std::size_t i = range.first; i < range.last; ++i) {
    for (const StrokeId id : layers[i].strokes) builder.remove(id);
    for (const FillId id : layers[i].fills) builder.remove_fill(id);
  }
  Edit edit = std::move(builder).build(label_of(Do::kRemove));
  for (std::size_t i = range.first; i < range.last; ++i) {
    edit.layers.push_back({layers[i].id, layers[i].state(), std::nullopt, i, 0});
  }
  return edit;
}

Result<Edit> copied_group(const Document& document, LayerRange range) {
  const Result<CopiedStrokes> copies =
      copied_strokes(document, document.layers().subspan(range.first, range.size()));
  if (!copies) return tl::unexpected(copies.error());
  LayerGroup group = *document.layers()[range.first].group;
  group.id = document.new_group_id();
  group.name = copied_name(group.name);
  const auto shared = std::make_shared<const LayerGroup>(std::move(group));
  Edit edit{label_of(Do::kDuplicate), {}, {}};
  for (std::size_t i = range.first; i < range.last; ++i) {
    const Layer& layer = document.layers()[i];
    LayerState state = layer.state();
    state.group = shared;
    add_copy(document, layer, std::move(state), i + range.size(), *copies, edit);
  }
  return edit;
}

Result<Edit> new_group(const Document& document, const LayerEvent& event) {
  if (event.layers.empty()) return refused_group("ids: has no layer");
  for (const LayerId id : event.layers) {
    if (!document.layer(id)) {
      return fail(ErrorCode::kNotFound, "no layer " + std::to_string(id.value));
    }
  }
  LayerStack stack(document);
  std::vector<LayerId> ids = event.layers;
  std::sort(ids.begin(), ids.end());
  std::vector<LayerStack::Entry> chosen = stack.take(ids);
  // The number of other layers below the highest one.
  const std::size_t index = chosen.back().before + 1 - chosen.size();
  LayerGroup group{document.new_group_id(), event.name};
  if (group.name.empty()) group.name = "Group " + std::to_string(group.id.value);
  const auto shared = std::make_shared<const LayerGroup>(std::move(group));
  for (LayerStack::Entry& e : chosen) stack.state(e).group = shared;
  stack.insert(stack.outside(index), std::move(chosen));
  return stack.edit(label_of(Do::kGroup));
}

/// Returns the group of a layer after it was moved to `index` of the other layers. If the layer
/// stays next to the others of its group, it stays in the group.
LayerGroupPtr group_at(const LayerStack& others, std::size_t index, const LayerGroupPtr& own) {
  if (others.splits(index)) return others.group(index);
  if (!own) return nullptr;
  const LayerRange range = others.range_of(own->id);
  const bool is_next = index == range.first || index == range.last;
  return range.size() == 0 || is_next ? own : nullptr;
}

}  // namespace

Result<Edit> group_edit(const Document& document, const LayerEvent& event) {
  if (event.what == Do::kGroup) return new_group(document, event);
  LayerStack stack(document);
  const LayerRange range = stack.range_of(event.group.value_or(GroupId{}));
  if (range.size() == 0) {
    return fail(ErrorCode::kNotFound,
                "no group " + std::to_string(event.group.value_or(GroupId{}).value));
  }
  switch (event.what) {
    case Do::kUngroup:
      return dissolved_group(stack, range);
    case Do::kRemove:
      return removed_group(document, range);
    case Do::kDuplicate:
      return copied_group(document, range);
    case Do::kMove:
    case Do::kRaise:
    case Do::kLower:
      return moved_group(stack, range, event);
    default:
      return changed_group(stack, range, event);
  }
}

Result<Edit> layer_move(const Document& document, const LayerEvent& event) {
  LayerStack stack(document);
  const std::size_t at = document.layer_index(event.layer);
  const LayerRange range{at, at + 1};
  const LayerGroupPtr own = stack.group(range.first);
  std::size_t index = event.index;
  const bool passes = event.what != Do::kMove;
  if (passes) index = passed(stack, range, event.what, own.get());
  std::vector<LayerStack::Entry> taken = stack.take(range);
  index = std::min(index, stack.size());
  const auto set_group = [&](const LayerGroupPtr& group) {
    if (group != own) stack.state(taken.front()).group = group;
  };
  if (!passes && event.group && *event.group) {
    const LayerRange to = stack.range_of(*event.group);
    const bool stays_alone = to.size() == 0 && own && own->id == *event.group;
    if (to.size() == 0 && !stays_alone) {
      return fail(ErrorCode::kNotFound, "no group " + std::to_string(event.group->value));
    }
    index = stays_alone ? stack.outside(index) : std::clamp(index, to.first, to.last);
    if (!stays_alone) set_group(stack.group(to.first));
  } else if (!passes && event.group) {
    index = stack.outside(index);
    set_group(nullptr);
  } else if (!passes) {
    set_group(group_at(stack, index, own));
  }
  stack.insert(index, std::move(taken));
  return stack.edit(label_of(event.what));
}

}  // namespace felt
