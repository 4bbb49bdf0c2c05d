#include "felt/solid/solid_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "felt/solid/inflate.h"
#include "felt/solid/testing/solid_drawings.h"

namespace felt::solid_picture_test {
namespace {

TEST(SolidPicture, ABallIsARoundLitFromTheUpperLeft) {
  testing::SolidDrawing drawing;
  drawing.circle({50, 50}, 30.0);
  const Result<InflatedDrawing> ball = inflate(drawing.document, {});
  ASSERT_TRUE(ball) << ball.error().message;
  const Result<Image> image = paint_solid(ball->solid, {.width_px = 200, .height_px = 200});
  ASSERT_TRUE(image);
  const auto light = [&](int x, int y) {
    const Rgba c = image->at(x, y);
    EXPECT_EQ(c.a, 255);
    return static_cast<int>(c.r) + c.g + c.b;
  };
  constexpr int kWhite = 3 * 255;
  EXPECT_EQ(light(0, 0), kWhite);
  EXPECT_EQ(light(199, 100), kWhite);
  EXPECT_LT(light(100, 100), kWhite);
  EXPECT_GT(light(60, 60), light(140, 140) + 150);
  // As high as it is wide: 88 % of the picture.
  int across = 0, down = 0;
  for (int k = 0; k < 200; ++k) {
    across += light(k, 100) < kWhite ? 1 : 0;
    down += light(100, k) < kWhite ? 1 : 0;
  }
  EXPECT_NEAR(across, 176, 3);
  EXPECT_NEAR(down, 176, 3);
}

TEST(SolidPicture, TheNearerBodyHidesTheOther) {
  testing::SolidDrawing drawing;
  drawing.circle({50, 50}, 30.0);
  Result<InflatedDrawing> ball = inflate(drawing.document, {});
  ASSERT_TRUE(ball);
  Solid solid = ball->solid;
  solid.bodies.push_back(solid.bodies[0]);
  solid.bodies[0].color = {255, 255, 200, 255};
  solid.bodies[1].color = {200, 255, 255, 255};
  for (const double z : {-80.0, 80.0}) {
    Solid moved = solid;
    for (Vec3& p : moved.bodies[1].points) p.z += z;
    const Result<Image> image =
        paint_solid(moved, {.width_px = 100, .height_px = 100, .turn_deg = 0.0, .rise_deg = 0.0});
    ASSERT_TRUE(image);
    const Rgba c = image->at(50, 50);
    EXPECT_EQ(c.b > c.r, z > 0.0);
  }
}

/// Returns the columns and rows that a body covers.
PixelRect covered(const Image& image) {
  PixelRect area{image.width(), image.height(), 0, 0};
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image.at(x, y).r + image.at(x, y).g + image.at(x, y).b == 3 * 255) continue;
      area = {std::min(area.x0, x), std::min(area.y0, y), std::max(area.x1, x + 1),
              std::max(area.y1, y + 1)};
    }
  }
  return area;
}

// In a film, a bar must not grow when it is seen from its end.
TEST(SolidPicture, ATurningSolidKeepsItsSizeAndStaysInThePicture) {
  testing::SolidDrawing drawing;
  drawing.polygon({{0, 0}, {90, 0}, {90, 30}, {0, 30}});
  const Result<InflatedDrawing> bar = inflate(drawing.document, {});
  ASSERT_TRUE(bar);
  for (double turn_deg = 0.0; turn_deg < 360.0; turn_deg += 30.0) {
    const Result<Image> image = paint_solid(bar->solid, {.width_px = 300,
                                                         .height_px = 300,
                                                         .turn_deg = turn_deg,
                                                         .rise_deg = 0.0,
                                                         .fit = SolidFit::kTurn});
    ASSERT_TRUE(image);
    const PixelRect area = covered(*image);
    EXPECT_NEAR(area.height(), 88, 4) << turn_deg;
    EXPECT_GT(area.x0, 10);
    EXPECT_LT(area.x1, 290);
    EXPECT_NEAR(area.x0 + area.x1, 300, 8) << "the axis is in the middle";
  }
}

TEST(SolidPicture, RejectsSizesThatNoPictureHas) {
  EXPECT_FALSE(paint_solid({}, {}));
  Solid solid;
  solid.bodies.emplace_back();
  EXPECT_FALSE(paint_solid(solid, {.width_px = 0}));
  EXPECT_FALSE(paint_solid(solid, {.height_px = 1 << 20}));
}

}  // namespace
}  // namespace felt::solid_picture_test
