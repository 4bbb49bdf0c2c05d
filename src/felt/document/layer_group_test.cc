#include "felt/document/layer_group.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/document/document.h"

namespace felt::layer_group_test {
namespace {

using ::testing::HasSubstr;

LayerGroupPtr group(std::uint64_t id, const char* name = "Cat") {
  return std::make_shared<const LayerGroup>(LayerGroup{{id}, name});
}

/// Returns an edit that gives the first layer of a new document this group and adds layers with
/// these groups above it.
Edit layers_with(const Document& document, const std::vector<LayerGroupPtr>& groups) {
  Edit edit;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    LayerState state{"Layer"};
    state.group = groups[i];
    const auto before = i == 0 ? std::optional(document.layers()[0].state()) : std::nullopt;
    edit.layers.push_back({{i + 1}, before, state, 0, i});
  }
  return edit;
}

std::string error_of(const std::vector<LayerGroupPtr>& groups) {
  Document document;
  const auto done = document.apply(layers_with(document, groups));
  EXPECT_EQ(document == Document(), !done) << "a refused edit changes nothing";
  return done ? "" : done.error().message;
}

TEST(LayerGroups, AreNeighboursWithEqualGroups) {
  EXPECT_EQ(error_of({group(1), group(1), nullptr, group(2)}), "");
  EXPECT_THAT(error_of({group(1), nullptr, group(1)}), HasSubstr("of group 1 are not neighbours"));
  EXPECT_THAT(error_of({group(1), group(2), group(1)}), HasSubstr("of group 1 are not neighbours"));
  EXPECT_THAT(error_of({group(1), group(1, "Dog")}), HasSubstr("of group 1 differ in it"));
  EXPECT_THAT(error_of({group(0)}), HasSubstr("a group without an id"));
}

TEST(LayerGroups, ALayerIsVisibleAndOpenWithItsGroup) {
  Document document;
  LayerGroup hidden{{1}, "Cat", false, true};
  ASSERT_TRUE(
      document.apply(layers_with(document, {std::make_shared<const LayerGroup>(hidden), nullptr})));
  const Layer& layer = document.layers()[0];
  EXPECT_FALSE(layer.visible);
  EXPECT_TRUE(layer.locked);
  EXPECT_TRUE(layer.state().visible) << "its own state";
  EXPECT_FALSE(layer.state().locked);
  EXPECT_EQ(*document.group({1}), hidden);
  EXPECT_FALSE(document.group({2}));
  EXPECT_EQ(document.new_group_id(), GroupId{2});
}

// Events name groups by their ids, so a replay must give the same ids as the recording.
TEST(LayerGroups, ANewGroupHasALargerIdThanAllOthers) {
  Document document;
  ASSERT_TRUE(document.apply(layers_with(document, {group(7), nullptr})));
  EXPECT_EQ(document.new_group_id(), GroupId{8});
}

TEST(LayerGroups, SeparateGroupsMakesAnyListValid) {
  std::vector<LayerGroupPtr> groups = {group(7), group(7, "Dog"), nullptr, group(7),
                                       group(0), group(3),        group(3)};
  std::vector<LayerGroupPtr*> list;
  for (LayerGroupPtr& g : groups) list.push_back(&g);
  auto numbered = groups;
  separate_groups(list, GroupNumbers::kKept);
  EXPECT_EQ(error_of(groups), "");
  EXPECT_EQ(*groups[0], *group(7));
  EXPECT_EQ(groups[1], groups[0]) << "the lowest decides";
  EXPECT_FALSE(groups[2]);
  EXPECT_EQ(groups[3]->id, GroupId{1}) << "the smallest free id";
  EXPECT_EQ(groups[4]->id, GroupId{2});
  EXPECT_EQ(groups[6]->id, GroupId{3});
  list.clear();
  for (LayerGroupPtr& g : numbered) list.push_back(&g);
  separate_groups(list, GroupNumbers::kFromOne);
  EXPECT_EQ(error_of(numbered), "");
  EXPECT_EQ(numbered[0]->id, GroupId{1});
  EXPECT_EQ(numbered[6]->id, GroupId{4});
}

}  // namespace
}  // namespace felt::layer_group_test
