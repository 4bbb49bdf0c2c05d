// SVG of other programs: which content becomes ink, which becomes a notice, and the limits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "felt/io/svg/svg_import.h"
#include "felt/io/svg/svg_limits.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/io/testing/import_checks.h"
#include "felt/io/testing/test_drawings.h"

namespace felt::svg_foreign_test {
namespace {

using ::testing::HasSubstr;
using testing::notice_lines;

/// Returns a document with user units of one millimetre.
std::string svg(const std::string& inside) {
  return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
         "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' "
         "xmlns:sodipodi='http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd' "
         "width='100mm' height='80mm' viewBox='0 0 100 80'>\n" +
         inside + "</svg>";
}

Imported imported(const std::string& text) {
  Result<Imported> result = import_svg(text);
  EXPECT_TRUE(result) << result.error().message;
  return result ? *std::move(result) : Imported();
}

std::vector<Stroke> strokes(const Imported& imported) {
  return testing::strokes_in(imported.drawing.document);
}

constexpr const char* kLine =
    " fill='none' stroke='#102030' stroke-width='2' stroke-linecap='round' "
    "stroke-linejoin='round'";

TEST(SvgForeign, CurvesAreTakenAsTheyAre) {
  const Imported drawing = imported(svg("<path id='leaf'" + std::string(kLine) +
                                        " d='M1 2C3 4 5 6 7 8S11 12 13 2l0 10'/><path" + kLine +
                                        " d='M20 20h10v10z'/>"));
  EXPECT_TRUE(drawing.report.empty()) << notice_lines(drawing);
  const std::vector<Stroke> ink = strokes(drawing);
  ASSERT_EQ(ink.size(), 2U);
  const StrokeData& d = ink[0].data();
  EXPECT_EQ(d.points[1], (Point{3, 4}));
  EXPECT_EQ(d.points[4], (Point{9, 10}));
  EXPECT_EQ(d.points[6], (Point{13, 2}));
  EXPECT_EQ(d.joints, (std::vector<JointKind>{JointKind::kSmooth, JointKind::kCorner}));
  EXPECT_EQ(d.widths, (std::vector<WidthKnot>{{0, 2}, {3, 2}}));
  EXPECT_EQ(d.color, (Rgba{0x10, 0x20, 0x30, 255}));
  EXPECT_TRUE(ink[1].closed());
  EXPECT_EQ(ink[1].segment_count(), 3);
  ASSERT_TRUE(drawing.drawing.has_page);
  EXPECT_EQ(drawing.drawing.page.area(), (Rect{0, 0, 100, 80}));
}

TEST(SvgForeign, ShortSegmentsGoIntoTheirNeighbours) {
  // The path is a circle of 400 pieces of 0.03 mm, a dot, and a curve with a zero-length part.
  std::string d = "M12 10";
  for (int i = 1; i < 400; ++i) {
    const double a = 6.283185307179586 * i / 400.0;
    d += "L" + std::to_string(10 + 2 * std::cos(a)) + " " + std::to_string(10 + 2 * std::sin(a));
  }
  const Imported drawing =
      imported(svg("<path" + std::string(kLine) + " d='" + d + "z'/><path" + kLine +
                   " d='M40 40h0.01'/><path" + kLine + " d='M50 50h5v0l0.02 0h5'/>"));
  const std::vector<Stroke> ink = strokes(drawing);
  ASSERT_EQ(ink.size(), 3U) << notice_lines(drawing);
  EXPECT_TRUE(ink[0].closed());
  for (double u = 0.0; u <= ink[0].segment_count(); u += 0.25) {
    EXPECT_NEAR(distance(ink[0].position(u), {10, 10}), 2.0, 0.05);
  }
  EXPECT_NEAR(distance(ink[1].position(0.5), {40.005, 40}), 0.0, 1e-9);
  EXPECT_EQ(ink[2].segment_count(), 2);
  EXPECT_EQ(ink[2].data().points.back(), (Point{60.02, 50}));
  EXPECT_THAT(notice_lines(drawing), HasSubstr("shorter than 0.05 mm"));
}

TEST(SvgForeign, StretchedPensAreAsWideAsTheyGo) {
  const Imported drawing =
      imported(svg("<g transform='scale(3 1)'><path" + std::string(kLine) + " d='M1 1h5'/><path" +
                   kLine + " d='M10 1v5'/><path" + kLine +
                   " d='M10 10h5v5'/><circle cx='20' cy='30' r='5'" + kLine + "/></g>"));
  const std::vector<Stroke> ink = strokes(drawing);
  ASSERT_EQ(ink.size(), 4U);
  EXPECT_NEAR(ink[0].width_mm(0.5), 2.0, 1e-9);
  EXPECT_NEAR(ink[1].width_mm(0.5), 6.0, 1e-9);
  EXPECT_NEAR(ink[2].width_mm(0.5), 2.0, 1e-9);
  EXPECT_NEAR(ink[2].width_mm(1.5), 6.0, 1e-9);
  EXPECT_NEAR(ink[3].width_mm(0.0), 6.0, 1e-9);
  EXPECT_NEAR(ink[3].width_mm(1.0), 2.0, 1e-9);
  EXPECT_THAT(notice_lines(drawing), HasSubstr("stretched in one direction"));
}

TEST(SvgForeign, DashesAreStrokes) {
  const Imported drawing =
      imported(svg("<path" + std::string(kLine) +
                   " stroke-dasharray='6 4' stroke-dashoffset='2' d='M10 10h30'/>"));
  const std::vector<Stroke> ink = strokes(drawing);
  ASSERT_EQ(ink.size(), 4U);
  EXPECT_NEAR(ink[0].data().points.back().x, 14.0, 1e-9);
  EXPECT_NEAR(ink[1].data().points.front().x, 18.0, 1e-9);
  EXPECT_NEAR(ink[1].data().points.back().x, 24.0, 1e-9);
  EXPECT_NEAR(ink[3].data().points.back().x, 40.0, 1e-9);
}

std::vector<Fill> fills(const Imported& imported) {
  std::vector<Fill> found;
  for (const Layer& layer : imported.drawing.document.layers()) {
    for (const FillId id : layer.fills) {
      found.push_back(*imported.drawing.document.find_fill(id));
    }
  }
  return found;
}

/// Returns a square of 10 mm as path data, drawn to the right first, or down first.
std::string square(double x, bool right_first) {
  const std::string at = "M" + std::to_string(x) + " " + std::to_string(x);
  const std::string side = std::to_string(50 - 2 * x), back = "-" + side;
  return right_first ? at + "h" + side + "v" + side + "h" + back + "z"
                     : at + "v" + side + "h" + side + "v" + back + "z";
}

TEST(SvgForeign, TheNonZeroRuleKeepsOnlyContoursThatSeparate) {
  const auto loops = [](const std::string& d, const std::string& rule) {
    const Imported drawing = imported(svg("<path fill-rule='" + rule + "' d='" + d + "'/>"));
    EXPECT_TRUE(drawing.report.empty()) << notice_lines(drawing);
    const std::vector<Fill> found = fills(drawing);
    return found.size() == 1 ? found[0].loops.size() : 0;
  };
  const std::string same = square(5, true) + square(10, true),
                    hole = square(5, true) + square(10, false);
  EXPECT_EQ(loops(same, "nonzero"), 1U) << "no hole";
  EXPECT_EQ(loops(hole, "nonzero"), 2U) << "a hole";
  EXPECT_EQ(loops(same, "evenodd"), 2U) << "a hole";
  EXPECT_EQ(loops(same + square(15, false) + square(20, false), "nonzero"), 2U)
      << "a hole in the innermost square only";
  const Imported star = imported(svg("<path d='M20 2L32 38L2 15H38L8 38z'/>"));
  EXPECT_TRUE(star.report.empty()) << "cut where it crosses itself";
  ASSERT_EQ(fills(star).size(), 1U);
  EXPECT_EQ(fills(star)[0].loops.size(), 1U) << "without the lines inside the star";
  EXPECT_EQ(fills(star)[0].loops[0].points.size(), 31U) << "ten sides";
  const Imported twice = imported(svg("<path d='M2 2h20v20h-20zM2 2h20v30h-20zM9 9h30v4h-30z'/>"));
  EXPECT_TRUE(twice.report.empty()) << "sides lie on each other";
  ASSERT_EQ(fills(twice).size(), 1U);
  EXPECT_EQ(fills(twice)[0].loops.size(), 1U) << "one outline around all three";
}

TEST(SvgForeign, AFillThatCoversALineIsInALayerAboveIt) {
  const Imported drawing = imported(svg("<path" + std::string(kLine) +
                                        " d='M10 10h30'/><rect x='60' width='9' "
                                        "height='9'/><rect x='20' y='5' width='9' height='9'/>"));
  const auto layers = drawing.drawing.document.layers();
  ASSERT_EQ(layers.size(), 2U);
  EXPECT_EQ(layers[0].fills.size(), 1U) << "the rectangle beside the line";
  EXPECT_EQ(layers[0].strokes.size(), 1U);
  EXPECT_EQ(layers[1].fills.size(), 1U);
}

TEST(SvgForeign, FilledShapesAreFills) {
  const Imported drawing = imported(
      svg("<path id='a' fill='teal' d='M10 10h10v10'/>\n<circle fill='navy' stroke='red' r='9' "
          "cx='50' cy='50' stroke-linejoin='round'/>"));
  const std::vector<Stroke> ink = strokes(drawing);
  ASSERT_EQ(ink.size(), 1U);
  EXPECT_EQ(ink[0].color(), (Rgba{255, 0, 0, 255}));
  const std::vector<Fill> areas = fills(drawing);
  ASSERT_EQ(areas.size(), 2U);
  EXPECT_EQ(areas[0].color, (Rgba{0, 128, 128, 255}));
  EXPECT_EQ(fill_bounds(areas[0]), (Rect{10, 10, 20, 20}));
  EXPECT_EQ(areas[0].loops[0].points.size(), 10U) << "closed by a straight line";
  EXPECT_EQ(areas[1].color, (Rgba{0, 0, 128, 255}));
  EXPECT_TRUE(drawing.report.empty()) << notice_lines(drawing);
}

TEST(SvgForeign, SaysWhatItLeavesOut) {
  const Imported drawing = imported(svg(
      "<text id='title'>x</text>\n<text>y</text>\n<image/>\n<script>a()</script>\n<g "
      "filter='url(#f)' "
      "mask='url(#m)' clip-path='url(#c)'/>\n<path" +
      std::string(kLine) +
      " marker-end='url(#m)' d='M1 1h9'><animate/></path><use xlink:href='other.svg#a'/><use "
      "xlink:href='#none'/><path visibility='hidden' d='M1 1h9'/><rect fill='url(#g)' width='9' "
      "height='9'/><linearGradient id='g'><stop stop-color='red'/></linearGradient><foreignObject/>"
      "<path stroke='red' d='M1 1h9x'/>"));
  const std::string text = notice_lines(drawing);
  for (const char* expected :
       {"line 2: text 'title' is not a stroke and was skipped (and 2 more like it)",
        "line 4: image was skipped: it names no picture",
        "line 5: script was skipped: scripts are not", "line 6: g has a filter",
        "line 6: g has a mask", "line 6: g has a clip path", "line 7: path has markers",
        "it is in another file", "the element it refers to is not in the file",
        "is hidden in the file", "mean colour of its stops",
        "was read up to an error: no command at character 7", "has flat or square ends"}) {
    EXPECT_THAT(text, HasSubstr(expected));
  }
  const std::vector<Stroke> ink = strokes(drawing);
  EXPECT_EQ(ink.size(), 2U);
  const std::vector<Fill> areas = fills(drawing);
  ASSERT_EQ(areas.size(), 1U);
  EXPECT_EQ(areas[0].color, (Rgba{255, 0, 0, 255}));
}

TEST(SvgForeign, OnlyCornersThatShowAreNamed) {
  const auto notices = [](const std::string& d) {
    return notice_lines(
        imported(svg("<path stroke='red' fill='none' stroke-linecap='round' d='" + d + "'/>")));
  };
  for (const char* smooth : {"M0 5A5 5 0 0 1 10 5A5 5 0 0 1 0 5Z", "M0 0C3 0 6 1 9 1S15 0 18 0",
                             "M0 0H9H20", "M5 5Z", "M0 0H5L10 0.5"}) {
    EXPECT_THAT(notices(smooth), Not(HasSubstr("corners"))) << smooth;
  }
  for (const char* angular : {"M0 0H9V9", "M0 0H9V9Z", "M0 0C3 3 6 3 9 0Z", "M0 0H9L0 1"}) {
    EXPECT_THAT(notices(angular), HasSubstr("corners")) << angular;
  }
}

TEST(SvgForeign, LayersOfInkscape) {
  const std::string path = "<path" + std::string(kLine) + " d='M1 1h9'/>";
  const Imported drawing = imported(svg(
      path + "<g inkscape:groupmode='layer' inkscape:label='Back' sodipodi:insensitive='true'>" +
      path + "<g inkscape:groupmode='layer' inkscape:label='Sub' style='display:none'>" + path +
      "</g>" + path + "</g>" + path));
  std::vector<std::string> layers;
  for (const Layer& l : drawing.drawing.document.layers()) {
    layers.push_back(l.name + (l.visible ? "" : " hidden") + (l.locked ? " locked" : "") + " " +
                     std::to_string(l.strokes.size()));
  }
  EXPECT_THAT(layers, ::testing::ElementsAre("Ink 1", "Back locked 1", "Sub hidden locked 1",
                                             "Back locked 1", "Ink 1"));
  const auto read = drawing.drawing.document.layers();
  EXPECT_FALSE(read[0].group);
  ASSERT_TRUE(read[1].group);
  EXPECT_EQ(read[1].group->name, "Back");
  EXPECT_TRUE(read[1].group->locked);
  EXPECT_FALSE(read[1].own_locked);
  EXPECT_EQ(read[1].group, read[2].group);
  EXPECT_EQ(read[1].group, read[3].group);
  EXPECT_FALSE(read[4].group);
}

TEST(SvgForeign, AGroupWithABlendModeBecomesALayer) {
  const std::string path = "<path" + std::string(kLine) + " d='M1 1h9'/>";
  const Imported drawing =
      imported(svg(path + "<g id='shade' style='mix-blend-mode: multiply;opacity:0.5'>" + path +
                   "<g>" + path + "</g></g><g style='mix-blend-mode:multiply'/>" + path));
  EXPECT_EQ(notice_lines(drawing), "");
  const auto layers = drawing.drawing.document.layers();
  ASSERT_EQ(layers.size(), 3U);
  EXPECT_EQ(layers[0].blend, BlendMode::kNormal);
  EXPECT_EQ(layers[1].blend, BlendMode::kMultiply);
  EXPECT_EQ(layers[1].name, "shade");
  EXPECT_EQ(layers[1].opacity, 0.5);
  EXPECT_EQ(layers[1].strokes.size(), 2U);
  EXPECT_EQ(drawing.drawing.document.find(layers[1].strokes[0])->color().a, 255);
  EXPECT_EQ(layers[2].blend, BlendMode::kNormal);
}

TEST(SvgForeign, LayersInGroupsOfLayers) {
  const std::string path = "<path" + std::string(kLine) + " d='M1 1h9'/>";
  const std::string layer = "<g inkscape:groupmode='layer' inkscape:label=";
  const Imported drawing = imported(
      svg(layer + "'Outer' style='mix-blend-mode:multiply;opacity:0.5'>" + layer +
          "'A' style='opacity:0.25'>" + path + "</g>" + layer + "'B'>" + path + layer +
          "'Deep' style='opacity:0.5'>" + path + "</g></g></g>" + layer + "'C'>" + path + "</g>"));
  const auto layers = drawing.drawing.document.layers();
  ASSERT_EQ(layers.size(), 4U);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(layers[i].group) << i;
    EXPECT_EQ(*layers[i].group, (LayerGroup{{1}, "Outer", true, false, 0.5, BlendMode::kMultiply}));
    EXPECT_EQ(layers[i].blend, BlendMode::kNormal);
  }
  EXPECT_EQ(layers[0].opacity, 0.25);
  EXPECT_EQ(layers[2].name, "Deep");
  EXPECT_EQ(layers[2].opacity, 0.5);
  EXPECT_FALSE(layers[3].group);
}

TEST(SvgForeign, PageAndPaper) {
  const auto page = [](const std::string& head, const std::string& inside = "") {
    const Drawing drawing =
        imported("<svg xmlns='http://www.w3.org/2000/svg' " + head + ">" + inside + "</svg>")
            .drawing;
    return drawing.has_page ? std::optional(drawing.page) : std::nullopt;
  };
  EXPECT_EQ(page("width='210mm' height='297mm'")->area(), (Rect{0, 0, 210, 297}));
  EXPECT_NEAR(page("width='960' height='96px'")->width_mm, 254.0, 1e-9);
  EXPECT_NEAR(page("viewBox='5 5 960 480'")->height_mm, 127.0, 1e-9);
  EXPECT_FALSE(page(""));
  EXPECT_FALSE(page("width='9mm' height='90mm'"));
  EXPECT_FALSE(page("width='6m' height='90mm'"));
  EXPECT_EQ(page("width='96' height='96'", "<rect width='100%' height='100%' fill='#123'/>")->paper,
            (Rgba{0x11, 0x22, 0x33, 255}));
  EXPECT_EQ(page("width='96' height='96' style='background-color:#abc'")->paper.b, 0xcc);
}

std::string power_stroke(const std::string& effect, const std::string& path) {
  return svg("<defs><inkscape:path-effect id='e' effect='powerstroke' " + effect +
             "/></defs><path id='p' fill='teal' d='M0 0h9v9z' inkscape:path-effect='#e' "
             "inkscape:original-d='" +
             path + "'/>");
}

TEST(SvgForeign, PowerStrokesHaveTheirWidths) {
  const Imported linear =
      imported(power_stroke("interpolator_type='Linear' offset_points='0.5,1 | 1.25,2'",
                            "M10 10C13 10 17 10 20 10L30 20"));
  EXPECT_TRUE(linear.report.empty()) << notice_lines(linear);
  const Stroke stroke = strokes(linear).at(0);
  EXPECT_EQ(stroke.data().widths, (std::vector<WidthKnot>{{0, 2}, {0.5, 2}, {1.25, 4}, {2, 4}}));
  EXPECT_EQ(stroke.color(), (Rgba{0, 128, 128, 255}));
  const Imported johan = imported(power_stroke(
      "interpolator_type='CubicBezierJohan' scale_width='2' end_linecap_type='zerowidth' "
      "offset_points='0,1 | 1,2'",
      "M10 10L20 10L30 20"));
  EXPECT_THAT(notice_lines(johan), HasSubstr("CubicBezierJohan, which were sampled"));
  const Stroke sampled = strokes(johan).at(0);
  EXPECT_EQ(sampled.width_mm(0.0), 4.0);
  EXPECT_EQ(sampled.width_mm(1.0), 8.0);
  EXPECT_NEAR(sampled.width_mm(0.5), 6.0, 1e-9);
  EXPECT_EQ(sampled.width_mm(2.0), kMinWidthMm);
  const Imported ring = imported(power_stroke("offset_points='1,1 | 3,2'", "M10 10h10v10h-10z"));
  EXPECT_NEAR(strokes(ring).at(0).width_mm(0.0), 3.0, 1e-9);
  EXPECT_NEAR(strokes(ring).at(0).width_mm(4.0), 3.0, 1e-9);
  const Imported broken = imported(power_stroke("offset_points=''", "M10 10h10"));
  EXPECT_THAT(notice_lines(broken), HasSubstr("lost its variable width"));
  EXPECT_EQ(strokes(broken).size() + fills(broken).size(), 1U);
}

TEST(SvgForeign, DepthEndsInAnError) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 1; i < depth; ++i) text += "<g>";
    for (int i = 1; i < depth; ++i) text += "</g>";
    return import_svg("<svg>" + text + "</svg>");
  };
  EXPECT_TRUE(nested(255));
  EXPECT_TRUE(nested(256));
  ASSERT_FALSE(nested(257));
  EXPECT_EQ(nested(257).error().code, ErrorCode::kLimitExceeded);
  EXPECT_FALSE(nested(60000));
}

