#include "felt/io/picture/png.h"
#include "tests/support/scratch_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <png.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <vector>

namespace felt::png_test {
namespace {

using ::testing::HasSubstr;

/// Returns a picture with a different colour in every column; the right half is partly transparent.
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
    static_cast<void>(decode_png(broken));  // may succeed if only text changed, but must not crash
  }
}

/// Returns a PNG of 16-bit grey, written with libpng directly.
std::string grey_png(int width, int height, const std::vector<std::uint16_t>& grey) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_LINEAR_Y;
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&image, nullptr, &size, 0, grey.data(), 0, nullptr);
  std::string bytes(size, '\0');
  png_image_write_to_memory(&image, bytes.data(), &size, 0, grey.data(), 0, nullptr);
  bytes.resize(size);
  return bytes;
}

TEST(Png, R47_AReliefKeepsAll16Bits) {
  std::vector<std::uint16_t> grey(std::size_t{40} * 30);
  for (std::size_t i = 0; i < grey.size(); ++i) grey[i] = static_cast<std::uint16_t>(54 * i + 1);
  const auto relief = decode_height_png(grey_png(40, 30, grey));
  ASSERT_TRUE(relief) << relief.error().message;
  EXPECT_EQ(relief->width, 40);
  EXPECT_EQ(relief->height, 30);
  EXPECT_EQ(relief->width_mm, 0.0);
  ASSERT_EQ(relief->heights.size(), grey.size());
  for (std::size_t i = 0; i < grey.size(); ++i) {
    EXPECT_NEAR(relief->heights[i], grey[i] / 65535.0, 1e-7) << i;
  }
}

TEST(Png, R47_AReliefOfColoursIsTheirBrightness) {
  Image image = sample(true);
  fill(image.pixels(), {0, 4, 32, 8}, {51, 51, 51, 255});
  const auto relief = decode_height_png(*encode_png(image, 254.0));
  ASSERT_TRUE(relief) << relief.error().message;
  EXPECT_NEAR(relief->width_mm, 3.2, 0.001);
  ASSERT_EQ(relief->heights.size(), 32u * 8u);
  EXPECT_GT(relief->heights[0], 0.25F);  // green and blue
  EXPECT_LT(relief->heights[0], 0.6F);
  EXPECT_NEAR(relief->heights[4 * 32], 0.2, 0.001);  // grey is unchanged
}

TEST(Png, AReliefThatIsDamagedOrNotThereIsAnErrorWithItsName) {
  const std::string bytes = grey_png(20, 20, std::vector<std::uint16_t>(400, 7));
  EXPECT_FALSE(decode_height_png(""));
  for (std::size_t size = 0; size < bytes.size(); size += 3) {
    EXPECT_FALSE(decode_height_png(std::string_view(bytes).substr(0, size))) << size;
  }
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string broken = bytes;
    broken[i] = static_cast<char>(broken[i] ^ 0x55);
    static_cast<void>(decode_height_png(broken));  // must not crash
  }
  // A header that claims 2^31 - 1 pixels in both directions.
  std::string huge = bytes;
  for (const std::size_t at : {std::size_t{16}, std::size_t{20}})
    huge.replace(at, 4, "\x7f\xff\xff\xff");
  EXPECT_FALSE(decode_height_png(huge));
  const auto none = read_height_png("/nowhere/at/all.png");
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("/nowhere/at/all.png"));
  const std::string path = scratch_path("relief-test.png");
  std::ofstream(path) << "no picture";
  const auto bad = read_height_png(path);
  std::filesystem::remove(path);
  ASSERT_FALSE(bad);
  EXPECT_THAT(bad.error().message, HasSubstr(path));
}

// The path may come from a material that somebody else made, so reading must neither block nor go
// on forever.
TEST(Png, AReliefIsReadFromAFileOnly) {
  const std::string pipe = scratch_path("relief-pipe.png"), link = scratch_path("relief-link.png");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", link);
  for (const std::string& path : {pipe, link}) {
    const auto picture = read_height_png(path);
    std::filesystem::remove(path);
    ASSERT_FALSE(picture) << path;
    EXPECT_EQ(picture.error().message, path + ": not a regular file");
  }
  const auto standard_input = read_height_png("-");
  ASSERT_FALSE(standard_input);
  EXPECT_EQ(standard_input.error().code, ErrorCode::kNotFound);
  const auto folder = read_height_png("/");
  ASSERT_FALSE(folder);
  EXPECT_THAT(folder.error().message, HasSubstr("/: cannot read: "));
}

TEST(Png, WritesAFile) {
  const std::string path = scratch_path("png-test.png");
  ASSERT_TRUE(write_png(path, sample(false), 96.0));
  EXPECT_GT(std::filesystem::file_size(path), 50u);
  std::filesystem::remove(path);
  const auto result = write_png("/nowhere/at/all.png", sample(false), 96.0);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("/nowhere/at/all.png"));
  EXPECT_FALSE(encode_png(sample(false), -1.0));
}

}  // namespace
}  // namespace felt::png_test
