// Translucent layers and pictures in every format.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/document/testing/small_picture.h"
#include "felt/formats/drawing_reader.h"
#include "felt/formats/drawing_writer.h"
#include "felt/formats/format_traits.h"
#include "felt/formats/lost_objects.h"
#include "felt/io/drawing_builder.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::layer_looks_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Drawing faded_drawing() {
  DrawingBuilder builder;
  LayerState state{"Ink"};
  state.opacity = 0.5;
  state.picture = testing::red_blue_picture(10.0, 10.0);
  const std::size_t layer = builder.add_layer(std::move(state));
  StrokeData data = testing::random_stroke(1).data();
  data.color = {20, 40, 60, 200};
  builder.add(layer, Stroke::create(std::move(data)).value(), "s1");
  return std::move(builder).build();
}

std::string bytes_in(FileFormat format, PictureChoice pictures = PictureChoice::kMarked) {
  return drawing_bytes(faded_drawing(), format, {.dpi = 72.0, .pictures = pictures}).value();
}

Drawing read_back(FileFormat format) {
  return parse_drawing(bytes_in(format), "file").value().drawing;
}

TEST(LayerLooks, SvgKeepsTheOpacityOfALayer) {
  EXPECT_THAT(bytes_in(FileFormat::kSvg), HasSubstr("opacity:0.5"));
  const Drawing back = read_back(FileFormat::kSvg);
  EXPECT_EQ(back.document.layers()[0].opacity, 0.5);
  const StrokePtr stroke = back.document.find(back.document.layers()[0].strokes[0]);
  EXPECT_EQ(stroke->color(), (Rgba{20, 40, 60, 200}));
}

TEST(LayerLooks, InkmlKeepsTheOpacityOfALayer) {
  EXPECT_EQ(read_back(FileFormat::kInkml).document.layers()[0].opacity, 0.5);
}

TEST(LayerLooks, OtherFormatsFadeTheStrokes) {
  const Drawing back = read_back(FileFormat::kXopp);
  const StrokePtr stroke = back.document.find(back.document.layers()[0].strokes[0]);
  EXPECT_EQ(stroke->color().a, 100);
}

TEST(LayerLooks, PdfAndCompactSvgFadeTheLayerAsAWhole) {
  const std::string pdf = bytes_in(FileFormat::kPdf);
  EXPECT_THAT(pdf, HasSubstr("/A200 <<"));
  EXPECT_THAT(pdf, HasSubstr("/L1 << /ca 0.5 /BM /Normal >>"));
  EXPECT_THAT(pdf, HasSubstr("/Subtype /Form"));
  const std::string svg =
      drawing_bytes(faded_drawing(), FileFormat::kSvg, {.compact = true}).value();
  EXPECT_THAT(svg, HasSubstr("<g opacity=\"0.5\">\n<path"));
}

/// Returns a drawing of three layers: the upper two are in a group. All multiply.
Drawing grouped_drawing() {
  DrawingBuilder builder;
  for (std::uint64_t i = 1; i <= 3; ++i) {
    LayerState state{"Layer " + std::to_string(i)};
    state.blend = BlendMode::kMultiply;
    if (i > 1) {
      state.group = std::make_shared<const LayerGroup>(
          LayerGroup{{5}, "A & B", true, true, 0.25, BlendMode::kMultiply});
    }
    builder.add(builder.add_layer(std::move(state)), testing::random_stroke(i), "");
  }
  return std::move(builder).build();
}

TEST(LayerLooks, SvgAndInkmlKeepBlendModesAndGroups) {
  const Drawing drawing = grouped_drawing();
  for (const FileFormat format : {FileFormat::kSvg, FileFormat::kInkml, FileFormat::kFelt}) {
    const std::string bytes = drawing_bytes(drawing, format).value();
    const Drawing back = parse_drawing(bytes, "file").value().drawing;
    EXPECT_TRUE(back.document == drawing.document);
    EXPECT_EQ(lost_objects(drawing, format), LostObjects());
  }
  EXPECT_THAT(drawing_bytes(drawing, FileFormat::kSvg).value(),
              HasSubstr("inkscape:label=\"A &amp; B\" sodipodi:insensitive=\"true\" "
                        "style=\"display:inline;opacity:0.25;mix-blend-mode:multiply\">"));
}

