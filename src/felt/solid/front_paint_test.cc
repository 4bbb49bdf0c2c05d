#include "felt/solid/front_paint.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "felt/io/picture/png.h"
#include "felt/solid/inflate.h"
#include "felt/solid/solid_picture.h"
#include "felt/solid/solid_writer.h"
#include "felt/solid/testing/solid_drawings.h"

namespace felt::front_paint_test {
namespace {

Solid inflated(const Document& document) {
  Result<InflatedDrawing> result = inflate(document, {.holes = HoleChoice::kFill});
  EXPECT_TRUE(result) << result.error().message;
  return std::move(result->solid);
}

std::optional<FrontPaint> painted(const Document& document, const Solid& solid) {
  Result<std::optional<FrontPaint>> paint = front_paint(document, solid, Grain());
  EXPECT_TRUE(paint) << paint.error().message;
  return paint ? *std::move(paint) : std::nullopt;
}

/// Returns the alpha of the ink at a point of the page.
int ink_at(const FrontPaint& paint, const Solid& solid, Point page) {
  const Vec px = paint.to_px({page.x - solid.origin.x, solid.origin.y - page.y, 0.0});
  return paint.ink.at(static_cast<int>(px.x), static_cast<int>(px.y)).a;
}

TEST(FrontPaint, HasTheLinesInsideAndNotTheOutline) {
  testing::SolidDrawing drawing;
  drawing.circle({50, 50}, 30.0);
  const Solid ball = inflated(drawing.document);
  EXPECT_FALSE(painted(drawing.document, ball)) << "the outline has become the body";
  drawing.polyline({{40, 40}, {60, 40}});
  const auto paint = painted(drawing.document, ball);
  ASSERT_TRUE(paint);
  EXPECT_EQ(ink_at(*paint, ball, {50, 40}), 255);
  EXPECT_EQ(ink_at(*paint, ball, {50, 60}), 0);
  EXPECT_EQ(ink_at(*paint, ball, {50, 20.3}), 0) << "at the outline";
}

// The rectangle around the bodies contains all of these strokes.
TEST(FrontPaint, InkBesideTheBodiesDoesNotCount) {
  testing::SolidDrawing drawing;
  drawing.polygon({{20, 10}, {50, 60}, {10, 60}});
  drawing.polyline({{40, 12}, {49, 14}});
  const Solid triangle = inflated(drawing.document);
  EXPECT_FALSE(painted(drawing.document, triangle));
  drawing.polyline({{25, 40}, {30, 41}});
  EXPECT_TRUE(painted(drawing.document, triangle));

  testing::SolidDrawing round;
  round.circle({50, 50}, 30.0);
  round.polyline({{72, 22}, {79, 24}});
  EXPECT_FALSE(painted(round.document, inflated(round.document)));
}

TEST(FrontPaint, InkInAHoleDoesNotCount) {
  testing::SolidDrawing drawing;
  drawing.circle({50, 50}, 30.0);
  drawing.circle({50, 50}, 15.0);
  const Result<InflatedDrawing> ring = inflate(drawing.document, {.holes = HoleChoice::kKeep});
  ASSERT_TRUE(ring);
  ASSERT_EQ(ring->solid.bodies[0].holes, 1);
  drawing.polyline({{45, 48}, {55, 53}});
  EXPECT_FALSE(painted(drawing.document, ring->solid));
  drawing.polyline({{25, 48}, {30, 50}});
  EXPECT_TRUE(painted(drawing.document, ring->solid));
}

// A rough outline of several strokes, one of which ends inside.
TEST(FrontPaint, LeavesOutStrokesThatFollowTheOutlineForMoreThanHalf) {
  testing::SolidDrawing drawing;
  drawing.polygon({{10, 10}, {90, 10}, {90, 90}, {10, 90}});
  drawing.polyline({{12, 10.3}, {80, 9.8}, {80, 20}});
  const Solid solid = inflated(drawing.document);
  EXPECT_FALSE(painted(drawing.document, solid));
  drawing.polyline({{70, 10.2}, {80, 10.2}, {80, 40}});
  const auto paint = painted(drawing.document, solid);
  ASSERT_TRUE(paint);
  EXPECT_EQ(ink_at(*paint, solid, {80, 30}), 255);
}

TEST(FrontPaint, IsAsSharpAsItsLimitsAllow) {
  for (const double size_mm : {2.0, 50.0, 5000.0}) {
    testing::SolidDrawing drawing;
    drawing.circle({0, 0}, size_mm);
    drawing.polyline({{-0.5 * size_mm, 0}, {0.5 * size_mm, 0}});
    const Solid solid = inflated(drawing.document);
    const auto paint = painted(drawing.document, solid);
    ASSERT_TRUE(paint);
    EXPECT_LE(paint->px_per_mm, FrontPaint::kMaxPxPerMm);
    EXPECT_LE(paint->ink.width(), FrontPaint::kMaxPx + 1);
    EXPECT_GT(paint->ink.width(), size_mm < 3.0 ? 40 : 1000);
  }
}

TEST(FrontPaint, IsSeenOnTheFrontOnly) {
  testing::SolidDrawing drawing;
  drawing.circle({50, 50}, 30.0);
  drawing.polyline({{40, 50}, {60, 50}});
  const Solid ball = inflated(drawing.document);
  const auto paint = painted(drawing.document, ball);
  ASSERT_TRUE(paint);
  for (const double turn_deg : {0.0, 180.0}) {
    const SolidView view{.width_px = 201, .height_px = 201, .turn_deg = turn_deg, .rise_deg = 0.0};
    const Result<Image> with = paint_solid(ball, view, &*paint), without = paint_solid(ball, view);
    ASSERT_TRUE(with && without);
    if (turn_deg > 0.0) {
      EXPECT_EQ(with->bytes(), without->bytes());
    } else {
      EXPECT_LT(with->at(100, 100).r, 60) << "black ink";
      EXPECT_GT(without->at(100, 100).r, 100) << "black bodies are shown lighter";
      EXPECT_EQ(with->at(100, 60), without->at(100, 60));
    }
  }
}

// The pixels of the ink are stretched where the surface is steep: they must not show as steps.
TEST(FrontPaint, ItsBorderIsSmoothHoweverLargeItsPixelsAre) {
  testing::SolidDrawing drawing;
  drawing.circle({50, 50}, 30.0);
  const Solid ball = inflated(drawing.document);
  Result<Image> ink = Image::create(60, 60);
  ASSERT_TRUE(ink);
  const Pixels pixels = ink->pixels();
  for (int y = 0; y < 60; ++y) {
    for (int x = 30; x < 60; ++x) pixels.data[y * pixels.stride + 4 * x + 3] = 255;  // black
  }
  const FrontPaint paint{*std::move(ink), {-30.0, 30.0}, 1.0};
  SolidCamera camera = solid_camera(0.0, 0.0);
  camera.px_per_mm = 20.0;
  camera.origin_px = {100.0, 100.0};
  SolidLook look;
  look.paint = &paint;
  const Result<Image> image = paint_solid(ball, camera, look, 200, 200);
  ASSERT_TRUE(image);
  const int from = image->at(80, 100).r, to = image->at(120, 100).r;
  EXPECT_GT(from, to + 100);
  for (int x = 80; x < 120; ++x) {
    EXPECT_LT(image->at(x, 100).r - image->at(x + 1, 100).r, (from - to) / 4) << x;
  }
}

TEST(FrontPaint, AGlbHasItAsATextureOfEachBodyWithInk) {
  testing::SolidDrawing drawing;
  drawing.circle({50, 50}, 30.0);
  drawing.circle({150, 50}, 20.0);
  drawing.circle({250, 50}, 20.0);
  drawing.polyline({{40, 40}, {60, 40}});
  drawing.polyline({{140, 43.3}, {160, 43.3}});
  const Solid solid = inflated(drawing.document);
  const auto paint = painted(drawing.document, solid);
  ASSERT_TRUE(paint);
  const Result<std::string> bytes = encode_solid(solid, SolidFormat::kGlb, &*paint);
  ASSERT_TRUE(bytes);
  std::uint32_t json_size = 0;
  std::memcpy(&json_size, bytes->data() + 12, sizeof json_size);
  const auto json = nlohmann::json::parse(bytes->substr(20, json_size));
  const std::string buffer = bytes->substr(20 + json_size + 8);
  EXPECT_EQ(json["buffers"][0]["byteLength"], buffer.size());
  for (const auto& view : json["bufferViews"]) EXPECT_EQ(view["byteOffset"].get<int>() % 4, 0);
  ASSERT_EQ(json["images"].size(), 2U);
  EXPECT_EQ(json["meshes"][2]["primitives"].size(), 1U);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& primitives = json["meshes"][i]["primitives"];
    ASSERT_EQ(primitives.size(), 2U);
    std::size_t corners = 0;
    for (const auto& p : primitives) {
      corners += json["accessors"][p["indices"].get<std::size_t>()]["count"].get<std::size_t>();
    }
    EXPECT_EQ(corners, 3 * solid.bodies[i].triangles.size()) << "each triangle is in one of them";
    EXPECT_EQ(primitives[0]["attributes"]["POSITION"], primitives[1]["attributes"]["POSITION"]);
    const auto& uv =
        json["accessors"][primitives[0]["attributes"]["TEXCOORD_0"].get<std::size_t>()];
    EXPECT_EQ(uv["count"], solid.bodies[i].points.size());
    const auto& view = json["bufferViews"][json["images"][i]["bufferView"].get<std::size_t>()];
    const auto png = decode_png(buffer.substr(view["byteOffset"], view["byteLength"]));
    ASSERT_TRUE(png);
    // A ball's texture shows its own circle only, with ink in the first one.
    const double mm = i == 0 ? 60.0 : 40.0;
    EXPECT_NEAR(png->image.width(), mm * paint->px_per_mm, 3.0);
    const Rgba at = png->image.at(png->image.width() / 2, png->image.height() / 3);
    EXPECT_LT(at.r, 60);
    EXPECT_EQ(at.a, 255);
  }
}

}  // namespace
}  // namespace felt::front_paint_test
