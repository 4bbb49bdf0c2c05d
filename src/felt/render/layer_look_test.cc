// Tests of translucent layers and pictures, in tiles and in exported pages.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "felt/document/edit_builder.h"
#include "felt/document/testing/random_document.h"
#include "felt/document/testing/small_picture.h"
#include "felt/render/page_painter.h"
#include "felt/render/tile_painter.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::layer_look_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr PixelRect kTile{0, 0, kTileSide, kTileSide};
constexpr View kView{{0, 0}, 4.0};  // 64 x 64 mm

Pixels pixels_of(Bytes& bytes) {
  return {bytes.data(), kTileSide, kTileSide, std::ptrdiff_t{4} * kTileSide, PixelOrder::kRgba};
}

StrokePtr line(Point from, Point to, Rgba color, double width_mm = 4.0) {
  StrokeData data;
  data.points = {from, from + (to - from) / 3.0, to - (to - from) / 3.0, to};
  data.widths = {{0.0, width_mm, 1.0}, {1.0, width_mm, 1.0}};
  data.color = color;
  data.medium = "felt-tip";
  return std::make_shared<const Stroke>(Stroke::create(std::move(data)).value());
}

Document cross(double opacity, LayerPicturePtr picture = {}) {
  Document document;
  EditBuilder builder(document);
  builder.add({1}, line({10, 20}, {50, 20}, {255, 0, 0, 255}));
  builder.add({1}, line({30, 5}, {30, 40}, {255, 0, 0, 255}));
  Edit edit = std::move(builder).build("Draw");
  LayerState state = document.layers()[0].state();
  LayerState faded = state;
  faded.opacity = opacity;
  faded.picture = std::move(picture);
  edit.layers.push_back({{1}, state, faded, 0, 0});
  EXPECT_TRUE(document.apply(edit));
  return document;
}

Bytes tile_of(const InkScene& scene, PixelRect part = kTile, const InkStyle& style = {}) {
  Bytes bytes(std::size_t{4} * kTileSide * kTileSide);
  TilePainter painter;
  InkJob job = TilePainter::job_of(scene, kView, part);
  while (!job.is_done()) painter.draw_next(job, style, pixels_of(bytes));
  return bytes;
}

Rgba at(const Bytes& bytes, double x_mm, double y_mm) {
  const auto x = static_cast<std::size_t>(4.0 * x_mm), y = static_cast<std::size_t>(4.0 * y_mm);
  const std::uint8_t* p = bytes.data() + 4 * (y * kTileSide + x);
  return {p[0], p[1], p[2], p[3]};
}

LayerState* first_state(Edit& edit) {
  return &*edit.layers[0].after;
}

/// An edit that changes the state of the lowest layer.
Edit state_edit(const Document& document) {
  const Layer& layer = document.layers()[0];
  Edit edit;
  edit.label = "Layer";
  edit.layers.push_back({layer.id, layer.state(), layer.state(), 0, 0});
  return edit;
}

TEST(LayerLook, StrokesOfATranslucentLayerDoNotShowThroughEachOther) {
  const Bytes tile = tile_of(InkScene(cross(0.5)));
  EXPECT_EQ(at(tile, 15, 20), (Rgba{128, 0, 0, 128}));
  EXPECT_EQ(at(tile, 30, 20), at(tile, 15, 20)) << "where the lines cross";
  EXPECT_EQ(at(tile, 5, 5), (Rgba{0, 0, 0, 0}));
}

TEST(LayerLook, AnOpaqueLayerAndAnInvisibleOne) {
  EXPECT_EQ(at(tile_of(InkScene(cross(1.0))), 30, 20), (Rgba{255, 0, 0, 255}));
  EXPECT_EQ(at(tile_of(InkScene(cross(0.0))), 30, 20), (Rgba{0, 0, 0, 0}));
}

