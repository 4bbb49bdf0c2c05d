#include "felt/io/inkml/inkml_writer.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "felt/io/inkml/inkml_import.h"
#include "felt/io/testing/import_checks.h"
#include "felt/io/testing/random_layers.h"
#include "felt/stroke/outline/outline.h"

namespace felt::inkml_writer_test {
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

Drawing ink_of(const Stroke& stroke, const std::string& layer = "ink") {
  DrawingBuilder builder;
  builder.add(builder.add_layer({layer}), stroke);
  return std::move(builder).build();
}

Drawing one_stroke() {
  return ink_of(testing::random_stroke(3));
}

TEST(InkmlWriter, OurOwnComesBackExactly) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Drawing drawing = testing::random_layers(seed);
    const std::string text = inkml_text(drawing).value();
    const Imported back = import_inkml(text).value();
    EXPECT_EQ(back.drawing, drawing) << "seed " << seed;
    EXPECT_TRUE(back.report.empty()) << notice_text(back.report.notices()[0]);
    EXPECT_EQ(inkml_text(back.drawing).value(), text) << "seed " << seed;
  }
}

TEST(InkmlWriter, OthersReadTheSameInkFromTheTraces) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const Drawing drawing = testing::random_layers(seed);
    const std::string text =
        replaced(inkml_text(drawing).value(), "https://feltline.org/ns/inkml/1", "elsewhere");
    const Imported back = import_inkml(text).value();
    const std::vector<Stroke> all = testing::strokes_in(drawing.document);
    const std::vector<Stroke> read = testing::strokes_in(back.drawing.document);
    ASSERT_EQ(all.size(), read.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(all[i].color(), read[i].color());
      EXPECT_LE(distance_of(all[i], read[i]), 0.08) << i;
      EXPECT_NEAR(all[i].width_mm(0.0), read[i].width_mm(0.0), 0.1) << i;
    }
  }
}

TEST(InkmlWriter, AChangedTraceCountsMoreThanTheCurveBesideIt) {
  const std::string text = inkml_text(one_stroke()).value();
  const std::size_t at = text.find('>', text.find("<trace xml:id"));
  std::string moved = text;
  moved.insert(at + 1, "500 500 1, ");
  const Imported back = import_inkml(moved).value();
  ASSERT_EQ(back.report.notices().size(), 1u);
  EXPECT_THAT(notice_text(back.report.notices()[0]), HasSubstr("was changed by another program"));
  EXPECT_NEAR(testing::strokes_in(back.drawing.document, 0)[0].position(0.0).x, 500.0, 0.1);
  EXPECT_EQ(back.drawing.document.layers()[0].name, "ink");
}

TEST(InkmlWriter, TonesAreWrittenWhereTheyAreNotThoseOfTheWidths) {
  StrokeData data = testing::straight_stroke({0, 0}, {10, 0}, 1, 2).data();
  EXPECT_EQ(inkml_text(ink_of(Stroke::create(data).value())).value().find("felt:tones"),
            std::string::npos);
  data.widths[1].tone = 0.125;
  const Drawing drawing = ink_of(Stroke::create(data).value());
  const std::string text = inkml_text(drawing).value();
  EXPECT_EQ(import_inkml(text).value().drawing, drawing);
  const std::size_t at = text.find("felt:tones=\"") + 12, end = text.find('"', at);
  EXPECT_THAT(text.substr(at, end - at), ::testing::EndsWith(" 0.125"));
  for (const char* tones : {"0.5", "0.5 0.5 0.5", "0 1.5", "0 -0.5", "0 nan", "0 x"}) {
    SCOPED_TRACE(tones);
    const Imported back = import_inkml(text.substr(0, at) + tones + text.substr(end)).value();
    ASSERT_EQ(back.report.notices().size(), 1u);
    EXPECT_THAT(notice_text(back.report.notices()[0]), HasSubstr("invalid tones"));
    EXPECT_EQ(back.drawing.document.layers()[0].strokes.size(), 1u);
  }
}

TEST(InkmlWriter, OtherSpacingOfTheSameTraceChangesNothing) {
  const Drawing drawing = one_stroke();
  const std::string text = replaced(inkml_text(drawing).value(), ", ", " ,\n   ");
  EXPECT_EQ(import_inkml(text).value().drawing, drawing);
}

TEST(InkmlWriter, AnotherScaleIsAChange) {
  const std::string text =
      replaced(inkml_text(one_stroke()).value(), "units=\"mm\"", "units=\"cm\"");
  EXPECT_FALSE(import_inkml(text).value().report.empty());
}

TEST(InkmlWriter, AnotherColourIsTaken) {
  const Drawing drawing = one_stroke();
  const std::string text = inkml_text(drawing).value();
  const std::size_t at = text.find("value=\"#") + 7;
  const Imported back = import_inkml(text.substr(0, at) + "#010203" + text.substr(at + 7)).value();
  const Stroke was = testing::strokes_in(drawing.document)[0];
  EXPECT_EQ(testing::strokes_in(back.drawing.document, 0)[0].color(),
            (Rgba{1, 2, 3, was.color().a}));
  EXPECT_EQ(testing::strokes_in(back.drawing.document, 0)[0].widths().size(), was.widths().size());
}

TEST(InkmlWriter, WhatXmlCannotHoldIsAnErrorThatNamesIt) {
  const Stroke fine = testing::straight_stroke({0, 0}, {9, 0}, 1, 1);
  StrokeData data = fine.data();
  const auto of_medium = [&data](std::string medium) {
    data.medium = std::move(medium);
    return ink_of(Stroke::create(data).value());
  };
  EXPECT_THAT(inkml_text(of_medium("a\x01")).error().message,
              HasSubstr("stroke 1: XML cannot contain"));
  EXPECT_THAT(inkml_text(ink_of(fine, "\x01")).error().message, HasSubstr("a layer's name: "));
  const Drawing longest = of_medium(std::string(4096, 'x'));
  EXPECT_EQ(import_inkml(inkml_text(longest).value()).value().drawing, longest);
  EXPECT_THAT(inkml_text(of_medium(std::string(4097, 'x'))).error().message,
              HasSubstr("more than 4096 bytes"));
  const Drawing far = ink_of(testing::straight_stroke({0, 0}, {1e9, 0}, 1, 1));
  EXPECT_EQ(import_inkml(inkml_text(far).value()).value().drawing, far);
  EXPECT_THAT(
      inkml_text(ink_of(testing::straight_stroke({0, 0}, {1.1e9, 0}, 1, 1))).error().message,
      HasSubstr("beyond 1e9 mm"));
}

}  // namespace
}  // namespace felt::inkml_writer_test
