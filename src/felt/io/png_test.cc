#include "felt/io/png.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace felt {
namespace {

using ::testing::HasSubstr;

/// A picture with a different colour in every column; the right half is transparent to a degree.
Image sample(bool transparent) {
  Image image = Image::create(32, 8).value();
  for (int x = 0; x < 32; ++x) {
    const auto v = static_cast<std::uint8_t>(8 * x);
    const auto a = static_cast<std::uint8_t>(transparent && x >= 16 ? 255 - v : 255);
    fill(image.pixels(), {x, 0, x + 1, 8}, {v, 100, static_cast<std::uint8_t>(255 - v), a});
  }
  return image;
}

TEST(Png, OpaquePicturesComeBackTheSame) {
  const Image image = sample(false);
  const auto bytes = encode_png(image, 300.0);
  ASSERT_TRUE(bytes);
  const auto back = decode_png(*bytes);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->image, image);
  EXPECT_NEAR(back->dpi, 300.0, 0.013);
  EXPECT_EQ(*bytes, *encode_png(image, 300.0));
}

TEST(Png, TransparentPicturesComeBackTheSame) {
  const Image image = sample(true);
  const auto back = decode_png(*encode_png(image, 0.0));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->dpi, 0.0);
  EXPECT_EQ(back->image, image);
}

TEST(Png, DamageIsAnError) {
  const std::string bytes = *encode_png(sample(false), 100.0);
  EXPECT_FALSE(decode_png(""));
  EXPECT_FALSE(decode_png("this is no picture"));
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    EXPECT_FALSE(decode_png(std::string_view(bytes).substr(0, size))) << size;
  }
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string broken = bytes;
    broken[i] = static_cast<char>(broken[i] ^ 0x55);
    static_cast<void>(decode_png(broken));  // may pass where only text changes, must not crash
  }
}

TEST(Png, WritesAFile) {
  const std::string path = (std::filesystem::temp_directory_path() / "felt-png-test.png").string();
  ASSERT_TRUE(write_png(path, sample(false), 96.0));
  EXPECT_GT(std::filesystem::file_size(path), 50u);
  std::filesystem::remove(path);
  const auto result = write_png("/nowhere/at/all.png", sample(false), 96.0);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("/nowhere/at/all.png"));
  EXPECT_FALSE(encode_png(sample(false), -1.0));
}

}  // namespace
}  // namespace felt
