#pragma once

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "felt/document/document.h"
#include "felt/document/testing/random_fills.h"
#include "felt/document/testing/random_guides.h"
#include "felt/document/testing/small_picture.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::testing {

/// Makes random edits that fit a document, for property tests: strokes are added, removed, replaced
/// and moved between layers, and so are fills; layers are added, removed, renamed, moved and
/// grouped, and get timings; guides, symmetry groups and edits of the body are added, replaced and
/// removed. The same seed gives the
/// same edits.
class RandomEdits {
 public:
  explicit RandomEdits(std::uint64_t seed)
      : seed_(seed), random_(seed), timings_(seed + 5), fills_(~seed), guides_(seed + 77) {}

  Edit next(const Document& document) {
    read(document);
    Edit edit;
    edit.label = "edit " + std::to_string(++count_);
    const auto before = orders_;
    const auto layers_before = layers_;
    for (int k = random_.pick(0, 4); k > 0; --k) remove_stroke();
    if (random_.chance(0.2)) remove_layer();
    if (random_.chance(0.2)) add_layer(document);
    if (random_.chance(0.2)) change_layers();
    for (int k = random_.pick(0, 2); k > 0; --k) move_stroke();
    for (int k = random_.pick(0, 5); k > 0; --k) add_stroke(document.new_id(made_++));
    for (int k = random_.pick(0, 2); k > 0; --k) replace_stroke();
    make_groups_valid();
    write_strokes(document, before, edit);
    write_layers(layers_before, edit);
    std::vector<LayerId> layers;
    for (const auto& layer : layers_) layers.push_back(layer.first);
    fills_.add_changes(document, layers, document.new_fill_id(made_), edit);
    constexpr std::uint64_t kFills = 2;  // that add_changes() may add
    guides_.add_changes(document, document.new_guide_id(made_ + kFills).value, edit);
    return edit;
  }

  StrokePtr stroke() {
    return std::make_shared<const Stroke>(random_stroke(1000 * seed_ + strokes_++));
  }

 private:
  using Orders = std::vector<std::pair<LayerId, std::vector<StrokeId>>>;
  using Layers = std::vector<std::pair<LayerId, LayerState>>;

  void read(const Document& document) {
    orders_.clear();
    layers_.clear();
    changed_.clear();
    made_ = 0;
    for (const Layer& l : document.layers()) {
      orders_.push_back({l.id, l.strokes});
      layers_.push_back({l.id, l.state()});
    }
  }

  std::size_t any(std::size_t size) {
    return static_cast<std::size_t>(random_.pick(0, static_cast<int>(size) - 1));
  }
  std::vector<StrokeId>& any_layer() { return orders_[any(orders_.size())].second; }