TEST(LayerLooks, PicturesOfBlendModesAndGroups) {
  const Drawing drawing = grouped_drawing();
  const std::string pdf = drawing_bytes(drawing, FileFormat::kPdf).value();
  EXPECT_THAT(pdf, HasSubstr("/L1 << /ca 1 /BM /Multiply >>"));
  EXPECT_THAT(pdf, HasSubstr("/L4 << /ca 0.25 /BM /Multiply >>")) << "the group of two layers";
  EXPECT_THAT(pdf, Not(HasSubstr("/L5 <<")));
  const std::string svg = drawing_bytes(drawing, FileFormat::kSvg, {.compact = true}).value();
  EXPECT_THAT(svg, HasSubstr("<g opacity=\"0.25\" style=\"mix-blend-mode:multiply\">\n"
                             "<g style=\"mix-blend-mode:multiply\">\n<path"));
  for (const FileFormat format : {FileFormat::kPdf, FileFormat::kPng}) {
    EXPECT_EQ(lost_objects(drawing, format), LostObjects());
  }
  EXPECT_EQ(lost_objects(drawing, FileFormat::kSvg, true), LostObjects());
}

TEST(LayerLooks, XoppAndNdjsonLoseBlendModesAndGroups) {
  const Drawing drawing = grouped_drawing();
  EXPECT_EQ(lost_objects(drawing, FileFormat::kXopp),
            (LostObjects{.blends = 4, .groups = 1, .opacities = 1, .locks = 2, .media = 3}));
  EXPECT_EQ(lost_objects(drawing, FileFormat::kNdjson),
            (LostObjects{.blends = 4, .opacities = 1, .layers = 3}));
  const Drawing back =
      parse_drawing(drawing_bytes(drawing, FileFormat::kXopp).value(), "file").value().drawing;
  ASSERT_EQ(back.document.layers().size(), 3U);
  EXPECT_FALSE(back.document.layers()[2].group);
  const auto alpha = [](const Document& document, std::size_t layer) {
    return int{document.find(document.layers()[layer].strokes[0])->color().a};
  };
  EXPECT_NEAR(alpha(back.document, 2), 0.25 * alpha(drawing.document, 2), 0.6)
      << "the opacity of the group goes to the strokes";
}

TEST(LayerLooks, OnlyFeltKeepsTimingsAndBodyEdits) {
  DrawingBuilder builder;
  LayerState state{"Key"};
  state.timing = shared_timing({.between = 3});
  builder.add(builder.add_layer(std::move(state)), testing::random_stroke(1), "");
  Drawing drawing = std::move(builder).build();
  Edit edit{"Cut", {}};
  edit.body_edits.push_back(
      {drawing.document.new_body_edit_id(), nullptr,
       std::make_shared<const BodyEdit>(BodyEdit{.path_mm = {{1, -2, 0}, {3, -4, 0}}})});
  ASSERT_TRUE(drawing.document.apply(edit));
  for (const FormatTraits& traits : format_table()) {
    if (!traits.writes) continue;
    LostObjects lost;
    const Result<Imported> back =
        parse_drawing(drawing_bytes(drawing, traits.format).value(), "file");
    if (back && traits.reads) {
      const Document& read = back->drawing.document;
      lost.timings = read.layers()[0].timing ? 0 : 1;
      lost.body_edits = 1 - read.body_edits().size();
    }
    const LostObjects counted = lost_objects(drawing, traits.format);
    EXPECT_EQ(counted.timings, lost.timings) << traits.name;
    EXPECT_EQ(counted.body_edits, lost.body_edits) << traits.name;
  }
  EXPECT_EQ(lost_objects(drawing, FileFormat::kSvg, true), LostObjects()) << "a picture";
}

