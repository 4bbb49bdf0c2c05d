#include "felt/io/svg_import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "felt/io/svg_length.h"
#include "felt/io/svg_writer.h"
#include "felt/io/unpack.h"
#include "felt/stroke/random_stroke.h"
#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

using ::testing::HasSubstr;

Sketch random_sketch(std::uint64_t seed, int count) {
  Sketch sketch;
  for (int i = 0; i < count; ++i) {
    StrokeData data =
        felt::testing::random_stroke(1000 * seed + static_cast<std::uint64_t>(i)).data();
    if (i % 3 == 1) data.material = "Kohle \"weich\" <&>\n";
    sketch.push_back({"s" + std::to_string(i), Stroke::create(std::move(data)).value()});
  }
  return sketch;
}

LayeredSketch random_drawing(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  LayeredSketch drawing;
  const std::uint64_t count = random() % 5;
  for (std::uint64_t i = 0; i < count; ++i) {
    SketchLayer layer;
    if (random() % 4 > 0) layer.name = "Ebene \"" + std::to_string(random() % 3) + "\" <&\t>";
    layer.visible = random() % 2 == 0;
    layer.locked = random() % 2 == 0;
    layer.strokes = random_sketch(100 * seed + i, static_cast<int>(random() % 5));
    drawing.layers.push_back(std::move(layer));
  }
  if (random() % 2 == 0) {
    const auto byte = [&] { return static_cast<std::uint8_t>(random() % 256); };
    drawing.page = SheetPage{10.0 + static_cast<double>(random() % 100000) / 37.0,
                             10.0 + static_cast<double>(random() % 100000) / 37.0,
                             {byte(), byte(), byte(), byte()}};
  }
  if (random() % 2 == 0) {
    (drawing.page ? drawing.page->surface : drawing.surface) = "B\xC3\xBCtten \"<&>\"";
  }
  for (std::uint64_t i = 3 * (random() % 2); i > 0; --i) {
    drawing.materials.push_back("id = \"m" + std::to_string(i) + "\"\n# <&>\t\r\n");
  }
  return drawing;
}

ImportedDrawing imported(std::string_view svg) {
  Result<ImportedDrawing> result = import_svg(svg);
  EXPECT_TRUE(result) << result.error().message;
  return result ? *std::move(result) : ImportedDrawing();
}

/// All notices, one a line.
std::string notices(const ImportedDrawing& drawing) {
  std::string text;
  for (const ImportNotice& n : drawing.report.notices()) text += notice_text(n) + "\n";
  return text;
}

std::string changed(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

TEST(SvgImport, DrawingsComeBackEqual) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const LayeredSketch drawing = random_drawing(seed);
    const std::string text = svg_text(drawing, {}).value();
    const ImportedDrawing back = imported(text);
    ASSERT_EQ(back.drawing, drawing) << "seed " << seed;
    EXPECT_TRUE(back.report.empty()) << "seed " << seed << ": " << notices(back);
    EXPECT_EQ(svg_text(back.drawing, {}).value(), text) << "seed " << seed;
  }
}

TEST(SvgImport, PlainSketchesComeBackEqual) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Sketch sketch = random_sketch(seed, 1 + static_cast<int>(seed % 7));
    SvgOptions options;
    if (seed % 2 == 0) options.sheet = Rect{0.0, 0.0, 297.0, 210.0};
    if (seed % 3 == 0) options.paper = {250, 240, 1, static_cast<std::uint8_t>(1 + seed)};
    const ImportedDrawing back = imported(svg_text(sketch, options).value());
    ASSERT_EQ(back.drawing.layers.size(), 1U);
    EXPECT_EQ(back.drawing.layers[0].strokes, sketch) << "seed " << seed;
    EXPECT_EQ(back.drawing.layers[0].name, "Ink");
    EXPECT_TRUE(back.report.empty()) << notices(back);
    if (!options.sheet) continue;
    ASSERT_TRUE(back.drawing.page);
    EXPECT_EQ(back.drawing.page->area(), *options.sheet);
    const Rgba paper = options.paper.a > 0 ? options.paper : Rgba{0, 0, 0, 0};
    EXPECT_EQ(back.drawing.page->paper, paper) << "seed " << seed;
  }
}

TEST(SvgImport, EveryAlphaReadsBack) {
  for (int alpha = 0; alpha < 256; ++alpha) {
    StrokeData data = felt::testing::random_stroke(1).data();
    data.color = {1, 2, 3, static_cast<std::uint8_t>(alpha)};
    const Sketch sketch{{"a", Stroke::create(std::move(data)).value()}};
    const ImportedDrawing back = imported(svg_text(sketch, {}).value());
    ASSERT_EQ(back.drawing.layers.size(), 1U) << alpha;
    EXPECT_EQ(back.drawing.layers[0].strokes, sketch) << alpha;
  }
}

TEST(SvgImport, PackedFilesAreUnpacked) {
  const LayeredSketch drawing = random_drawing(3);
  EXPECT_EQ(imported(gzip(svg_text(drawing, {}).value())).drawing, drawing);
  const auto cut = import_svg(gzip(svg_text(drawing, {}).value()).substr(0, 100));
  EXPECT_FALSE(cut);
}

