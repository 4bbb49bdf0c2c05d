#include "felt/io/svg/svg_compact.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pugixml.hpp>

#include "felt/io/drawing_builder.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::svg_compact_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Stroke stroke_of(std::uint64_t seed, Rgba color) {
  StrokeData data = testing::RandomStroke(seed).make();
  data.color = color;
  return Stroke::create(std::move(data)).value();
}

Drawing drawing_of(const std::vector<Stroke>& strokes) {
  DrawingBuilder builder;
  const std::size_t shown = builder.add_layer({"Shown"});
  for (const Stroke& stroke : strokes) builder.add(shown, stroke);
  const std::size_t hidden = builder.add_layer({"Hidden", false});
  builder.add(hidden, stroke_of(99, {1, 2, 3, 255}));
  return std::move(builder).build();
}

TEST(SvgCompact, IsAValidPictureOfTheVisibleInkOnly) {
  const Rgba red{0xb0, 0x20, 0x20, 255}, clear{0x20, 0x20, 0xb0, 128};
  const Drawing drawing =
      drawing_of({stroke_of(1, {}), stroke_of(2, red), stroke_of(3, red), stroke_of(4, clear)});
  const std::string text =
      svg_compact_text(drawing, {.area = Rect{0, 0, 100, 50}, .paper = Rgba{255, 255, 255, 255}})
          .value();
  pugi::xml_document xml;
  ASSERT_TRUE(xml.load_buffer(text.data(), text.size()));
  const pugi::xml_node svg = xml.child("svg");
  EXPECT_STREQ(svg.attribute("viewBox").value(), "0 0 100 50");
  EXPECT_STREQ(svg.attribute("width").value(), "100mm");
  EXPECT_EQ(svg.select_nodes("//path").size(), 5U) << "the paper and four strokes";
  EXPECT_EQ(svg.select_nodes("g[@fill='#b02020']/path").size(), 2U);
  EXPECT_EQ(svg.select_nodes("path[not(@fill)]").size(), 1U) << "black is left out";
  EXPECT_EQ(svg.select_nodes("path[@fill='#2020b0' and @fill-opacity='0.502']").size(), 1U);
  EXPECT_THAT(text, Not(HasSubstr("felt:")));
  EXPECT_THAT(text, Not(HasSubstr("inkscape")));
  EXPECT_EQ(svg_compact_text(drawing, {.area = Rect{0, 0, 100, 50}, .paper = Rgba{255, 255, 255}})
                .value(),
            text);
}

TEST(SvgCompact, IsSmallAndNeedsNoPaper) {
  std::vector<Stroke> strokes;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) strokes.push_back(stroke_of(seed, {}));
  const Drawing drawing = drawing_of(strokes);
  const std::string small = svg_compact_text(drawing, {}).value();
  EXPECT_LT(2 * small.size(), svg_text(drawing, {}).value().size());
  EXPECT_THAT(small, Not(HasSubstr("fill")));
}

TEST(SvgCompact, WritesAnEmptyDrawing) {
  const std::string text = svg_compact_text(Drawing{}, {}).value();
  pugi::xml_document xml;
  EXPECT_TRUE(xml.load_buffer(text.data(), text.size())) << text;
}

}  // namespace
}  // namespace felt::svg_compact_test
