#include "felt/solid/solid_picture.h"

#include <gtest/gtest.h>

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

TEST(SolidPicture, RejectsSizesThatNoPictureHas) {
  EXPECT_FALSE(paint_solid({}, {}));
  Solid solid;
  solid.bodies.emplace_back();
  EXPECT_FALSE(paint_solid(solid, {.width_px = 0}));
  EXPECT_FALSE(paint_solid(solid, {.height_px = 1 << 20}));
}

}  // namespace
}  // namespace felt::solid_picture_test
