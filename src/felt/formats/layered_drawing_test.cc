#include "felt/formats/layered_drawing.h"

#include <gtest/gtest.h>

#include "felt/document/testing/random_document.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/testing/random_drawing.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt {
namespace {

using testing::random_drawing;

SketchStroke named(const char* id, std::uint64_t seed = 1) {
  return {id, testing::random_stroke(seed)};
}

std::vector<std::uint64_t> ids_of(const StoredDrawing& drawing) {
  std::vector<std::uint64_t> ids;
  for (const Layer& layer : drawing.document.layers()) {
    for (const StrokeId id : layer.strokes) ids.push_back(id.value);
  }
  return ids;
}

TEST(LayeredDrawing, TravelsAndComesBackAsItWas) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const StoredDrawing drawing = random_drawing(seed);
    const StoredDrawing back = stored_drawing(layered_sketch(drawing));
    EXPECT_TRUE(testing::is_consistent(back.document)) << "seed " << seed;
    EXPECT_EQ(back.document, drawing.document) << "seed " << seed;
    EXPECT_EQ(back.page, drawing.page) << "seed " << seed;
    EXPECT_EQ(flat_sketch(layered_sketch(drawing)), visible_strokes(drawing.document));
  }
}

TEST(LayeredDrawing, HiddenLayersMayStayAtHome) {
  const StoredDrawing drawing = random_drawing(7);
  Sketch strokes;
  for (const SketchLayer& layer : layered_sketch(drawing, LayerChoice::kVisible).layers) {
    EXPECT_TRUE(layer.visible);
    strokes.insert(strokes.end(), layer.strokes.begin(), layer.strokes.end());
  }
  EXPECT_EQ(strokes, visible_strokes(drawing.document));
}

TEST(LayeredDrawing, NamesThatAreNoIdOfOursGetNewOnes) {
  LayeredSketch sketch;
  sketch.layers.push_back({"a", true, false, {named("leaf"), named("s7"), named("s7"), named("")}});
  sketch.layers.push_back(
      {"b", true, false, {named("s3"), named("s03"), named("s0"), named("s99999999999999999999")}});
  EXPECT_EQ(ids_of(stored_drawing(sketch)),
            (std::vector<std::uint64_t>{8, 7, 9, 10, 3, 11, 12, 13}));
}

TEST(LayeredDrawing, WhatNoDrawingCanHaveIsMadeToFit) {
  LayeredSketch sketch;
  EXPECT_EQ(stored_drawing(sketch).document, Document());
  sketch.layers = {{"", true, true, {}},
                   {"\xff", false, false, {}},
                   {std::string(5000, 'x'), true, false, {}},
                   {std::string("a\0b", 3), true, false, {}}};
  sketch.page = SheetPage{6000.0, 100.0, {1, 2, 3, 4}};
  const StoredDrawing drawing = stored_drawing(sketch);
  const auto layers = drawing.document.layers();
  ASSERT_EQ(layers.size(), 4u);
  EXPECT_EQ(layers[0].state(), (LayerState{"Layer 1", true, true}));
  EXPECT_EQ(layers[1].state(), (LayerState{"Layer 2", false, false}));
  EXPECT_EQ(layers[2].name, "Layer 3");
  EXPECT_EQ(layers[3].name, "Layer 4");
  EXPECT_EQ(drawing.page.width_mm, SheetPage{}.width_mm);
  EXPECT_EQ(drawing.page.paper, (Rgba{1, 2, 3, 4}));
}

TEST(LayeredDrawing, ANameCannotUseUpTheNumbers) {
  LayeredSketch sketch;
  sketch.layers.push_back(
      {"Ink",
       true,
       false,
       {named("s9007199254740991"), named("s1099511627775", 2), named("x", 3)}});
  const StoredDrawing drawing = stored_drawing(std::move(sketch));
  const auto bytes = felt_bytes(drawing);
  ASSERT_TRUE(bytes) << bytes.error().message;
  EXPECT_EQ(parse_felt(*bytes).value(), drawing);
}

}  // namespace
}  // namespace felt
