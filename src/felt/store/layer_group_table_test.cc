#include "felt/store/layer_group_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/document/testing/random_document.h"
#include "felt/store/felt_file.h"
#include "felt/store/felt_tables.h"

namespace felt::layer_group_table_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Returns a drawing of three layers: the lower two are in a group, and the lowest multiplies.
Drawing grouped_drawing() {
  Drawing drawing;
  const auto group = std::make_shared<const LayerGroup>(
      LayerGroup{{7}, "Cat", false, true, 0.3, BlendMode::kMultiply});
  Edit edit;
  for (std::uint64_t id = 1; id <= 3; ++id) {
    LayerState state{"Layer " + std::to_string(id)};
    if (id == 1) state.blend = BlendMode::kMultiply;
    if (id < 3) state.group = group;
    const auto before =
        id == 1 ? std::optional(drawing.document.layers()[0].state()) : std::nullopt;
    edit.layers.push_back({{id}, before, state, 0, id - 1});
  }
  EXPECT_TRUE(drawing.document.apply(edit));
  return drawing;
}

/// Returns the file after a change by another program.
std::string changed(const Drawing& drawing, const char* sql) {
  Database database = Database::create().value();
  EXPECT_TRUE(write_tables(database, drawing, nullptr));
  EXPECT_TRUE(database.run(sql));
  EXPECT_TRUE(database.run(("PRAGMA application_id=" + std::to_string(kFeltApplicationId) +
                            "; PRAGMA user_version=" + std::to_string(kFeltVersion))
                               .c_str()));
  return database.bytes().value();
}

std::string error_of(const std::string& bytes) {
  const Result<Drawing> drawing = parse_felt(bytes);
  return drawing ? "" : drawing.error().message;
}

TEST(LayerGroupTable, GroupsAndModesReadBackAsTheyWere) {
  const Drawing drawing = grouped_drawing();
  EXPECT_TRUE(parse_felt(felt_bytes(drawing).value()).value() == drawing);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Drawing any;
    testing::RandomEdits edits(seed);
    for (int i = 0; i < 12; ++i) ASSERT_TRUE(any.document.apply(edits.next(any.document)));
    ASSERT_TRUE(parse_felt(felt_bytes(any).value()).value() == any) << seed;
  }
}

TEST(LayerGroupTable, AFileWithoutThemHasNeitherTable) {
  const std::string plain = felt_bytes(Drawing()).value();
  EXPECT_THAT(plain, Not(HasSubstr("layer_blend")));
  EXPECT_THAT(plain, Not(HasSubstr("layer_group")));
}

TEST(LayerGroupTable, AFileWithTheLargestIdCanBeSavedAgain) {
  const Drawing drawing = grouped_drawing();
  const std::string largest = "UPDATE layer_group SET number=" + std::to_string(kMaxId);
  Drawing read = parse_felt(changed(drawing, largest.c_str())).value();
  EXPECT_EQ(read.document.new_group_id(), GroupId{1});
  // Parts of a group that are not neighbours become two groups.
  const std::string parts = largest + "; UPDATE layer_group SET layer=3 WHERE id=2";
  read = parse_felt(changed(drawing, parts.c_str())).value();
  EXPECT_TRUE(parse_felt(felt_bytes(read).value()).value() == read);
  const std::string beyond = "UPDATE layer_group SET number=" + std::to_string(kMaxId + 1);
  EXPECT_THAT(error_of(changed(drawing, beyond.c_str())), HasSubstr("layer_group"));
}

TEST(LayerGroupTable, BadValuesAreErrors) {
  const Drawing drawing = grouped_drawing();
  ASSERT_EQ(error_of(changed(drawing, "SELECT 1")), "");
  EXPECT_EQ(error_of(changed(drawing, "UPDATE layer_blend SET mode='screen'")),
            "a layer has the blend mode 'screen', which this version of Feltline does not have");
  for (const char* sql : {"UPDATE layer_blend SET layer=9", "UPDATE layer_blend SET layer='x'",
                          "INSERT INTO layer_blend VALUES(9,'normal',1)"}) {
    EXPECT_EQ(error_of(changed(drawing, sql)), "the table 'layer_blend' contains an invalid value")
        << sql;
  }
  for (const char* sql :
       {"UPDATE layer_group SET layer=9 WHERE id=1", "UPDATE layer_group SET number=0",
        "UPDATE layer_group SET visible=2", "UPDATE layer_group SET locked='x'",
        "UPDATE layer_group SET opacity=1.5", "UPDATE layer_group SET mode='screen'",
        "UPDATE layer_group SET name=x'00'",
        "INSERT INTO layer_group VALUES(9,1,7,'Cat',1,0,0.5,'normal')"}) {
    EXPECT_EQ(error_of(changed(drawing, sql)), "the table 'layer_group' contains an invalid value")
        << sql;
  }
}

/// A program from before groups may move a layer between the layers of a group.
TEST(LayerGroupTable, AGroupThatAnOlderProgramHasSplitBecomesTwo) {
  Drawing drawing = grouped_drawing();
  Edit edit;
  for (const Layer& layer : drawing.document.layers()) {
    LayerState state = layer.state();
    state.group = nullptr;
    const std::size_t from = layer.id.value - 1;
    edit.layers.push_back({layer.id, layer.state(), state, from, from == 0 ? 0 : 3 - from});
  }
  ASSERT_TRUE(drawing.document.apply(edit));
  const Drawing back =
      parse_felt(changed(drawing, (std::string(kLayerGroupTable) +
                                   "; INSERT INTO layer_group VALUES(1,1,7,'Cat',1,0,1.0,'normal')"
                                   "; INSERT INTO layer_group VALUES(2,2,7,'Cat',1,0,1.0,'normal')")
                                      .c_str()))
          .value();
  const auto layers = back.document.layers();
  EXPECT_EQ(layers[0].group->id, GroupId{7});
  EXPECT_FALSE(layers[1].group);
  EXPECT_EQ(layers[2].group->id, GroupId{1}) << "the smallest free id";
}

}  // namespace
}  // namespace felt::layer_group_table_test