TEST(SvgForeign, AttributesOfAnElementEndInAnError) {
  const auto with = [](std::size_t count) {
    std::string text = "<svg>\n<g";
    for (std::size_t i = 0; i < count; ++i) text += " a" + std::to_string(i) + "=''";
    return import_svg(text + "/></svg>");
  };
  EXPECT_TRUE(with(limits::kMaxSvgAttributes - 1));
  EXPECT_TRUE(with(limits::kMaxSvgAttributes));
  ASSERT_FALSE(with(limits::kMaxSvgAttributes + 1));
  EXPECT_THAT(with(limits::kMaxSvgAttributes + 1).error().message, HasSubstr("line 2: g has more"));
}

TEST(SvgForeign, ElementsEndInAnError) {
  std::string text = "<svg><defs>";
  text.reserve(9'000'000);
  for (int i = 0; i < 1'999'998; ++i) text += "<a/>";
  EXPECT_TRUE(import_svg(text + "</defs></svg>"));
  const auto over = import_svg(text + "<a/></defs></svg>");
  ASSERT_FALSE(over);
  EXPECT_EQ(over.error().code, ErrorCode::kLimitExceeded);
}

TEST(SvgForeign, EntitiesAddLittle) {
  const auto with = [](std::size_t bytes, int times) {
    std::string text =
        "<!DOCTYPE svg [<!ENTITY e \"" + std::string(bytes, 'x') + "\">]>\n<svg><desc>";
    for (int i = 0; i < times; ++i) text += "&e;";
    return import_svg(text + "</desc></svg>");
  };
  constexpr std::size_t kMax = limits::kMaxSvgEntityBytes;
  EXPECT_TRUE(with(kMax / 8 - 1, 8));
  EXPECT_TRUE(with(kMax / 8, 8));
  EXPECT_FALSE(with(kMax / 8, 9));
  // Entities inside entities are replaced; the "billion laughs" attack is refused.
  const Imported nested = imported(
      "<!DOCTYPE svg [<!ENTITY c 'red'><!ENTITY st 'stroke:&c;'>]>\n<svg "
      "xmlns='http://www.w3.org/2000/svg'><path style='&st;' d='M1 1h9'/></svg>");
  ASSERT_EQ(strokes(nested).size(), 1U);
  EXPECT_EQ(strokes(nested)[0].color(), (Rgba{255, 0, 0, 255}));
  std::string laughs = "<!DOCTYPE svg [<!ENTITY a \"ha\">";
  for (char c = 'b'; c <= 'z'; ++c) {
    const std::string before = std::string("&") + static_cast<char>(c - 1) + ";";
    laughs += std::string("<!ENTITY ") + c + " \"" + before + before + before + before + "\">";
  }
  const auto laughed = import_svg(laughs + "]><svg><desc>&z;&z;</desc></svg>");
  ASSERT_FALSE(laughed);
  EXPECT_EQ(laughed.error().code, ErrorCode::kLimitExceeded);
  EXPECT_TRUE(
      import_svg("<!DOCTYPE svg [<!ENTITY x SYSTEM \"file:///etc/passwd\">]><svg>&x;</svg>"));
  EXPECT_FALSE(import_svg("<!DOCTYPE svg [<!ENTITY x 'a'><svg/>"));
}