TEST(LayerLook, APictureIsBelowTheStrokes) {
  const Bytes tile = tile_of(InkScene(cross(1.0, testing::red_blue_picture(20, 30))));
  EXPECT_EQ(at(tile, 22, 35), (Rgba{255, 0, 0, 255}));
  EXPECT_EQ(at(tile, 38, 35), (Rgba{0, 0, 255, 255}));
  EXPECT_EQ(at(tile, 45, 35), (Rgba{0, 0, 0, 0}));
  EXPECT_EQ(at(tile, 30, 35), (Rgba{255, 0, 0, 255})) << "a stroke";
  const Rgba faded = at(tile_of(InkScene(cross(0.25, testing::red_blue_picture(20, 30)))), 38, 35);
  EXPECT_EQ(faded, (Rgba{0, 0, 64, 64}));
}

TEST(LayerLook, APictureTurnsAndIsAveragedWhenItIsSmall) {
  LayerPicture turned = *testing::red_blue_picture(0, 0);
  turned.place = {0, 10, -10, 0, 30, 10};  // a quarter turn: red above blue
  const Bytes upright = tile_of(InkScene(cross(1.0, std::make_shared<LayerPicture>(turned))));
  EXPECT_EQ(at(upright, 24, 12), (Rgba{255, 0, 0, 255}));
  EXPECT_EQ(at(upright, 24, 28), (Rgba{0, 0, 255, 255}));
  turned.place = {0.125, 0, 0, 0.125, 50, 50};  // one pixel of the tile
  const Bytes small = tile_of(InkScene(cross(1.0, std::make_shared<LayerPicture>(turned))));
  const Rgba mixed = at(small, 50, 50);
  EXPECT_NEAR(mixed.r, mixed.b, 2);
  EXPECT_GT(mixed.r, 30);
}

TEST(LayerLook, APartOfATileEqualsTheWholeTile) {
  const InkScene scene(cross(0.6, testing::red_blue_picture(20, 12)));
  const Bytes whole = tile_of(scene), part = tile_of(scene, {70, 40, 170, 130});
  for (int y = 40; y < 130; ++y) {
    for (int x = 70; x < 170; ++x) {
      const std::size_t i =
          4 * (static_cast<std::size_t>(y) * kTileSide + static_cast<std::size_t>(x));
      ASSERT_TRUE(std::equal(&whole[i], &whole[i] + 4, &part[i])) << x << ' ' << y;
    }
  }
}

/// Repaints only the damage of an edit and compares with a new tile.
void check_damage(Document& document, const Edit& edit) {
  InkScene scene(document);
  Bytes old = tile_of(scene);
  InkDamage damage;
  ASSERT_TRUE(scene.apply(edit, damage));
  ASSERT_TRUE(document.apply(edit));
  const Bytes now = tile_of(scene);
  EXPECT_EQ(now, tile_of(InkScene(document)));
  for (int y = 0; y < kTileSide; ++y) {
    for (int x = 0; x < kTileSide; ++x) {
      const std::size_t i =
          4 * (static_cast<std::size_t>(y) * kTileSide + static_cast<std::size_t>(x));
      if (std::equal(&now[i], &now[i] + 4, &old[i])) continue;
      const Point mm = kView.to_mm({x + 0.5, y + 0.5});
      const bool is_in = std::any_of(damage.begin(), damage.end(),
                                     [mm](const Rect& r) { return r.inflated(0.5).contains(mm); });
      ASSERT_TRUE(is_in) << x << ' ' << y;
    }
  }
}

TEST(LayerLook, DamageCoversEveryChangeOfALook) {
  Document document = cross(1.0);
  Edit edit = state_edit(document);
  first_state(edit)->opacity = 0.5;
  check_damage(document, edit);
  edit = state_edit(document);
  first_state(edit)->picture = testing::red_blue_picture(5, 5);
  check_damage(document, edit);
  edit = state_edit(document);
  first_state(edit)->picture = placed(*document.layers()[0].picture, {3, 1, -1, 3, 40, 40});
  check_damage(document, edit);
  check_damage(document, edit.inverse());
  edit = state_edit(document);
  first_state(edit)->picture = nullptr;
  check_damage(document, edit);
  edit = state_edit(document);
  first_state(edit)->blend = BlendMode::kMultiply;
  check_damage(document, edit);
  edit = state_edit(document);
  first_state(edit)->group =
      std::make_shared<const LayerGroup>(LayerGroup{{1}, "Cat", true, false, 0.5});
  check_damage(document, edit);
  edit = state_edit(document);
  first_state(edit)->group = std::make_shared<const LayerGroup>(LayerGroup{{1}, "Cat", false});
  check_damage(document, edit);
  check_damage(document, edit.inverse());
}

