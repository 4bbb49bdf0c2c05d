#include "felt/document/layer_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "felt/document/history.h"
#include "felt/document/testing/small_picture.h"

namespace felt::layer_picture_test {
namespace {

std::string error_of(std::string bytes) {
  const auto data = make_picture_data(std::move(bytes));
  return data ? "" : data.error().message;
}

TEST(LayerPicture, ReadsTheSizeOfAPng) {
  EXPECT_EQ(testing::picture_data()->width_px, 2);
  EXPECT_EQ(testing::picture_data()->height_px, 1);
}

TEST(LayerPicture, RefusesWhatIsNoPngOrTooLarge) {
  const std::string png = testing::picture_data()->png;
  EXPECT_EQ(error_of(""), "the picture is not a PNG file");
  EXPECT_EQ(error_of(png.substr(0, 23)), "the picture is not a PNG file");
  EXPECT_EQ(error_of("GIF89a" + png), "the picture is not a PNG file");
  std::string wide = png;
  wide[18] = 0x20;
  wide[19] = 1;  // 8193 pixels
  EXPECT_THAT(error_of(wide), ::testing::HasSubstr("8192"));
  std::string flat = png;
  flat[23] = 0;
  EXPECT_THAT(error_of(flat), ::testing::HasSubstr("8192"));
  EXPECT_THAT(error_of(png + std::string(PictureData::kMaxBytes, ' ')),
              ::testing::HasSubstr("48 MiB"));
}

TEST(LayerPicture, BoundsFollowThePlace) {
  const LayerPicture turned{testing::picture_data(), {0, 10, -10, 0, 5, 5}};
  const Rect box = bounds_of(turned);
  EXPECT_EQ(box.x0, -5.0);
  EXPECT_EQ(box.y0, 5.0);
  EXPECT_EQ(box.x1, 5.0);
  EXPECT_EQ(box.y1, 25.0);
}

TEST(LayerPicture, ChecksItsPlace) {
  EXPECT_TRUE(is_picture_place({0, 1, 1, 0, -1e6, 1e6}));
  EXPECT_FALSE(is_picture_place({1, 1, 1, 1, 0, 0}));
  EXPECT_FALSE(is_picture_place({1, 0, 0, 1, 2e6, 0}));
  EXPECT_FALSE(is_picture_place({1, 0, 0, std::numeric_limits<double>::quiet_NaN(), 0, 0}));
}

TEST(LayerPicture, HistoryCountsItsBytesOnlyIfTheEditAddsOrRemovesIt) {
  auto data = std::make_shared<PictureData>(*testing::picture_data());
  data->png.resize(100'000);
  LayerState state{"a"};
  state.picture = std::make_shared<const LayerPicture>(LayerPicture{data, {}});
  Edit add;
  add.layers.push_back({{2}, std::nullopt, state, 0, 1});
  EXPECT_GT(memory_of(add), 100'000U);
  Edit rename;
  rename.layers.push_back({{2}, state, state, 1, 1});
  rename.layers[0].after->name = "b";
  EXPECT_LT(memory_of(rename), 10'000U);
}

}  // namespace
}  // namespace felt::layer_picture_test