TEST(SvgForeign, RepeatingElementsEnds) {
  // Ten levels of ten entities: 10^10 of the last one.
  std::string text;
  for (int level = 0; level < 10; ++level) {
    text += "<g id='l" + std::to_string(level) + "'>";
    for (int i = 0; i < 10; ++i) text += "<use xlink:href='#l" + std::to_string(level + 1) + "'/>";
    text += "</g>";
  }
  const Imported bomb = imported(svg(text + "<path id='l10'" + kLine + " d='M1 1h9'/>"));
  EXPECT_THAT(notice_lines(bomb), HasSubstr("too many elements are repeated by 'use'"));
  EXPECT_LE(strokes(bomb).size(), static_cast<std::size_t>(limits::kMaxSvgUseElements));
  const Imported cycle = imported(
      svg("<g id='a'><use xlink:href='#b'/></g><g id='b'><use xlink:href='#a'/></g><use id='c' "
          "xlink:href='#c'/>"));
  EXPECT_THAT(notice_lines(cycle), HasSubstr("it refers to itself"));
  // One long path, repeated: the total number of curves is limited.
  std::string path = "M0 0";
  for (int i = 0; i < 20000; ++i) path += "l9 9";
  text = "<path id='p'" + std::string(kLine) + " d='" + path + "'/>";
  for (int i = 0; i < 2000; ++i) text += "<use xlink:href='#p'/>";
  const std::string long_file = svg(text);
  std::size_t segments = 0;
  const Imported many = imported(long_file);
  for (const Stroke& s : strokes(many)) {
    segments += static_cast<std::size_t>(s.segment_count());
  }
  EXPECT_LE(segments, limits::kSpareSvgSegments + long_file.size() / 2);
  EXPECT_THAT(notice_lines(many), HasSubstr("too many curves"));
}