TEST(SvgImport, SaysWhatIsNoSvg) {
  const auto message = [](const std::string& svg) {
    const Result<ImportedDrawing> drawing = import_svg(svg);
    return drawing ? std::string("it was read") : drawing.error().message;
  };
  EXPECT_THAT(message(""), HasSubstr("no XML"));
  EXPECT_THAT(message("<html/>"), HasSubstr("no SVG: its first element is 'html'"));
  EXPECT_THAT(message("<svg>\n<g>\n</svg>"), HasSubstr("line 3"));
  const std::string ours = svg_text(random_sketch(1, 2), {}).value();
  EXPECT_THAT(message(changed(ours, "felt:version=\"1\"", "felt:version=\"2\"")),
              HasSubstr("newer Feltline"));
}

TEST(SvgImport, TonesComeBackAndDamagedOnesAreToldOf) {
  StrokeData data = testing::straight_stroke({0, 0}, {10, 0}, 1, 2).data();
  const auto text_of = [&] {
    return svg_text(Sketch{{"s", Stroke::create(data).value()}}, {}).value();
  };
  const auto widths_in = [](const std::string& text) {
    return imported(text).drawing.layers[0].strokes[0].stroke.data().widths;
  };
  EXPECT_EQ(text_of().find("felt:tones"), std::string::npos);
  EXPECT_EQ(widths_in(text_of()), data.widths);
  data.widths[0].tone = 0.75;
  data.widths[1].tone = 0.125;
  const std::string text = text_of();
  EXPECT_EQ(widths_in(text), data.widths);
  EXPECT_EQ(widths_in(changed(text, "felt:tones=\"0.75 0.125\"", ""))[0].tone, tone_of_width(1));
  for (const char* tones : {"0.5", "0.5 0.5 0.5", "0 1.5", "0 -0.5", "0 nan", "x"}) {
    SCOPED_TRACE(tones);
    const ImportedDrawing back = imported(
        changed(text, "felt:tones=\"0.75 0.125\"", "felt:tones=\"" + std::string(tones) + "\""));
    EXPECT_THAT(notices(back), HasSubstr("tones that are not one number of 0 to 1"));
    EXPECT_EQ(back.drawing.layers[0].strokes[0].stroke.data().widths[1],
              (WidthKnot{1.0, 2.0, tone_of_width(2.0)}));
  }
}

/// Where Inkscape changed the widths, tones are those of the place.
TEST(SvgImport, TonesAreInterpolatedWhereWidthsWereChanged) {
  StrokeData data = testing::straight_stroke({0, 0}, {10, 0}, 1, 2).data();
  data.widths[0].tone = 0.0;
  data.widths[1].tone = 1.0;
  std::string text = svg_text(Sketch{{"s", Stroke::create(data).value()}}, {}).value();
  text = changed(text, "offset_points=\"0,0.5 | 1,1\"", "offset_points=\"0,0.5 | 0.25,2 | 1,1\"");
  const auto widths = imported(text).drawing.layers[0].strokes[0].stroke.data().widths;
  EXPECT_EQ(widths, (std::vector<WidthKnot>{{0, 1, 0.0}, {0.25, 4, 0.25}, {1, 2, 1.0}}));
}

/// Ours with a transform that another program put on it.
TEST(SvgImport, OursIsMovedExactly) {
  const Sketch sketch = random_sketch(5, 4);
  const std::string text = svg_text(sketch, {}).value();
  const ImportedDrawing same =
      imported(changed(text, "<path id=", "<path transform=\"translate(0)\" id="));
  EXPECT_EQ(same.drawing.layers[0].strokes, sketch);
  for (const char* transform :
       {"translate(10,20)", "rotate(90)", "scale(2)", "matrix(0.6 0.8 -0.8 0.6 3 4)", "scale(-2 2)",
        "rotate(33 10 20) scale(1.7)"}) {
    SCOPED_TRACE(transform);
    std::string moved =
        changed(text, ">\n<defs>", ">\n<g transform=\"" + std::string(transform) + "\"><defs>");
    moved = changed(moved, "</svg>", "</g></svg>");
    const ImportedDrawing back = imported(moved);
    ASSERT_EQ(back.drawing.layers.size(), 1U);
    ASSERT_EQ(back.drawing.layers[0].strokes.size(), sketch.size());
    EXPECT_TRUE(back.report.empty()) << notices(back);
    const Affine m = svg_transform(transform).value();
    const double scale = std::sqrt(std::fabs(determinant(m)));
    for (std::size_t i = 0; i < sketch.size(); ++i) {
      const StrokeData& was = sketch[i].stroke.data();
      const StrokeData& is = back.drawing.layers[0].strokes[i].stroke.data();
      ASSERT_EQ(is.points.size(), was.points.size());
      EXPECT_EQ(is.joints, was.joints);
      EXPECT_EQ(is.material, was.material);
      for (std::size_t k = 0; k < was.points.size(); ++k) {
        EXPECT_LT(distance(is.points[k], apply(m, was.points[k])), 1e-12) << k;
      }
      for (std::size_t k = 0; k < was.widths.size(); ++k) {
        EXPECT_EQ(is.widths[k].u, was.widths[k].u);
        EXPECT_NEAR(is.widths[k].width_mm, scale * was.widths[k].width_mm, 1e-12);
        if (has_own_tone(was.widths)) {
          EXPECT_EQ(is.widths[k].tone, was.widths[k].tone);
        } else {
          EXPECT_EQ(is.widths[k].tone, tone_of_width(is.widths[k].width_mm));
        }
      }
    }
  }
}

}  // namespace
}  // namespace felt
