#include "felt/render/image.h"

#include <gtest/gtest.h>

namespace felt::image_test {
namespace {

TEST(Image, StartsTransparentAndIsLimited) {
  const Image image = Image::create(3, 2).value();
  EXPECT_EQ(image.at(2, 1), (Rgba{0, 0, 0, 0}));
  EXPECT_FALSE(Image::create(0, 5));
  EXPECT_FALSE(Image::create(5, -1));
  EXPECT_FALSE(Image::create(1 << 20, 1 << 20));
}

TEST(Image, FillIsPremultipliedAndStaysInside) {
  Image image = Image::create(4, 4).value();
  fill(image.pixels(), {2, 2, 99, 99}, {255, 100, 0, 128});
  EXPECT_EQ(image.at(2, 2), (Rgba{128, 50, 0, 128}));
  EXPECT_EQ(image.at(3, 3), (Rgba{128, 50, 0, 128}));
  EXPECT_EQ(image.at(1, 2), (Rgba{0, 0, 0, 0}));
  fill(image.pixels(), {3, 3, 1, 1}, {1, 2, 3, 255});
  EXPECT_EQ(image.at(2, 2), (Rgba{128, 50, 0, 128}));
}

TEST(Image, ByteOrderIsTheTargets) {
  Image image = Image::create(1, 1).value();
  Pixels pixels = image.pixels();
  pixels.order = PixelOrder::kBgra;
  fill(pixels, pixels.rect(), {10, 20, 30, 255});
  EXPECT_EQ(image.at(0, 0), (Rgba{30, 20, 10, 255}));
}

}  // namespace
}  // namespace felt::image_test