/// Tests work that is not repeated elements. Each of these files would take minutes without a
/// limit.
TEST(SvgForeign, HiddenWorkIsCounted) {
  const auto times = [](const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
  };
  const std::string uses = times("<use xlink:href='#p'/>", 20000);
  const std::string line(kLine), cdata = times("<![CDATA[]]>", 60000);
  EXPECT_FALSE(strokes(imported(svg("<path id='p'" + line + " d='M1 1h9'>" +
                                    times("<desc/>", 60000) + "</path>" + uses)))
                   .empty());
  imported(svg("<g id='p'>" + cdata + "</g>" + uses));
  imported(svg("<defs><switch id='p'>" + times("<q/>", 60000) + "</switch></defs>" + uses));
  imported(svg("<linearGradient id='g'>" + times("<q/>", 60000) + "</linearGradient>" +
               times("<rect fill='url(#g)' width='9' height='9'/>", 20000)));
  imported(svg("<style>rect:first-child{fill:red} rect+rect{fill:blue}</style>" + cdata +
               times("<g>" + std::string("<![CDATA[]]>") + "<rect width='9' height='9'/></g>", 9) +
               times("<rect width='9' height='9'/>", 20000)));
  imported(svg("<style>path:last-child{fill:red}</style><path id='p'" + line + " d='M1 1h9'/>" +
               cdata + uses));
}

