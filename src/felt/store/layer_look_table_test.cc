#include "felt/store/layer_look_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/document/testing/small_picture.h"
#include "felt/store/felt_file.h"
#include "felt/store/felt_tables.h"

namespace felt::layer_look_table_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Drawing drawing_with(double opacity, LayerPicturePtr picture) {
  Drawing drawing;
  const Layer& ink = drawing.document.layers()[0];
  LayerState state = ink.state();
  state.opacity = opacity;
  state.picture = std::move(picture);
  Edit edit;
  edit.layers.push_back({ink.id, ink.state(), state, 0, 0});
  edit.layers.push_back({{2}, std::nullopt, LayerState{"Top"}, 0, 1});
  EXPECT_TRUE(drawing.document.apply(edit));
  return drawing;
}

/// Returns the file after a change by another program.
std::string changed(const std::string& bytes, const char* sql) {
  Database database = Database::create().value();
  Drawing drawing = parse_felt(bytes).value();
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

TEST(LayerLookTable, LooksReadBackAsTheyWere) {
  LayerPicture picture = *testing::red_blue_picture(1.0 / 3.0, -2.5);
  picture.exported = true;
  const Drawing drawing = drawing_with(0.3, std::make_shared<const LayerPicture>(picture));
  const Drawing back = parse_felt(felt_bytes(drawing).value()).value();
  EXPECT_TRUE(back == drawing);
  EXPECT_EQ(back.document.layers()[0].opacity, 0.3);
  EXPECT_EQ(*back.document.layers()[0].picture, picture);
}

TEST(LayerLookTable, AFileWithoutLooksHasNeitherTable) {
  const std::string plain = felt_bytes(drawing_with(1.0, nullptr)).value();
  EXPECT_THAT(plain, Not(HasSubstr("layer_look")));
  EXPECT_THAT(plain, Not(HasSubstr("picture")));
  const std::string faded = felt_bytes(drawing_with(0.5, nullptr)).value();
  EXPECT_THAT(faded, HasSubstr("CREATE TABLE layer_look("));
  EXPECT_THAT(faded, Not(HasSubstr("picture")));
}

TEST(LayerLookTable, APictureOfManyLayersIsStoredOnce) {
  Drawing drawing = drawing_with(1.0, testing::red_blue_picture(1.0, 2.0));
  Edit edit;
  for (std::uint64_t i = 3; i <= 6; ++i) {
    LayerState state{"Copy"};
    state.picture = testing::red_blue_picture(static_cast<double>(i), 2.0);  // data of its own
    if (i == 5) {
      state.picture = std::make_shared<const LayerPicture>(
          LayerPicture{testing::picture_data(testing::kColorfulPng), {1, 0, 0, 1, 0, 0}});
    }
    edit.layers.push_back({{i}, std::nullopt, state, 0, i - 1});
  }
  ASSERT_TRUE(drawing.document.apply(edit));
  const std::string bytes = felt_bytes(drawing).value();
  const std::string& png = drawing.document.layers()[0].picture->data->png;
  const std::size_t first = bytes.find(png);
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(bytes.find(png, first + 1), std::string::npos);
  const Drawing back = parse_felt(bytes).value();
  EXPECT_TRUE(back == drawing);
  EXPECT_EQ(back.document.layers()[5].picture->data, back.document.layers()[0].picture->data);
  EXPECT_EQ(error_of(changed(bytes, "UPDATE picture SET e=9.0 WHERE id=2")),
            "the table 'picture' contains an invalid value");
  // An older program leaves out the rows of the layers that it removes.
  for (const char* sql :
       {"UPDATE picture SET png=4 WHERE id=2", "UPDATE picture SET png=2 WHERE id=2",
        "UPDATE picture SET png=99 WHERE id=2"}) {
    std::vector<std::string> notices;
    const Drawing without = parse_felt(changed(bytes, sql), &notices).value();
    EXPECT_FALSE(without.document.layers()[2].picture) << sql;
    EXPECT_TRUE(without.document.layers()[3].picture) << sql;
    EXPECT_EQ(notices, std::vector<std::string>{"The picture of the layer 'Copy' is lost."}) << sql;
  }
}

TEST(LayerLookTable, BadValuesAreErrors) {
  const std::string bytes =
      felt_bytes(drawing_with(0.5, testing::red_blue_picture(1.0, 2.0))).value();
  ASSERT_EQ(error_of(changed(bytes, "SELECT 1")), "");
  for (const char* sql : {"UPDATE layer_look SET opacity=1.5", "UPDATE layer_look SET opacity=-1.0",
                          "UPDATE layer_look SET opacity='x'", "UPDATE layer_look SET layer=7",
                          "INSERT INTO layer_look VALUES(9,1,0.25)"}) {
    EXPECT_EQ(error_of(changed(bytes, sql)), "the table 'layer_look' contains an invalid value")
        << sql;
  }
  for (const char* sql :
       {"UPDATE picture SET layer=7", "UPDATE picture SET a=2.0", "UPDATE picture SET exported=1",
        "UPDATE picture SET exported=2", "UPDATE picture SET png=x'00'",
        "UPDATE picture SET png='x'", "UPDATE picture SET checksum=checksum+1",
        "UPDATE picture SET a=0.0, b=0.0", "UPDATE picture SET e=1e9",
        "INSERT INTO picture SELECT 9,layer,a,b,c,d,e,f,exported,png,checksum FROM picture"}) {
    EXPECT_EQ(error_of(changed(bytes, sql)), "the table 'picture' contains an invalid value")
        << sql;
  }
}

}  // namespace
}  // namespace felt::layer_look_table_test