/// Adds a layer with a line from (x, 10) down, with this look.
void add_line(Document& document, double x, Rgba color, const LayerState& state) {
  const LayerId id = document.new_layer_id();
  Edit add;
  add.layers.push_back({id, std::nullopt, state, 0, document.layers().size()});
  ASSERT_TRUE(document.apply(add));
  EditBuilder builder(document);
  builder.add(id, line({x, 10}, {x, 50}, color));
  ASSERT_TRUE(document.apply(std::move(builder).build("Draw")));
}

TEST(LayerLook, MultiplyHasTheColorsOfTheFormulaOfCss) {
  for (int i = 0; i < 20'000; ++i) {
    // Premultiplied pixels with levels up to their alpha.
    const auto byte = [n = static_cast<unsigned>(i) * 2654435761U](unsigned k, unsigned top) {
      return static_cast<std::uint8_t>(((n >> k) ^ (n << 3U) ^ (n >> (2 * k))) % (top + 1));
    };
    const std::uint8_t a = byte(3, 255), b = byte(11, 255);
    std::array<std::uint8_t, 4> from{byte(5, a), byte(7, a), byte(9, a), a};
    std::array<std::uint8_t, 4> to{byte(2, b), byte(4, b), byte(6, b), b};
    const std::array<std::uint8_t, 3> paper{byte(1, 255), byte(8, 255), 255};
    const double opacity = (i % 5) / 4.0, cover = opacity * a / 255.0;
    std::array<double, 4> wanted{};
    for (std::size_t k = 0; k < 3; ++k) {
      // The target on the paper times the source on white, less the paper that stays visible.
      const double under = to[k] / 255.0 + (1.0 - b / 255.0) * paper[k] / 255.0;
      const double color = under * (1.0 - cover + opacity * from[k] / 255.0);
      wanted[k] = 255.0 * color - (1.0 - cover) * (1.0 - b / 255.0) * paper[k];
    }
    wanted[3] = 255.0 * (cover + b / 255.0 - cover * b / 255.0);
    const Pixels source{from.data(), 1, 1, 4, PixelOrder::kRgba};
    const Pixels target{to.data(), 1, 1, 4, PixelOrder::kRgba};
    blend(source, {0, 0, 1, 1}, opacity, BlendMode::kMultiply, {paper[0], paper[1], paper[2], 255},
          target);
    for (std::size_t k = 0; k < 4; ++k) ASSERT_NEAR(to[k], wanted[k], 1.5) << i << ' ' << k;
    for (std::size_t k = 0; k < 3; ++k) ASSERT_LE(to[k], to[3]);
  }
}

TEST(LayerLook, AMultiplyingLayerMakesWhatIsBelowDarker) {
  Document document = cross(1.0);
  LayerState state{"Shade"};
  state.blend = BlendMode::kMultiply;
  add_line(document, 30, {128, 255, 255, 255}, state);
  const Bytes tile = tile_of(InkScene(document));
  EXPECT_EQ(at(tile, 30, 20), (Rgba{128, 0, 0, 255})) << "on the red cross";
  EXPECT_EQ(at(tile, 30, 45), (Rgba{128, 255, 255, 255})) << "on the paper, which is white";
  InkStyle craft;
  craft.paper = {200, 100, 50, 255};
  EXPECT_EQ(at(tile_of(InkScene(document), kTile, craft), 30, 45), (Rgba{100, 100, 50, 255}));
}