TEST(SvgForeign, UseReachesItsLimit) {
  const auto uses = [](std::int64_t count) {
    std::string text = "<path id='p' d='M1 1h9' stroke='red'/>";
    for (std::int64_t i = 0; i < count; ++i) text += "<use xlink:href='#p'/>";
    return strokes(imported(svg(text))).size();
  };
  const auto largest = static_cast<std::size_t>(limits::kMaxSvgUseElements);
  EXPECT_EQ(uses(limits::kMaxSvgUseElements - 1), largest);
  EXPECT_EQ(uses(limits::kMaxSvgUseElements), largest + 1);
  EXPECT_EQ(uses(limits::kMaxSvgUseElements + 1), largest + 1);
}

TEST(SvgForeign, DashesEnd) {
  const auto dashes = [](const char* pattern) {
    return imported(
        svg("<path" + std::string(kLine) + " stroke-dasharray='" + pattern + "' d='M0 0h99999'/>"));
  };
  EXPECT_GT(strokes(dashes("0.5 0.50002")).size(), limits::kMaxSvgDashes - 10);
  const Imported over = dashes("0.5 0.49");
  EXPECT_EQ(strokes(over).size(), 1U);
  EXPECT_THAT(notice_lines(over), HasSubstr("became a solid line"));
  EXPECT_EQ(strokes(dashes("1e-7")).size(), 1U);
}

