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

/// Returns a ball of 60 mm, and a camera that sees it from the right in a picture of 200 x 200.
struct BallFromTheRight {
  Solid ball;
  SolidCamera camera = solid_camera(60.0, 0.0);

  BallFromTheRight() {
    testing::SolidDrawing drawing;
    drawing.circle({50, 50}, 30.0);
    ball = inflate(drawing.document, {}).value().solid;
    camera.px_per_mm = 3.0;
    camera.origin_px = {100.0, 100.0};
  }
  [[nodiscard]] Image painted(const SolidLook& look) const {
    return paint_solid(ball, camera, look, 200, 200).value();
  }
};

TEST(SolidPicture, TheCameraSaysWhereAPointIsPainted) {
  const BallFromTheRight scene;
  const Image image = scene.painted({.paper = {0, 0, 255, 255}, .section_x_mm = {}});
  const auto is_paper = [&](const Vec3& at) {
    const Vec3 px = scene.camera.to_px(at);
    return image.at(static_cast<int>(px.x), static_cast<int>(px.y)) == Rgba{0, 0, 255, 255};
  };
  EXPECT_FALSE(is_paper({0.0, 28.5, 0.0}));
  EXPECT_TRUE(is_paper({0.0, 31.0, 0.0}));
  EXPECT_FALSE(is_paper(28.5 * scene.camera.right));
  EXPECT_TRUE(is_paper(31.0 * scene.camera.right));
}

TEST(SolidPicture, ASectionShowsTheCutAndNothingBehindIt) {
  const BallFromTheRight scene;
  SolidLook look;
  look.section_x_mm = 0.0;
  const Image image = scene.painted(look);
  const auto at = [&](const Vec3& p) {
    const Vec3 px = scene.camera.to_px(p);
    return image.at(static_cast<int>(px.x), static_cast<int>(px.y));
  };
  const Rgba cut = at({});
  EXPECT_GT(cut.r, cut.b + 20) << "it has the colour of cuts";
  EXPECT_EQ(at({0.0, 25.0, 5.0}), cut) << "the cut is flat";
  EXPECT_EQ(at(28.0 * scene.camera.right), (Rgba{255, 255, 255, 255})) << "this is cut away";
  look.section_x_mm = 31.0;
  EXPECT_EQ(scene.painted(look), scene.painted({})) << "beside the ball it cuts nothing";
}

TEST(SolidPicture, TheWireframeIsDrawnOnTheBodyOnly) {
  const BallFromTheRight scene;
  SolidLook look;
  look.wireframe = WireframeChoice::kShow;
  const Image with = scene.painted(look), without = scene.painted({});
  int darker = 0, same = 0;
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      const Rgba a = with.at(x, y), b = without.at(x, y);
      EXPECT_LE(a.r, b.r);
      (a == b ? same : darker) += 1;
      if (b == Rgba{255, 255, 255, 255}) {
        EXPECT_EQ(a, b);
      }
    }
  }
  EXPECT_GT(darker, 2000);
  EXPECT_GT(same, 2000);
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