TEST(LayerLook, AGroupIsFadedAsAWhole) {
  Document document;
  LayerState state{"A"};
  state.group = std::make_shared<const LayerGroup>(LayerGroup{{1}, "Cat", true, false, 0.5});
  add_line(document, 30, {255, 0, 0, 255}, state);
  add_line(document, 31, {0, 0, 255, 255}, state);
  const Bytes tile = tile_of(InkScene(document));
  EXPECT_EQ(at(tile, 28.5, 20), (Rgba{128, 0, 0, 128}));
  EXPECT_EQ(at(tile, 31, 20), (Rgba{0, 0, 128, 128})) << "the red line does not show through";
  state.blend = BlendMode::kMultiply;
  add_line(document, 31, {0, 255, 0, 255}, state);
  EXPECT_EQ(at(tile_of(InkScene(document)), 31, 20), (Rgba{0, 0, 0, 128}))
      << "its layers are blended with each other, and the result is faded";
}

/// Tiles and exported pages are painted by different code. A picture of a layer whose ink is
/// elsewhere is blended in one step or in two, so rounding may differ.
TEST(LayerLook, TilesEqualThePageForAnyLooksAndGroups) {
  const PageOptions options{.dpi = 101.6, .area = Rect{0, 0, 64, 64}, .paper = {0, 0, 0, 0}};
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Document document;
    testing::RandomEdits edits(seed);
    for (int i = 0; i < 15; ++i) ASSERT_TRUE(document.apply(edits.next(document)));
    const Image page = render_page(document, options, PictureChoice::kAll).value();
    const Bytes tile = tile_of(InkScene(document));
    const Bytes part = tile_of(InkScene(document), {64, 64, 192, 192});
    int worst = 0, worst_of_part = 0;
    for (std::size_t i = 0; i < tile.size(); ++i) {
      worst = std::max(worst, std::abs(int{tile[i]} - int{page.bytes()[i]}));
      const std::size_t x = i / 4 % kTileSide, y = i / 4 / kTileSide;
      if (std::min(x, y) < 64 || std::max(x, y) >= 192) continue;
      worst_of_part = std::max(worst_of_part, std::abs(int{tile[i]} - int{part[i]}));
    }
    EXPECT_LE(worst, 2) << seed;
    EXPECT_LE(worst_of_part, 2) << seed;
    const Edit next = edits.next(document);
    InkScene scene(document);
    InkDamage damage;
    ASSERT_TRUE(scene.apply(next, damage));
    ASSERT_TRUE(document.apply(next));
    EXPECT_EQ(tile_of(scene), tile_of(InkScene(document))) << seed;
  }
}

TEST(LayerLook, AMovedPictureIsPreviewed) {
  const Document document = cross(0.5, testing::red_blue_picture(5, 5));
  InkScene scene(document);
  const Bytes before = tile_of(scene);
  Edit edit = state_edit(document);
  first_state(edit)->picture = placed(*document.layers()[0].picture, {3, 0, 0, 3, 40, 50});
  InkDamage damage;
  ASSERT_TRUE(scene.show(edit, damage));
  EXPECT_NE(tile_of(scene), before);
  ASSERT_TRUE(scene.show(std::nullopt, damage));
  EXPECT_EQ(tile_of(scene), before);
}

