#include "felt/render/raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "felt/stroke/testing/ink_oracle.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::raster_test {
namespace {

constexpr Rgba kInk{0, 0, 0, 128};

Image blank(int width, int height) {
  Image image = Image::create(width, height).value();
  fill(image.pixels(), image.pixels().rect(), {255, 255, 255, 255});
  return image;
}

Outline rectangle(double x0, double y0, double x1, double y1) {
  return {.points = {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}}, .ends = {4}};
}

Stroke inked(Stroke stroke, Rgba color) {
  StrokeData data = stroke.data();
  data.color = color;
  return Stroke::create(std::move(data)).value();
}

TEST(Rasterizer, CoverageIsTheAreaOfThePixel) {
  Image image = blank(8, 8);
  Rasterizer rasterizer;
  const View view{{1.0, 1.0}, 2.0};
  rasterizer.fill(rectangle(2.0, 2.0, 3.25, 3.5), view, {0, 0, 8, 8}, {0, 0, 0, 255},
                  image.pixels());
  EXPECT_EQ(image.at(1, 2).r, 255);
  EXPECT_EQ(image.at(2, 2).r, 0);
  EXPECT_EQ(image.at(3, 4).r, 0);
  EXPECT_NEAR(image.at(4, 3).r, 128, 1);
  EXPECT_EQ(image.at(5, 3).r, 255);
  EXPECT_EQ(image.at(3, 5).r, 255);
}

TEST(Rasterizer, AlphaCoversEachPixelOnce) {
  // A stroke that runs back and forth over itself and crosses itself.
  const Stroke stroke =
      inked(Stroke::create({.points = {{1, 5}, {12, 5}, {12, 5}, {1, 5}, {9, -5}, {9, 15}, {5, 5}},
                            .joints = {JointKind::kCorner},
                            .closed = false,
                            .widths = {{0, 1.0}, {2, 3.0}}})
                .value(),
            kInk);
  Image image = blank(200, 200);
  Rasterizer rasterizer;
  rasterizer.draw(stroke, {{0, 0}, 20.0}, {0, 0, 200, 200}, image.pixels());
  std::vector<Dab> dabs;
  flatten(stroke, 1e-3, dabs);
  for (int y = 0; y < 200; y += 3) {
    for (int x = 0; x < 200; x += 3) {
      const double outside = testing::distance_outside(dabs, {(x + 0.5) / 20, (y + 0.5) / 20});
      if (outside < -0.1) {
        EXPECT_NEAR(image.at(x, y).r, 127, 1) << x << ", " << y;
      } else if (outside > 0.1) {
        EXPECT_EQ(image.at(x, y).r, 255) << x << ", " << y;
      }
    }
  }
}

TEST(Rasterizer, TilesGiveTheSamePixels) {
  constexpr int kSize = 300, kTile = 64;
  const View view{{-2, -2}, 12.0};
  Image whole = blank(kSize, kSize), tiled = blank(kSize, kSize);
  Rasterizer rasterizer;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Stroke s = inked(testing::random_stroke(seed), {40, 20, 200, 100});
    rasterizer.draw(s, view, {0, 0, kSize, kSize}, whole.pixels());
    for (int y = 0; y < kSize; y += kTile) {
      for (int x = 0; x < kSize; x += kTile) {
        rasterizer.draw(s, view, {x, y, x + kTile, y + kTile}, tiled.pixels());
      }
    }
  }
  int worst = 0;
  for (std::size_t i = 0; i < whole.bytes().size(); ++i) {
    worst = std::max(worst, std::abs(whole.bytes()[i] - tiled.bytes()[i]));
  }
  EXPECT_LE(worst, 2);
}

TEST(Rasterizer, TouchesOnlyTheClip) {
  Image image = blank(40, 40);
  Rasterizer rasterizer;
  rasterizer.fill(rectangle(-1e7, -1e7, 1e7, 1e7), {{0, 0}, 1.0}, {10, 12, 20, 22}, {0, 0, 0, 255},
                  image.pixels());
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      const bool inside = x >= 10 && x < 20 && y >= 12 && y < 22;
      EXPECT_EQ(image.at(x, y).r, inside ? 0 : 255) << x << ", " << y;
    }
  }
}

TEST(Rasterizer, BothByteOrdersShowTheSameColour) {
  Image rgba = blank(8, 8), bgra = blank(8, 8);
  Pixels swapped = bgra.pixels();
  swapped.order = PixelOrder::kBgra;
  Rasterizer rasterizer;
  const Outline outline = rectangle(1.3, 1.3, 6.6, 6.6);
  rasterizer.fill(outline, {{0, 0}, 1.0}, {0, 0, 8, 8}, {200, 100, 50, 180}, rgba.pixels());
  rasterizer.fill(outline, {{0, 0}, 1.0}, {0, 0, 8, 8}, {200, 100, 50, 180}, swapped);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const Rgba a = rgba.at(x, y), b = bgra.at(x, y);
      EXPECT_EQ(a, (Rgba{b.b, b.g, b.r, b.a}));
    }
  }
}

TEST(Rasterizer, HugeCoordinatesAreClippedNotWrapped) {
  Image image = blank(20, 20);
  Rasterizer rasterizer;
  rasterizer.draw(testing::straight_stroke({-1e12, 10}, {1e12, 10}, 6.0, 6.0), {{0, 0}, 1.0},
                  {0, 0, 20, 20}, image.pixels());
  EXPECT_EQ(image.at(10, 10).r, 0);
  EXPECT_EQ(image.at(10, 2).r, 255);
}

}  // namespace
}  // namespace felt::raster_test