TEST(LayerLooks, PicturesAreLeftOutUnlessAskedFor) {
  EXPECT_THAT(bytes_in(FileFormat::kSvg), Not(HasSubstr("<image")));
  const std::string svg = bytes_in(FileFormat::kSvg, PictureChoice::kAll);
  EXPECT_THAT(svg, HasSubstr("transform=\"matrix(10 0 0 10 10 10)\" width=\"2\" height=\"1\""));
  EXPECT_THAT(svg, HasSubstr(std::string(testing::kRedBluePng)));
  EXPECT_NE(bytes_in(FileFormat::kPng), bytes_in(FileFormat::kPng, PictureChoice::kAll));
  EXPECT_EQ(read_back(FileFormat::kFelt).document.layers()[0].picture->data->png,
            testing::picture_data()->png);
}

TEST(LayerLooks, APdfHasThePicturesThatWereAskedFor) {
  const std::string without = bytes_in(FileFormat::kPdf);
  const std::string with = bytes_in(FileFormat::kPdf, PictureChoice::kAll);
  EXPECT_EQ(without.find("/Subtype /Image"), std::string::npos);
  EXPECT_NE(with.find("/Subtype /Image /Width 2 /Height 1 /ColorSpace /DeviceRGB"),
            std::string::npos);
  EXPECT_NE(with.find("/SMask 7 0 R"), std::string::npos);
}

TEST(LayerLooks, LostObjectsAreThoseThatAreNotReadBack) {
  DrawingBuilder builder;
  for (const bool visible : {true, false}) {
    LayerState state{"Area", visible};
    state.picture = testing::red_blue_picture(10.0, 10.0);
    const std::size_t layer = builder.add_layer(std::move(state));
    builder.add(layer, testing::random_stroke(2), "");
    Fill fill;
    fill.loops.push_back({{{0, 0}, {9, 0}, {9, 9}, {0, 0}}, {}});
    builder.add_fill(layer, std::make_shared<const Fill>(fill));
    builder.add_fill(layer, std::make_shared<const Fill>(fill));
  }
  const Drawing drawing = std::move(builder).build();
  const auto lost = [&](FileFormat format, bool compact = false) {
    return lost_objects(drawing, format, compact);
  };
  EXPECT_EQ(lost(FileFormat::kFelt), LostObjects());
  EXPECT_EQ(lost(FileFormat::kSvg), LostObjects());
  EXPECT_EQ(lost(FileFormat::kPng), LostObjects());
  EXPECT_EQ(lost(FileFormat::kPdf), LostObjects());
  EXPECT_EQ(lost(FileFormat::kSvg, true), (LostObjects{.pictures = 2}));
  EXPECT_EQ(lost(FileFormat::kNdjson),
            (LostObjects{.fills = 2, .pictures = 1, .layers = 1, .hidden_strokes = 1}))
      << "hidden layers are left out anyway";
  for (const FileFormat format : {FileFormat::kInkml, FileFormat::kXopp}) {
    EXPECT_EQ(lost(format),
              (format == FileFormat::kXopp
                   ? LostObjects{.fills = 4, .pictures = 2, .shown_strokes = 1, .media = 2}
                   : LostObjects{.fills = 4, .pictures = 2}));
    const Drawing back =
        parse_drawing(drawing_bytes(drawing, format).value(), "file").value().drawing;
    EXPECT_EQ(back.document.fill_count(), 0U);
  }
  const std::string svg = drawing_bytes(drawing, FileFormat::kSvg).value();
  EXPECT_EQ(parse_drawing(svg, "file").value().drawing.document.fill_count(), 4U);
}

}  // namespace
}  // namespace felt::layer_looks_test
