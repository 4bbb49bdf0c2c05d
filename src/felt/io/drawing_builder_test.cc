#include "felt/io/drawing_builder.h"

#include <gtest/gtest.h>

#include <string>

#include "felt/stroke/testing/random_stroke.h"

namespace felt::drawing_builder_test {
namespace {

std::vector<std::uint64_t> ids_of(const Drawing& drawing) {
  std::vector<std::uint64_t> ids;
  for (const Layer& layer : drawing.document.layers()) {
    for (const StrokeId id : layer.strokes) ids.push_back(id.value);
  }
  return ids;
}

TEST(DrawingBuilder, NamesThatAreNoIdOfOursGetNewOnes) {
  DrawingBuilder builder;
  builder.add_layer({"a"});
  builder.add_layer({"b"});
  // The order of the layers counts, not the order in which strokes were added.
  for (const char* name : {"s3", "s03", "s0", "s99999999999999999999"}) {
    builder.add(1, testing::random_stroke(1), name);
  }
  for (const char* name : {"leaf", "s7", "s7", ""}) {
    builder.add(0, testing::random_stroke(1), name);
  }
  EXPECT_EQ(ids_of(std::move(builder).build()),
            (std::vector<std::uint64_t>{8, 7, 9, 10, 3, 11, 12, 13}));
}

TEST(DrawingBuilder, OtherNamesAreKept) {
  DrawingBuilder builder;
  builder.add_layer({"a"});
  for (const char* name : {"cat-1", "s7", "s07", "cat-1", "s7", "", "\xff"}) {
    builder.add(0, testing::random_stroke(1), name);
  }
  builder.add(0, testing::random_stroke(1), std::string_view("a\0b", 3));
  const Drawing drawing = std::move(builder).build();
  std::vector<std::string> names;
  for (const StrokeId id : drawing.document.layers()[0].strokes) {
    names.push_back(name_in_file(drawing, id));
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"cat-1", "s7", "s07", "cat-1", "s7", "s12", "s13", "s14"}));
}

TEST(DrawingBuilder, WithoutALayerThereIsAnEmptyOne) {
  const Drawing drawing = DrawingBuilder().build();
  EXPECT_EQ(drawing.document, Document());
  EXPECT_FALSE(drawing.has_page);
}

TEST(DrawingBuilder, WhatNoDrawingCanHaveIsMadeToFit) {
  DrawingBuilder builder;
  builder.add_layer({"", true, true});
  builder.add_layer({"\xff", false, false});
  builder.add_layer({std::string(5000, 'x')});
  builder.add_layer({std::string("a\0b", 3)});
  builder.drawing().page = Page{6000.0, 100.0, {1, 2, 3, 4}, "\xff"};
  const Drawing drawing = std::move(builder).build();
  const auto layers = drawing.document.layers();
  ASSERT_EQ(layers.size(), 4u);
  EXPECT_EQ(layers[0].state(), (LayerState{"Layer 1", true, true}));
  EXPECT_EQ(layers[1].state(), (LayerState{"Layer 2", false, false}));
  EXPECT_EQ(layers[2].name, "Layer 3");
  EXPECT_EQ(layers[3].name, "Layer 4");
  EXPECT_EQ(drawing.page, (Page{.paper = {1, 2, 3, 4}}));
}

TEST(DrawingBuilder, ANameCannotUseUpTheNumbers) {
  DrawingBuilder builder;
  builder.add_layer({"Ink"});
  for (const char* name : {"s9007199254740991", "s1099511627775", "x"}) {
    builder.add(0, testing::random_stroke(1), name);
  }
  builder.add(0, std::make_shared<const Stroke>(testing::random_stroke(2)),
              StrokeId{9007199254740991});
  EXPECT_EQ(
      ids_of(std::move(builder).build()),
      (std::vector<std::uint64_t>{1099511627776, 1099511627775, 1099511627777, 1099511627778}));
}

TEST(DrawingBuilder, StrokesOfAnotherDocumentAreShared) {
  const StrokePtr stroke = std::make_shared<const Stroke>(testing::random_stroke(3));
  DrawingBuilder builder;
  builder.add(builder.add_layer({"Ink"}), stroke, StrokeId{12});
  EXPECT_EQ(std::move(builder).build().document.find({12}), stroke);
}

}  // namespace
}  // namespace felt::drawing_builder_test
