#include "felt/io/svg/svg_import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "felt/io/svg/svg_length.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/io/testing/import_checks.h"
#include "felt/io/testing/test_drawings.h"
#include "felt/io/unpack.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/stroke/width_profile.h"

namespace felt::svg_import_test {
namespace {

using ::testing::HasSubstr;
using testing::notice_lines;

std::vector<Stroke> strokes_of_media(std::uint64_t seed, int count) {
  std::vector<Stroke> strokes;
  for (int i = 0; i < count; ++i) {
    StrokeData data =
        felt::testing::random_stroke(1000 * seed + static_cast<std::uint64_t>(i)).data();
    if (i % 3 == 1) data.medium = "Kohle \"weich\" <&>\n";
    strokes.push_back(Stroke::create(std::move(data)).value());
  }
  return strokes;
}

Drawing drawing_in_layers(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  DrawingBuilder builder;
  Drawing& drawing = builder.drawing();
  const std::uint64_t count = random() % 5;
  for (std::uint64_t i = 0; i < count; ++i) {
    LayerState state;
    if (random() % 4 > 0) state.name = "Ebene \"" + std::to_string(random() % 3) + "\" <&\t>";
    state.visible = random() % 2 == 0;
    state.locked = random() % 2 == 0;
    const std::size_t layer = builder.add_layer(std::move(state));
    for (Stroke& stroke : strokes_of_media(100 * seed + i, static_cast<int>(random() % 5))) {
      builder.add(layer, std::move(stroke));
    }
  }
  if (random() % 2 == 0) {
    const auto byte = [&] { return static_cast<std::uint8_t>(random() % 256); };
    drawing.has_page = true;
    drawing.page = Page{10.0 + static_cast<double>(random() % 100000) / 37.0,
                        10.0 + static_cast<double>(random() % 100000) / 37.0,
                        {byte(), byte(), byte(), byte()}};
  }
  if (random() % 2 == 0) drawing.page.surface = "B\xC3\xBCtten \"<&>\"";
  for (std::uint64_t i = 3 * (random() % 2); i > 0; --i) {
    drawing.materials.push_back("id = \"m" + std::to_string(i) + "\"\n# <&>\t\r\n");
  }
  return std::move(builder).build();
}

/// Returns the SVG of a stream of these strokes.
std::string svg_of_strokes(const std::vector<Stroke>& strokes, const SvgOptions& options = {}) {
  return svg_ink_text(testing::drawing_of(strokes), options).value();
}

Imported imported(std::string_view svg) {
  Result<Imported> result = import_svg(svg);
  EXPECT_TRUE(result) << result.error().message;
  return result ? *std::move(result) : Imported();
}

std::string changed(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

/// Returns the value of the first attribute with that name.
std::string attribute_in(const std::string& text, const std::string& name) {
  const std::size_t begin = text.find(" " + name + "=\"") + name.size() + 3;
  return text.substr(begin, text.find('"', begin) - begin);
}

TEST(SvgImport, DrawingsComeBackEqual) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Drawing drawing = drawing_in_layers(seed);
    const std::string text = svg_text(drawing, {}).value();
    const Imported back = imported(text);
    ASSERT_EQ(back.drawing, drawing) << "seed " << seed;
    EXPECT_TRUE(back.report.empty()) << "seed " << seed << ": " << notice_lines(back);
    EXPECT_EQ(svg_text(back.drawing, {}).value(), text) << "seed " << seed;
  }
}

TEST(SvgImport, AsManyLayersComeBackAsADrawingMayHave) {
  DrawingBuilder builder;
  for (int i = 0; i < 10'000; ++i) builder.add_layer({"", i % 2 == 0, i % 3 == 0});
  builder.add(9'999, strokes_of_media(1, 1)[0]);
  const Drawing drawing = std::move(builder).build();
  const Imported back = imported(svg_text(drawing, {}).value());
  EXPECT_TRUE(back.report.empty()) << notice_lines(back);
  EXPECT_TRUE(back.drawing == drawing);
}

TEST(SvgImport, PlainSketchesComeBackEqual) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const std::vector<Stroke> strokes = strokes_of_media(seed, 1 + static_cast<int>(seed % 7));
    SvgOptions options;
    if (seed % 2 == 0) options.area = Rect{0.0, 0.0, 297.0, 210.0};
    if (seed % 3 == 0) options.paper = Rgba{250, 240, 1, static_cast<std::uint8_t>(1 + seed)};
    const Imported back = imported(svg_of_strokes(strokes, options));
    ASSERT_EQ(back.drawing.document.layers().size(), 1U);
    EXPECT_EQ(testing::strokes_in(back.drawing.document), strokes) << "seed " << seed;
    EXPECT_EQ(back.drawing.document.layers()[0].name, "Ink");
    EXPECT_TRUE(back.report.empty()) << notice_lines(back);
    if (!options.area) continue;
    ASSERT_TRUE(back.drawing.has_page);
    EXPECT_EQ(back.drawing.page.area(), *options.area);
    const Rgba paper = options.paper.value_or(Rgba{0, 0, 0, 0});
    EXPECT_EQ(back.drawing.page.paper, paper) << "seed " << seed;
  }
}

TEST(SvgImport, EveryAlphaReadsBack) {
  for (int alpha = 0; alpha < 256; ++alpha) {
    StrokeData data = felt::testing::random_stroke(1).data();
    data.color = {1, 2, 3, static_cast<std::uint8_t>(alpha)};
    const std::vector<Stroke> strokes{Stroke::create(std::move(data)).value()};
    const Imported back = imported(svg_of_strokes(strokes));
    ASSERT_EQ(back.drawing.document.layers().size(), 1U) << alpha;
    EXPECT_EQ(testing::strokes_in(back.drawing.document), strokes) << alpha;
  }
}

TEST(SvgImport, PackedFilesAreUnpacked) {
  const Drawing drawing = drawing_in_layers(3);
  EXPECT_EQ(imported(gzip(svg_text(drawing, {}).value())).drawing, drawing);
  const auto cut = import_svg(gzip(svg_text(drawing, {}).value()).substr(0, 100));
  EXPECT_FALSE(cut);
}

TEST(SvgImport, SaysWhatIsNoSvg) {
  const auto message = [](const std::string& svg) {
    const Result<Imported> drawing = import_svg(svg);
    return drawing ? std::string("it was read") : drawing.error().message;
  };
  EXPECT_THAT(message(""), HasSubstr("is not XML"));
  EXPECT_THAT(message("<html/>"), HasSubstr("is not an SVG: its first element is 'html'"));
  EXPECT_THAT(message("<svg>\n<g>\n</svg>"), HasSubstr("line 3"));
  const std::string ours = svg_of_strokes(strokes_of_media(1, 2));
  EXPECT_THAT(message(changed(ours, "felt:version=\"2\"", "felt:version=\"3\"")),
              HasSubstr("newer Feltline"));
}

TEST(SvgImport, TonesComeBackAndDamagedOnesAreToldOf) {
  StrokeData data = testing::straight_stroke({0, 0}, {10, 0}, 1, 2).data();
  const auto written = [&] { return svg_of_strokes({Stroke::create(data).value()}); };
  const auto widths_in = [](const std::string& text) {
    return testing::strokes_in(imported(text).drawing.document)[0].data().widths;
  };
  EXPECT_EQ(written().find("felt:tones"), std::string::npos);
  EXPECT_EQ(widths_in(written()), data.widths);
  data.widths[0].tone = 0.75;
  data.widths[1].tone = 0.125;
  const std::string text = written();
  EXPECT_EQ(widths_in(text), data.widths);
  const std::string tones_attribute = "felt:tones=\"" + attribute_in(text, "felt:tones") + "\"";
  EXPECT_EQ(widths_in(changed(text, tones_attribute, ""))[0].tone, tone_of_width(1));
  // The tones are too few, too many, above 1, not digits, or missing.
  for (const char* tones : {"BA", "BAAA", "JAAAAAAAAAAAAAAAAQQ", "B!!", "x", "A"}) {
    SCOPED_TRACE(tones);
    const Imported back =
        imported(changed(text, tones_attribute, "felt:tones=\"" + std::string(tones) + "\""));
    EXPECT_THAT(notice_lines(back), HasSubstr("invalid tones"));
    EXPECT_EQ(testing::strokes_in(back.drawing.document, 0)[0].data().widths[1],
              (WidthKnot{1.0, 2.0, tone_of_width(2.0)}));
  }
}

/// If Inkscape changed the widths, tones are interpolated at the new positions.
TEST(SvgImport, TonesAreInterpolatedWhereWidthsWereChanged) {
  StrokeData data = testing::straight_stroke({0, 0}, {10, 0}, 1, 2).data();
  data.widths[0].tone = 0.0;
  data.widths[1].tone = 1.0;
  std::string text = svg_of_strokes({Stroke::create(data).value()});
  text = changed(text, "offset_points=\"0,.5 | 1,1\"", "offset_points=\"0,.5 | 0.25,2 | 1,1\"");
  const auto widths = testing::strokes_in(imported(text).drawing.document)[0].data().widths;
  EXPECT_EQ(widths, (std::vector<WidthKnot>{{0, 1, 0.0}, {0.25, 4, 0.25}, {1, 2, 1.0}}));
}

/// Tests our file with a transform that another program added.
TEST(SvgImport, OursIsMovedExactly) {
  const std::vector<Stroke> strokes = strokes_of_media(5, 4);
  const std::string text = svg_of_strokes(strokes);
  const Imported same =
      imported(changed(text, "<path id=", "<path transform=\"translate(0)\" id="));
  EXPECT_EQ(testing::strokes_in(same.drawing.document), strokes);
  for (const char* transform :
       {"translate(10,20)", "rotate(90)", "scale(2)", "matrix(0.6 0.8 -0.8 0.6 3 4)", "scale(-2 2)",
        "rotate(33 10 20) scale(1.7)"}) {
    SCOPED_TRACE(transform);
    std::string moved = changed(text, "<g>", "<g transform=\"" + std::string(transform) + "\"><g>");
    moved = changed(moved, "</svg>", "</g></svg>");
    const Imported back = imported(moved);
    ASSERT_EQ(back.drawing.document.layers().size(), 1U);
    const std::vector<Stroke> read = testing::strokes_in(back.drawing.document);
    ASSERT_EQ(read.size(), strokes.size());
    EXPECT_TRUE(back.report.empty()) << notice_lines(back);
    const Affine m = svg_transform(transform).value();
    const double scale = std::sqrt(std::fabs(determinant(m)));
    for (std::size_t i = 0; i < strokes.size(); ++i) {
      const StrokeData& was = strokes[i].data();
      const StrokeData& is = read[i].data();
      ASSERT_EQ(is.points.size(), was.points.size());
      EXPECT_EQ(is.joints, was.joints);
      EXPECT_EQ(is.medium, was.medium);
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

/// If another program moved one joint, everything else is unchanged, to the last bit.
TEST(SvgImport, WhatAnotherProgramMovedIsTakenAndTheRestStays) {
  StrokeData data = felt::testing::straight_stroke({0, 0}, {1.0 / 3.0, 2.0 / 7.0}, 1, 2).data();
  data.points.insert(data.points.end(), {{2, 1}, {3, 1}, {4.0 / 3.0, 1}});
  data.joints = {JointKind::kCorner};
  data.widths.back().u = 2.0;
  const std::string text = svg_of_strokes({Stroke::create(data).value()});
  const std::string line = attribute_in(text, "inkscape:original-d");
  ASSERT_EQ(line, "M0 0c.111.095.222.19.333.286 1.667.714 2.667.714 1 .714");
  const Imported back =
      imported(changed(text, line, "M0 0c.111.095.222.19.333.286 1.667.714 2.667.714 1.5.814"));
  ASSERT_EQ(back.drawing.document.layers().size(), 1U);
  StrokeData moved = data;
  moved.points.back() = {1.833, 1.1};
  const StrokeData is = testing::strokes_in(back.drawing.document)[0].data();
  EXPECT_LT(distance(is.points.back(), moved.points.back()), 0.0006);
  moved.points.back() = is.points.back();
  EXPECT_EQ(is, moved);
}

/// A file that Feltline wrote before version 2.
constexpr const char* kVersion1 = R"svg(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" xmlns:felt="https://feltline.org/ns/1" version="1.1" felt:version="1" width="31.73mm" height="18.56mm" viewBox="-4.5 -3.4 31.73 18.56">
<defs><inkscape:path-effect id="width1" effect="powerstroke" is_visible="true" lpeversion="1.3" scale_width="1" interpolator_type="Linear" interpolator_beta="0.2" start_linecap_type="round" end_linecap_type="round" linejoin_type="round" miter_limit="4" sort_points="true" not_jump="false" offset_points="0,0.25 | 0.3333333333333333,0.6 | 2,0.3535533905932738"/></defs>
<path id="stroke1" d="M1.0568 2.4462c.656 .1152 1.3529 .2307 2.0714 .3462 .0359 .0058 .0722 .0083 .1086 .0075 1.4691-.0329 3.0246-.0657 4.5242-.0986 .0024-.0001 .0049-.0001 .0073-.0002 .1586-.0058 .4933 .105 .9169 .3925 .4104 .2787 .871 .6883 1.3114 1.1511 .8815 .9264 1.6831 2.0714 1.9761 2.7889 .0723 .1771 .2723 .2646 .4514 .1974 .1792-.0671 .2724-.2646 .2104-.4455-.3046-.8896-1.1042-2.0951-2.0078-3.1184-.4522-.5122-.9306-.9771-1.4026-1.3298-.4602-.3438-.9463-.6198-1.4558-.6384-.0024-.0001-.0049-.0001-.0073-.0002-1.4996-.0329-3.0551-.0657-4.5242-.0986-.0364-.0008-.0727 .0017-.1086 .0075-.7185 .1155-1.4154 .231-2.0714 .3462-.1196 .021-.2068 .1248-.2068 .2462 0 .1214 .0872 .2252 .2068 .2462z" fill="#102030" stroke="none" inkscape:path-effect="#width1" inkscape:original-d="M 1.1,2.2 C 3.123456789012345,2.2 5.5,2.2 7.75,2.2 9.1,2.2 11.7,5.3 12.3,6.9" felt:id="a" felt:material="ink-pen" felt:closed="false" felt:joints="smooth" felt:widths="0,0.5 0.3333333333333333,1.2 2,0.7071067811865476"/>
<defs><inkscape:path-effect id="width2" effect="powerstroke" is_visible="true" lpeversion="1.3" scale_width="1" interpolator_type="Linear" interpolator_beta="0.2" start_linecap_type="round" end_linecap_type="round" linejoin_type="round" miter_limit="4" sort_points="true" not_jump="false" offset_points="0,0.4 | 1.5,0.45"/></defs>
<path id="stroke2" d="M20.0457 5.3974l-.0635 .0022c.9478 .0421 1.4035 .8375 1.3763 1.8265-.0279 1.0152-.575 1.9067-1.3374 2.0478l.0475-.0061c-.9718 .0706-1.582-.7396-1.6316-1.7523-.0002-.0029-.0003-.0057-.0005-.0086-.0676-.9919 .4309-1.974 1.6092-2.1095zM20.0142 4.6003c-.0169-.0007-.0339-.0002-.0508 .0014-1.7188 .1579-2.4781 1.6192-2.4256 2.9535 .0002 .0029 .0003 .0057 .0005 .0086 .0768 1.3131 .9698 2.7002 2.5968 2.5681 .0162-.0013 .0323-.0035 .0482-.0066 1.3371-.2619 1.9872-1.6709 2.0083-2.8805 .0216-1.237-.6262-2.5894-2.1774-2.6445z" fill="#a00000" fill-opacity="0.502" stroke="none" inkscape:path-effect="#width2" inkscape:original-d="M 20,5 C 22.5,5.1 22.2,9.3 20.1,9.7 17.5,9.9 17.1,5.3 20,5 Z" felt:id="b &lt;&amp;&gt;" felt:material="pencil" felt:closed="true" felt:joints="corner corner" felt:widths="0,0.8 1.5,0.9 2,0.8" felt:tones="0.25 0.5 1"/>
</svg>
)svg";

TEST(SvgImport, FilesOfVersion1ReadAsTheyDid) {
  const Imported back = imported(kVersion1);
  EXPECT_TRUE(back.report.empty()) << notice_lines(back);
  ASSERT_EQ(back.drawing.document.layers().size(), 1U);
  StrokeData open, ring;
  open.points = {
      {1.1, 2.2}, {3.123456789012345, 2.2}, {5.5, 2.2}, {7.75, 2.2}, {9.1, 2.2}, {11.7, 5.3},
      {12.3, 6.9}};
  open.joints = {JointKind::kSmooth};
  open.widths = {{0, 0.5}, {0.3333333333333333, 1.2}, {2, 0.7071067811865476}};
  open.medium = "ink-pen";
  open.color = {0x10, 0x20, 0x30, 0xff};
  ring.points = {{20, 5}, {22.5, 5.1}, {22.2, 9.3}, {20.1, 9.7}, {17.5, 9.9}, {17.1, 5.3}, {20, 5}};
  ring.joints = {JointKind::kCorner, JointKind::kCorner};
  ring.closed = true;
  ring.widths = {{0, 0.8, 0.25}, {1.5, 0.9, 0.5}, {2, 0.8, 1}};
  ring.color = {0xa0, 0, 0, 0x80};
  EXPECT_EQ(testing::strokes_in(back.drawing.document),
            (std::vector<Stroke>{Stroke::create(open).value(), Stroke::create(ring).value()}));
}

}  // namespace
}  // namespace felt::svg_import_test
