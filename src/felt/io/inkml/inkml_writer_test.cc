#include "felt/io/inkml/inkml_writer.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "felt/io/inkml/inkml_import.h"
#include "felt/io/testing/import_checks.h"
#include "felt/io/testing/random_layers.h"
#include "felt/stroke/outline/flatten.h"

namespace felt {
namespace {

using testing::distance_of;

using ::testing::HasSubstr;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    text.replace(at, from.size(), to);
    at += to.size();
  }
  return text;
}

LayeredSketch one_stroke() {
  LayeredSketch drawing;
  drawing.layers.emplace_back();
  drawing.layers[0].name = "ink";
  drawing.layers[0].strokes.push_back({"a", testing::random_stroke(3)});
  return drawing;
}

TEST(InkmlWriter, OurOwnComesBackExactly) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const LayeredSketch drawing = testing::random_layers(seed);
    const std::string text = inkml_text(drawing).value();
    const ImportedDrawing back = import_inkml(text).value();
    EXPECT_EQ(back.drawing, drawing) << "seed " << seed;
    EXPECT_TRUE(back.report.empty()) << notice_text(back.report.notices()[0]);
    EXPECT_EQ(inkml_text(back.drawing).value(), text) << "seed " << seed;
  }
}

TEST(InkmlWriter, OthersReadTheSameInkFromTheTraces) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const LayeredSketch drawing = testing::random_layers(seed);
    const std::string text =
        replaced(inkml_text(drawing).value(), "https://feltline.org/ns/inkml/1", "elsewhere");
    const ImportedDrawing back = import_inkml(text).value();
    Sketch all, read;
    for (const SketchLayer& l : drawing.layers)
      all.insert(all.end(), l.strokes.begin(), l.strokes.end());
    for (const SketchLayer& l : back.drawing.layers)
      read.insert(read.end(), l.strokes.begin(), l.strokes.end());
    ASSERT_EQ(all.size(), read.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(all[i].stroke.color(), read[i].stroke.color());
      EXPECT_LE(distance_of(all[i].stroke, read[i].stroke), 0.08) << i;
      EXPECT_NEAR(all[i].stroke.width_mm(0.0), read[i].stroke.width_mm(0.0), 0.1) << i;
    }
  }
}

TEST(InkmlWriter, AChangedTraceCountsMoreThanTheCurveBesideIt) {
  const std::string text = inkml_text(one_stroke()).value();
  const std::size_t at = text.find('>', text.find("<trace xml:id"));
  std::string moved = text;
  moved.insert(at + 1, "500 500 1, ");
  const ImportedDrawing back = import_inkml(moved).value();
  ASSERT_EQ(back.report.notices().size(), 1u);
  EXPECT_THAT(notice_text(back.report.notices()[0]), HasSubstr("was changed by another program"));
  EXPECT_NEAR(back.drawing.layers[0].strokes[0].stroke.position(0.0).x, 500.0, 0.1);
  EXPECT_EQ(back.drawing.layers[0].name, "ink");
}

TEST(InkmlWriter, TonesAreWrittenWhereTheyAreNotThoseOfTheWidths) {
  LayeredSketch drawing = one_stroke();
  StrokeData data = testing::straight_stroke({0, 0}, {10, 0}, 1, 2).data();
  drawing.layers[0].strokes = {{"s", Stroke::create(data).value()}};
  EXPECT_EQ(inkml_text(drawing).value().find("felt:tones"), std::string::npos);
  data.widths[1].tone = 0.125;
  drawing.layers[0].strokes = {{"s", Stroke::create(data).value()}};
  const std::string text = inkml_text(drawing).value();
  EXPECT_EQ(import_inkml(text).value().drawing, drawing);
  const std::size_t at = text.find("felt:tones=\"") + 12, end = text.find('"', at);
  EXPECT_THAT(text.substr(at, end - at), ::testing::EndsWith(" 0.125"));
  for (const char* tones : {"0.5", "0.5 0.5 0.5", "0 1.5", "0 -0.5", "0 nan", "0 x"}) {
    SCOPED_TRACE(tones);
    const ImportedDrawing back =
        import_inkml(text.substr(0, at) + tones + text.substr(end)).value();
    ASSERT_EQ(back.report.notices().size(), 1u);
    EXPECT_THAT(notice_text(back.report.notices()[0]), HasSubstr("tones that are not one number"));
    EXPECT_EQ(back.drawing.layers[0].strokes.size(), 1u);
  }
}

TEST(InkmlWriter, OtherSpacingOfTheSameTraceChangesNothing) {
  const LayeredSketch drawing = one_stroke();
  const std::string text = replaced(inkml_text(drawing).value(), ", ", " ,\n   ");
  EXPECT_EQ(import_inkml(text).value().drawing, drawing);
}

TEST(InkmlWriter, AnotherScaleIsAChange) {
  const std::string text =
      replaced(inkml_text(one_stroke()).value(), "units=\"mm\"", "units=\"cm\"");
  EXPECT_FALSE(import_inkml(text).value().report.empty());
}

TEST(InkmlWriter, AnotherColourIsTaken) {
  LayeredSketch drawing = one_stroke();
  const std::string text = inkml_text(drawing).value();
  const std::size_t at = text.find("value=\"#") + 7;
  const ImportedDrawing back =
      import_inkml(text.substr(0, at) + "#010203" + text.substr(at + 7)).value();
  const Rgba was = drawing.layers[0].strokes[0].stroke.color();
  EXPECT_EQ(back.drawing.layers[0].strokes[0].stroke.color(), (Rgba{1, 2, 3, was.a}));
  EXPECT_EQ(back.drawing.layers[0].strokes[0].stroke.widths().size(),
            drawing.layers[0].strokes[0].stroke.widths().size());
}

TEST(InkmlWriter, WhatXmlCannotHoldIsAnErrorThatNamesIt) {
  LayeredSketch drawing = one_stroke();
  drawing.layers[0].strokes[0].id = "a\x01";
  EXPECT_THAT(inkml_text(drawing).error().message, HasSubstr("stroke 1: XML cannot hold"));
  drawing = one_stroke();
  drawing.layers[0].name = "\xff";
  EXPECT_THAT(inkml_text(drawing).error().message, HasSubstr("a layer's name: "));
  drawing = one_stroke();
  drawing.layers[0].strokes[0].id = std::string(4096, 'x');
  EXPECT_EQ(import_inkml(inkml_text(drawing).value()).value().drawing, drawing);
  drawing.layers[0].strokes[0].id += 'x';
  EXPECT_THAT(inkml_text(drawing).error().message, HasSubstr("more than 4096 bytes"));
  drawing.layers[0].strokes = {{"far", testing::straight_stroke({0, 0}, {1e9, 0}, 1, 1)}};
  EXPECT_EQ(import_inkml(inkml_text(drawing).value()).value().drawing, drawing);
  drawing.layers[0].strokes = {{"far", testing::straight_stroke({0, 0}, {1.1e9, 0}, 1, 1)}};
  EXPECT_THAT(inkml_text(drawing).error().message, HasSubstr("beyond 1e9 mm"));
}

}  // namespace
}  // namespace felt