TEST(SvgForeign, LayersReachTheirLimit) {
  const auto layers = [](std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += "<g inkscape:groupmode='layer'/>";
    return imported(svg(text)).drawing.document.layers().size();
  };
  EXPECT_EQ(layers(limits::kMaxSvgLayers - 1), limits::kMaxSvgLayers - 1);
  EXPECT_EQ(layers(limits::kMaxSvgLayers), limits::kMaxSvgLayers);
  EXPECT_EQ(layers(limits::kMaxSvgLayers + 1), limits::kMaxSvgLayers);
}

TEST(SvgForeign, HugeNumbersEndInNotices) {
  const std::string line(kLine);
  const std::vector<std::string> odd_ones{
      "<path" + line + " d='M0 0L1e400 1'/>",
      "<path" + line + " d='M0 0L1e9 1'/>",
      "<g transform='scale(1e30)'><g transform='scale(1e30)'><path" + line +
          " d='M1 1L2 3'/></g></g>",
      "<g transform='scale(0)'><path" + line + " d='M1 1L2 3'/></g>",
      "<g transform='scale(1 0)'><path" + line + " d='M1 1L2 3'/></g>",
      "<path fill='none' stroke='red' stroke-width='1e9' d='M1 1L2 3'/>",
      "<path d='M" + std::string(100'000, '1') + " 1'/>",
      "<rect width='1e9' height='1e9' stroke='red'/>",
      "<circle r='1e12mm' stroke='red'/>"};
  for (const std::string& odd : odd_ones) {
    const Imported drawing = imported(svg(odd));
    EXPECT_FALSE(drawing.report.empty()) << odd.substr(0, 200);
    EXPECT_TRUE(svg_text(drawing.drawing, {})) << odd.substr(0, 200);
  }
}

}  // namespace
}  // namespace felt::svg_foreign_test