  void remove_stroke() {
    auto& strokes = any_layer();
    if (!strokes.empty()) {
      strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(any(strokes.size())));
    }
  }
  void add_stroke(StrokeId id) {
    auto& strokes = any_layer();
    strokes.insert(strokes.begin() + static_cast<std::ptrdiff_t>(any(strokes.size() + 1)), id);
  }
  void move_stroke() {
    auto& strokes = any_layer();
    if (strokes.empty()) return;
    const std::size_t i = any(strokes.size());
    const StrokeId id = strokes[i];
    strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(i));
    add_stroke(id);
  }
  void replace_stroke() {
    auto& strokes = any_layer();
    if (!strokes.empty()) changed_.push_back(strokes[any(strokes.size())]);
  }
  void remove_layer() {
    if (layers_.size() < 2) return;
    const std::size_t i = any(layers_.size());
    orders_.erase(orders_.begin() + static_cast<std::ptrdiff_t>(i));
    layers_.erase(layers_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  void add_layer(const Document& document) {
    const LayerId id = document.new_layer_id();
    const auto i = static_cast<std::ptrdiff_t>(any(layers_.size() + 1));
    orders_.insert(orders_.begin() + i, {id, {}});
    layers_.insert(layers_.begin() + i, {id, {"Layer " + std::to_string(id.value)}});
  }
  void change_layers() {
    std::swap(layers_[any(layers_.size())], layers_[any(layers_.size())]);
    LayerState& state = layers_[any(layers_.size())].second;
    state.visible = random_.chance(0.5);
    state.locked = random_.chance(0.5);
    state.name += "'";
    state.opacity = random_.chance(0.5) ? 1.0 : random_.uniform(0.0, 1.0);
    state.blend = random_.chance(0.7) ? BlendMode::kNormal : BlendMode::kMultiply;
    if (timings_.chance(0.5)) {
      state.timing = timings_.chance(0.3) ? nullptr : shared_timing(random_timing(timings_));
    }
    if (random_.chance(0.3)) state.picture = nullptr;
    if (random_.chance(0.3)) state.picture = red_blue_picture(random_.uniform(-9.0, 99.0), 0.5);
    if (random_.chance(0.3)) change_group(any(layers_.size()));
    if (state.picture && random_.chance(0.3)) {
      state.picture = placed(*state.picture, {0.1, 0.2, -0.2, 0.1, random_.uniform(0.0, 9.0), 5.0});
    }
  }

  /// Puts a few neighbours into a new group, or takes them out of their groups.
  void change_group(std::size_t first) {
    const std::size_t last = std::min(layers_.size(), first + 1 + any(3));
    LayerGroupPtr group;
    if (random_.chance(0.7)) {
      const std::uint64_t id = 100 + ++made_groups_;
      group = std::make_shared<const LayerGroup>(
          LayerGroup{{id},
                     "Group " + std::to_string(id),
                     random_.chance(0.7),
                     random_.chance(0.3),
                     random_.chance(0.5) ? 1.0 : random_.uniform(0.0, 1.0),
                     random_.chance(0.7) ? BlendMode::kNormal : BlendMode::kMultiply});
    }
    for (std::size_t i = first; i < last; ++i) layers_[i].second.group = group;
  }
  void make_groups_valid() {
    std::vector<LayerGroupPtr*> groups;
    for (auto& [id, state] : layers_) groups.push_back(&state.group);
    separate_groups(groups, GroupNumbers::kKept);
  }

  static std::vector<std::pair<StrokeId, StrokePlace>> places(const Orders& orders) {
    std::vector<std::pair<StrokeId, StrokePlace>> result;
    for (const auto& [layer, strokes] : orders) {
      for (std::size_t i = 0; i < strokes.size(); ++i) result.push_back({strokes[i], {layer, i}});
    }
    return result;
  }

  void write_strokes(const Document& document, const Orders& before, Edit& edit) {
    const auto was = places(before), is = places(orders_);
    const auto find = [](const auto& list, StrokeId id) {
      for (const auto& entry : list) {
        if (entry.first == id) return &entry;
      }
      return static_cast<decltype(list.data())>(nullptr);
    };
    for (const auto& [id, place] : was) {
      StrokeChange c{id, document.find(id), nullptr, place, {}};
      if (const auto* now = find(is, id)) {
        const bool replaced = std::find(changed_.begin(), changed_.end(), id) != changed_.end();
        if (now->second == place && !replaced && random_.chance(0.9)) continue;
        c.after = replaced ? stroke() : c.before;
        c.after_place = now->second;
      }
      edit.changes.push_back(c);
    }
    for (const auto& [id, place] : is) {
      if (!find(was, id)) edit.changes.push_back({id, nullptr, stroke(), {}, place});
    }
  }

  void write_layers(const Layers& before, Edit& edit) {
    if (before == layers_) return;
    const auto index = [](const Layers& list, LayerId id) {
      std::size_t i = 0;
      while (i < list.size() && list[i].first != id) ++i;
      return i;
    };
    for (std::size_t i = 0; i < before.size(); ++i) {
      LayerChange c{before[i].first, before[i].second, std::nullopt, i, 0};
      const std::size_t now = index(layers_, c.id);
      if (now < layers_.size()) {
        c.after = layers_[now].second;
        c.after_index = now;
      }
      edit.layers.push_back(c);
    }
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      if (index(before, layers_[i].first) < before.size()) continue;
      edit.layers.push_back({layers_[i].first, std::nullopt, layers_[i].second, 0, i});
    }
  }

  std::uint64_t seed_;
  RandomStroke random_;
  RandomStroke timings_;  // apart, so that the other edits of a seed stay the same
  RandomFills fills_;
  RandomGuides guides_;
  std::uint64_t count_ = 0, strokes_ = 0, made_ = 0, made_groups_ = 0;
  Orders orders_;
  Layers layers_;
  std::vector<StrokeId> changed_;
};

/// Returns true if the invariants of every document hold: each stroke and fill is in one layer,
/// once; layers have ids; the layers of a group are neighbours and have equal groups; find, place
/// and layer_of agree.
inline bool is_consistent(const Document& document) {
  std::size_t count = 0, fills = 0;
  std::set<GroupId> groups;
  LayerGroupPtr last;
  for (const Layer& layer : document.layers()) {
    if (!layer.id || document.layer(layer.id) != &layer) return false;
    if (layer.visible != is_visible(layer.state())) return false;
    if (layer.locked != is_locked(layer.state())) return false;
    const bool is_same = same_group(layer.group, last);
    if (layer.group && !is_same && !groups.insert(layer.group->id).second) return false;
    if (is_same && *layer.group != *last) return false;
    last = layer.group;
    for (std::size_t i = 0; i < layer.strokes.size(); ++i, ++count) {
      const StrokeId id = layer.strokes[i];
      if (!document.find(id) || document.place(id) != StrokePlace{layer.id, i}) return false;
      if (document.layer_of(id) != layer.id) return false;
    }
    for (std::size_t i = 0; i < layer.fills.size(); ++i, ++fills) {
      const FillId id = layer.fills[i];
      if (!document.find_fill(id) || document.layer_of_fill(id) != layer.id) return false;
      if (document.fill_place(id) != StrokePlace{layer.id, i}) return false;
    }
  }
  return count == document.stroke_count() && fills == document.fill_count() &&
         !document.layers().empty();
}

}  // namespace felt::testing
