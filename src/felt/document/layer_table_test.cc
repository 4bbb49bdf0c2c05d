#include "felt/document/layer_table.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <memory>
#include <set>

#include "felt/document/document.h"

namespace felt::layer_table_test {
namespace {

LayerGroupPtr some_group(std::uint64_t id, std::string name = {}) {
  if (id == 0) return nullptr;
  return std::make_shared<const LayerGroup>(LayerGroup{{id}, std::move(name)});
}

LayerChange added(std::uint64_t id, std::size_t index, LayerGroupPtr group = nullptr) {
  LayerState state{"l"};
  state.group = std::move(group);
  return {{id}, std::nullopt, std::move(state), 0, index};
}

/// Returns true if the layers of each group are neighbours with equal groups.
bool has_valid_groups(const std::vector<LayerGroupPtr>& groups) {
  std::set<GroupId> done;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const LayerGroupPtr below = i > 0 ? groups[i - 1] : nullptr;
    if (same_group(groups[i], below)) {
      if (!equal_groups(groups[i], below)) return false;
    } else if (groups[i] && !done.insert(groups[i]->id).second) {
      return false;
    }
  }
  return true;
}

/// An edit of random layers, with the groups of the layers after it.
struct RandomMoves {
  Edit edit;
  std::vector<LayerGroupPtr> groups;
};

RandomMoves random_moves(const Document& document) {
  struct Entry {
    LayerChange change;
    bool is_changed = false;
  };
  std::vector<Entry> order;
  const auto any_group = [] {
    return some_group(*rc::gen::inRange<std::uint64_t>(0, 4),
                      *rc::gen::weightedElement<std::string>({{9, ""}, {1, "other"}}));
  };
  RandomMoves made;
  for (std::size_t i = 0; i < document.layers().size(); ++i) {
    const Layer& layer = document.layers()[i];
    LayerChange change{layer.id, layer.state(), layer.state(), i, 0};
    const int what = *rc::gen::inRange(0, 8);
    if (what == 0 && i > 1) {
      change.after.reset();
      made.edit.layers.push_back(change);
      continue;
    }
    if (what == 1) change.after->group = any_group();
    order.push_back({change, what <= 2});
  }
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, order.size() + 1);
    const std::uint64_t id = document.new_layer_id(static_cast<std::uint64_t>(i)).value;
    order.insert(order.begin() + static_cast<std::ptrdiff_t>(at),
                 {added(id, 0, any_group()), true});
  }
  for (int i = *rc::gen::inRange(0, 3); i > 0 && !order.empty(); --i) {
    const auto from = *rc::gen::inRange<std::size_t>(0, order.size());
    Entry moved = order[from];
    moved.is_changed = true;
    order.erase(order.begin() + static_cast<std::ptrdiff_t>(from));
    const auto to = *rc::gen::inRange<std::size_t>(0, order.size() + 1);
    order.insert(order.begin() + static_cast<std::ptrdiff_t>(to), moved);
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    made.groups.push_back(order[i].change.after->group);
    order[i].change.after_index = i;
    if (order[i].is_changed) made.edit.layers.push_back(order[i].change);
  }
  return made;
}

/// Compares with a check of the whole document.
RC_GTEST_PROP(LayerPlan, AcceptsExactlyTheEditsThatKeepGroupsTogether, ()) {
  Document document;
  Edit first;
  for (std::uint64_t i = 2; i <= 9; ++i) {
    first.layers.push_back(added(i, i - 1, some_group((i / 2) % 4)));
  }
  RC_ASSERT(document.apply(first).has_value());
  for (int step = 0; step < 12; ++step) {
    const RandomMoves moves = random_moves(document);
    const Document before = document;
    const bool is_valid = has_valid_groups(moves.groups);
    RC_ASSERT(document.apply(moves.edit).has_value() == is_valid);
    RC_CLASSIFY(is_valid, "valid");
    if (!is_valid) {
      RC_ASSERT(document == before);
      continue;
    }
    RC_ASSERT(document.layers().size() == moves.groups.size());
    for (std::size_t i = 0; i < moves.groups.size(); ++i) {
      const Layer& layer = document.layers()[i];
      RC_ASSERT(equal_groups(layer.group, moves.groups[i]));
      RC_ASSERT(document.layer_index(layer.id) == i);
      RC_ASSERT(document.layer(layer.id) == &layer);
    }
    for (const LayerChange& c : moves.edit.layers) {
      RC_ASSERT(c.after.has_value() == (document.layer(c.id) != nullptr));
    }
    RC_ASSERT(document.apply(moves.edit.inverse()).has_value());
    RC_ASSERT(document == before);
    RC_ASSERT(document.apply(moves.edit).has_value());
  }
}

/// Adding, renaming and removing layers one by one moves each layer about once.
TEST(LayerTable, LayersOnTopAreAddedAndRemovedWithoutMovingTheOthers) {
  constexpr std::uint64_t kLayers = 10'000;
  Document document;
  for (std::uint64_t i = 1; i < kLayers; ++i) {
    ASSERT_TRUE(document.apply({"Add", {}, {added(i + 1, i)}}));
  }
  EXPECT_LE(document.moved_layers(), kLayers + 1);
  for (std::uint64_t i = 0; i < kLayers; ++i) {
    const Layer& layer = document.layers()[i];
    LayerChange change{layer.id, layer.state(), layer.state(), i, i};
    change.after->name = "renamed";
    ASSERT_TRUE(document.apply({"Rename", {}, {change}}));
  }
  for (std::uint64_t i = kLayers - 1; i > 0; --i) {
    const Layer& layer = document.layers()[i];
    ASSERT_TRUE(document.apply({"Remove", {}, {{layer.id, layer.state(), std::nullopt, i, 0}}}));
  }
  EXPECT_LE(document.moved_layers(), kLayers + 1);
  EXPECT_EQ(document.layers().size(), 1U);
}

/// One edit that adds many layers moves each of them once, wherever they are.
TEST(LayerTable, ManyLayersOfOneEditAreMovedOnce) {
  constexpr std::uint64_t kLayers = 10'000;
  Document document;
  Edit edit;
  for (std::uint64_t i = 1; i < kLayers; ++i) edit.layers.push_back(added(kLayers - i + 1, i - 1));
  ASSERT_TRUE(document.apply(edit));
  EXPECT_LE(document.moved_layers(), kLayers + 1);
  EXPECT_EQ(document.layer_index({1}), kLayers - 1);
  EXPECT_EQ(document.layer_index({kLayers + 1}), document.layers().size());
}

}  // namespace
}  // namespace felt::layer_table_test
