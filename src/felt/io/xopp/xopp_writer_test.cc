#include "felt/io/xopp/xopp_writer.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "felt/io/testing/import_checks.h"
#include "felt/io/testing/random_layers.h"
#include "felt/io/unpack.h"
#include "felt/io/xopp/xopp_import.h"
#include "felt/stroke/outline/outline.h"

namespace felt::xopp_writer_test {
namespace {

using testing::distance_of;

using ::testing::HasSubstr;

Drawing one(Stroke stroke, const std::string& layer = "ink") {
  DrawingBuilder builder;
  builder.drawing().has_page = true;
  builder.add(builder.add_layer({layer}), std::move(stroke));
  return std::move(builder).build();
}

std::string text_of(const Drawing& drawing) {
  return gunzip(xopp_bytes(drawing).value()).value();
}

TEST(XoppWriter, AStraightStrokeInPoints) {
  const std::string text =
      text_of(one(testing::straight_stroke({25.4, 50.8}, {50.8, 50.8}, 2.54, 2.54)));
  EXPECT_THAT(text, HasSubstr("<page width=\"841.8898\" height=\"595.2756\">"));
  EXPECT_THAT(text, HasSubstr("<stroke tool=\"pen\" color=\"#000000ff\" width=\"7.2\" "
                              "capStyle=\"round\">72 144 144 144</stroke>"));
  EXPECT_THAT(text, HasSubstr("<layer name=\"ink\">"));
}

TEST(XoppWriter, WidthsComeInSmallSteps) {
  const Drawing drawing = one(testing::straight_stroke({0, 0}, {50, 0}, 1.0, 2.0));
  const Stroke s = testing::only_stroke(import_xopp(xopp_bytes(drawing).value()).value());
  const double end = s.segment_count();
  for (double t = 0.0; t <= 1.0; t += 0.05) {
    const double x = s.position(t * end).x;
    EXPECT_NEAR(s.width_mm(t * end), 1.0 + x / 50.0, 0.5 * kXoppWidthStepMm + 0.021);
  }
}

TEST(XoppWriter, ComesBackNearlyAsItWas) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    Drawing drawing = testing::random_layers(seed);
    drawing.has_page = true;
    const Imported back = import_xopp(xopp_bytes(drawing).value()).value();
    EXPECT_TRUE(back.report.empty());
    EXPECT_NEAR(back.drawing.page.width_mm, drawing.page.width_mm, 1e-4);
    const std::size_t layers = drawing.document.layers().size();
    ASSERT_EQ(back.drawing.document.layers().size(), layers);
    for (std::size_t i = 0; i < layers; ++i) {
      const std::vector<Stroke> was = testing::strokes_in(drawing.document, i);
      const std::vector<Stroke> is = testing::strokes_in(back.drawing.document, i);
      ASSERT_EQ(is.size(), was.size());
      for (std::size_t k = 0; k < was.size(); ++k) {
        EXPECT_EQ(is[k].color(), was[k].color());
        EXPECT_LE(distance_of(was[k], is[k]), 0.1);
      }
    }
  }
}

TEST(XoppWriter, WithoutAnAreaThePageIsTheInkAndAMargin) {
  Drawing drawing = one(testing::straight_stroke({-100, 50}, {0, 50}, 2, 2));
  drawing.has_page = false;
  const Imported back = import_xopp(xopp_bytes(drawing).value()).value();
  EXPECT_NEAR(back.drawing.page.width_mm, 112.0, 1e-4);
  EXPECT_NEAR(back.drawing.page.height_mm, 12.0, 1e-4);
  EXPECT_NEAR(testing::strokes_in(back.drawing.document, 0)[0].position(0).x, 6.0, 1e-4);
}

TEST(XoppWriter, TranslucentInkIsAHighlighters) {
  StrokeData data = testing::straight_stroke({0, 0}, {50, 0}, 5, 5).data();
  data.color = {255, 255, 0, 0x60};
  const std::string text = text_of(one(Stroke::create(data).value()));
  EXPECT_THAT(text, HasSubstr("<stroke tool=\"highlighter\" color=\"#ffff0060\""));
}

TEST(XoppWriter, EqualDrawingsGiveEqualBytes) {
  const Drawing drawing = testing::random_layers(11);
  EXPECT_EQ(xopp_bytes(drawing).value(), xopp_bytes(drawing).value());
  EXPECT_EQ(text_of({}), text_of({}));
  EXPECT_TRUE(import_xopp(xopp_bytes({}).value()));
}

TEST(XoppWriter, WhatCannotBeWrittenIsAnError) {
  Drawing drawing = one(testing::straight_stroke({0, 0}, {1.1e9, 0}, 1, 1));
  EXPECT_THAT(xopp_bytes(drawing).error().message, HasSubstr("stroke 1: a coordinate beyond 1e9"));
  drawing = one(testing::straight_stroke({0, 0}, {1e9, 0}, 1, 1));
  EXPECT_TRUE(xopp_bytes(drawing));
  drawing = one(testing::straight_stroke({0, 0}, {1, 0}, 1, 1), "\x01");
  EXPECT_THAT(xopp_bytes(drawing).error().message, HasSubstr("a layer's name"));
}

}  // namespace
}  // namespace felt::xopp_writer_test