/// Adds a picture layer and a translucent layer below a layer with many strokes. A tile made with a
/// split must equal one that is drawn directly.
TEST(LayerLook, ASplitContainsTheSpecialLayersBelowThePreview) {
  Document document = cross(0.5, testing::red_blue_picture(5, 5));
  Edit add;
  add.layers.push_back({{2}, std::nullopt, LayerState{"Top"}, 0, 1});
  ASSERT_TRUE(document.apply(add));
  EditBuilder builder(document);
  for (std::uint64_t i = 0; i < 20; ++i) {
    builder.add({2}, std::make_shared<const Stroke>(testing::random_stroke(i)));
  }
  ASSERT_TRUE(document.apply(std::move(builder).build("Draw")));
  for (const std::uint64_t layer : {2U, 1U}) {
    InkScene scene(document);
    const auto& strokes = document.layer({layer})->strokes;
    const StrokeId moved = strokes[strokes.size() / 2];
    TilePainter painter;
    TileSplit split;
    int splits = 0;
    for (int k = 0; k < 4; ++k) {
      StrokeData data = document.find(moved)->data();
      for (Point& p : data.points) p = p + Vec{0.5 * k, 0.25 * k};
      if (data.closed) data.points.back() = data.points.front();
      EditBuilder preview(document);
      preview.replace(moved, std::make_shared<const Stroke>(Stroke::create(data).value()));
      InkDamage damage;
      ASSERT_TRUE(scene.show(std::move(preview).build("Pull"), damage));
      Bytes bytes(std::size_t{4} * kTileSide * kTileSide);
      Pixels pixels = pixels_of(bytes);
      pixels.order = PixelOrder::kBgra;
      Bytes direct(bytes.size());
      Pixels direct_pixels = pixels_of(direct);
      direct_pixels.order = PixelOrder::kBgra;
      InkJob job = TilePainter::job_of(scene, kView, kTile);
      while (!job.is_done()) painter.draw_next(job, {}, direct_pixels);
      if (!painter.paint_split(scene, kView, kTile, {}, split, pixels)) continue;
      ++splits;
      int worst = 0;
      for (std::size_t i = 0; i < bytes.size(); ++i) {
        worst = std::max(worst, std::abs(bytes[i] - direct[i]));
      }
      EXPECT_LE(worst, 2) << "sample " << k;
    }
    EXPECT_EQ(splits, layer == 2 ? 4 : 0) << "a translucent layer is drawn as a whole";
  }
}

TEST(LayerLook, AnExportedPageShowsOpacityButNoPictureUnlessAsked) {
  LayerPicture picture = *testing::red_blue_picture(5, 45);
  const PageOptions options{.dpi = 101.6, .area = Rect{0, 0, 64, 64}, .paper = {0, 0, 0, 0}};
  const auto page = [&](PictureChoice choice) {
    const Document document = cross(0.5, std::make_shared<LayerPicture>(picture));
    return render_page(document, options, choice).value();
  };
  EXPECT_EQ(page(PictureChoice::kMarked).at(120, 80), (Rgba{128, 0, 0, 128}));
  EXPECT_EQ(page(PictureChoice::kMarked).at(90, 200), (Rgba{0, 0, 0, 0}));
  EXPECT_EQ(page(PictureChoice::kAll).at(90, 200), (Rgba{0, 0, 128, 128}));
  picture.exported = true;
  EXPECT_EQ(page(PictureChoice::kMarked).at(90, 200), (Rgba{0, 0, 128, 128}));
}

TEST(LayerLook, ADamagedPictureIsAnErrorOnAPageAndInvisibleInTiles) {
  auto data = std::make_shared<PictureData>(*testing::picture_data());
  data->png.resize(50);
  EXPECT_FALSE(PicturePixels::decode(*data));
  const Document document = cross(1.0, std::make_shared<LayerPicture>(LayerPicture{data, {}}));
  const auto page = render_page(document, {.dpi = 30.0}, PictureChoice::kAll);
  ASSERT_FALSE(page);
  EXPECT_EQ(page.error().message.find("layer \"Ink\": the PNG file is damaged: "), 0U);
  EXPECT_EQ(tile_of(InkScene(document)), tile_of(InkScene(cross(1.0))));
}

TEST(LayerLook, LayersWithTheSamePictureShareItsPixels) {
  Document document = cross(1.0, testing::red_blue_picture(5.0, 5.0));
  Edit edit;
  LayerState state{"Copy"};
  state.picture = testing::red_blue_picture(30.0, 5.0);
  edit.layers.push_back({{2}, std::nullopt, state, 0, 1});
  ASSERT_TRUE(document.apply(edit));
  InkScene scene(document);
  const std::vector<const SceneLayer*> layers = scene.special_layers();
  ASSERT_EQ(layers.size(), 2U);
  EXPECT_TRUE(layers[0]->pixels);
  EXPECT_EQ(layers[0]->pixels, layers[1]->pixels);
}

}  // namespace
}  // namespace felt::layer_look_test
