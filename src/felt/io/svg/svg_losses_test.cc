// SVG of other programs: no content is lost or drawn differently without a notice.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/io/svg/svg_import.h"
#include "felt/io/svg/svg_limits.h"
#include "felt/io/svg/svg_variables.h"
#include "felt/io/testing/test_drawings.h"

namespace felt::svg_losses_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr Rgba kRed{255, 0, 0, 255}, kBlack{0, 0, 0, 255};
constexpr const char* kRound = " stroke-linecap='round' stroke-linejoin='round' fill='none'";

/// The result of reading a document with user units of one millimetre.
struct ReadBack {
  std::vector<Stroke> strokes;
  std::string notices;
  std::optional<Page> page;
  explicit ReadBack(const std::string& inside, const std::string& before = {},
                    const std::string& behind = {}) {
    Result<Imported> result =
        import_svg(before +
                   "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='80mm' "
                   "viewBox='0 0 100 80'>\n" +
                   inside + "</svg>" + behind);
    EXPECT_TRUE(result) << result.error().message;
    if (!result) return;
    if (result->drawing.has_page) page = result->drawing.page;
    strokes = testing::strokes_in(result->drawing.document);
    for (const ImportNotice& n : result->report.notices()) notices += notice_text(n) + "\n";
  }
};

std::string line(const std::string& attributes) {
  return "<path d='M10 10h50'" + std::string(kRound) + " " + attributes + "/>";
}

Rgba color_of(const std::string& color) {
  const ReadBack read(line("style='stroke:" + color + "'"));
  EXPECT_THAT(read.notices, IsEmpty()) << color;
  EXPECT_EQ(read.strokes.size(), 1U) << color;
  return read.strokes.empty() ? Rgba{} : read.strokes[0].color();
}

void expect_near(Rgba a, Rgba b, int largest) {
  EXPECT_LE(std::abs(a.r - b.r), largest);
  EXPECT_LE(std::abs(a.g - b.g), largest) << int{a.g} << " " << int{b.g};
  EXPECT_LE(std::abs(a.b - b.b), largest);
  EXPECT_LE(std::abs(a.a - b.a), largest);
}

// The expected values for these colours are from CSS Color 4 and web-platform-tests.
TEST(SvgLosses, ColoursOfCss4) {
  for (const char* red :
       {"oklch(62.8% 0.25768 29.234)", "oklab(0.628 0.22486 0.1258)", "lab(54.29 80.81 69.89)",
        "lch(54.29 106.84 40.86)", "hwb(0 0% 0%)", "color(srgb 1 0 0)", "color(srgb-linear 1 0 0)",
        "color(xyz 0.41239 0.21264 0.01933)", "color-mix(in srgb, red, red 30%)",
        "light-dark(red, blue)", "color(srgb 1 0 0 / 100%)"}) {
    SCOPED_TRACE(red);
    expect_near(color_of(red), kRed, 2);
  }
  expect_near(color_of("color-mix(in srgb, white 25%, black)"), {64, 64, 64, 255}, 1);
  expect_near(color_of("hwb(120deg 20% 40%)"), {51, 153, 51, 255}, 1);
  expect_near(color_of("lab(50% 0 0 / 0.5)"), {119, 119, 119, 128}, 1);
  expect_near(color_of("color(display-p3 0 1 0)"), {0, 255, 0, 255}, 1);
  expect_near(color_of("CanvasText"), kBlack, 0);
}

TEST(SvgLosses, AColourThatIsNotReadBecomesBlackAndIsTold) {
  const ReadBack read(line("stroke='rgb(from red r g b)'"));
  ASSERT_EQ(read.strokes.size(), 1U);
  EXPECT_EQ(read.strokes[0].color(), kBlack);
  EXPECT_THAT(read.notices, HasSubstr("has a stroke that could not be read, and became black"));
  // This is how CSS is meant to work: an older form before the new one is the fallback.
  const ReadBack older(line("style='stroke:red;stroke:rgb(from blue r g b)'"));
  ASSERT_EQ(older.strokes.size(), 1U);
  EXPECT_EQ(older.strokes[0].color(), kRed);
  EXPECT_THAT(older.notices, IsEmpty());
}

TEST(SvgLosses, Variables) {
  const std::string area =
      "<style>:root{--ink:red;--w:4;--twice:var(--ink)} .b{--ink:blue}</style>";
  for (const char* red :
       {"var(--ink)", "var(--none, red)", "var(--none, var(--ink))", "var(--twice)"}) {
    const ReadBack read(area + line(std::string("stroke='") + red + "'"));
    ASSERT_EQ(read.strokes.size(), 1U) << red;
    EXPECT_EQ(read.strokes[0].color(), kRed) << red;
    EXPECT_THAT(read.notices, IsEmpty());
  }
  const ReadBack inner(area + "<g class='b'>" + line("stroke='var(--ink)'") + "</g>" +
                       line("stroke='var(--ink)' stroke-width='var(--w,5)'"));
  ASSERT_EQ(inner.strokes.size(), 2U);
  EXPECT_EQ(inner.strokes[0].color(), (Rgba{0, 0, 255, 255}));
  EXPECT_EQ(inner.strokes[1].color(), kRed);
  EXPECT_EQ(inner.strokes[1].width_mm(0.0), 4.0);
  const ReadBack unknown(line("stroke='var(--none)'"));
  ASSERT_EQ(unknown.strokes.size(), 1U);
  EXPECT_THAT(unknown.notices, HasSubstr("has a stroke that could not be read, and became black"));
  const ReadBack loop("<style>:root{--a:var(--b);--b:var(--a)}</style>" +
                      line("stroke='var(--a)'"));
  EXPECT_EQ(loop.strokes.size(), 1U);
}

// 30 variables in each of seven values are 30^7 replacements by nothing, so the work must be
// limited.
TEST(SvgLosses, VariablesThatMultiplyAreLeftOutInBoundedWork) {
  const std::string names = "abcdefg";
  std::string style;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string next = i + 1 < names.size() ? std::string(1, names[i + 1]) : "z,";
    style += std::string("--") + names[i] + ":";
    for (int n = 0; n < 30; ++n) style += "var(--" + next + ")";
    style += ";";
  }
  const ReadBack read(line("style='" + style + "' stroke='var(--a)'"));
  ASSERT_EQ(read.strokes.size(), 1U);
  EXPECT_THAT(read.notices, HasSubstr("has a stroke that could not be read, and became black"));

  // One value may read less than this needs. The file has a total limit for all values.
  const SvgVariables variables{{"--a", "var(--none,)"}};
  std::size_t left = 1000;
  EXPECT_EQ(svg_with_variables("x var(--a)", variables, left), "x ");
  EXPECT_EQ(left, 1000U - (10 + 12 + 0 + 3 * 16));
  std::string many;
  for (int i = 0; i < 4096; ++i) many += "var(--a)";
  left = 10'000'000;
  EXPECT_EQ(svg_with_variables(many, variables, left), std::nullopt);
  EXPECT_EQ(left, 10'000'000U - 64 * 1024);
  left = 40;
  EXPECT_EQ(svg_with_variables("x var(--a)", variables, left), std::nullopt);
  EXPECT_EQ(left, 0U);
}

TEST(SvgLosses, WidthsThatAreCalculatedOrNotRead) {
  const auto width = [](const char* text) {
    return ReadBack(line(std::string("stroke='red' stroke-width='") + text + "'"))
        .strokes.at(0)
        .width_mm(0.0);
  };
  EXPECT_DOUBLE_EQ(width("calc(1px + 2*(3 - 1))"), 5.0);
  EXPECT_DOUBLE_EQ(width("calc(10px / 4)"), 2.5);
  EXPECT_NEAR(width("calc(1em - 10px)"), 6.0, 1e-9);
  const ReadBack wrong(line("stroke='red' stroke-width='fat'"));
  EXPECT_THAT(wrong.notices,
              HasSubstr("has a stroke-width that could not be read, which was ignored"));
}

TEST(SvgLosses, PrefixesDeclaredBelowTheRoot) {
  const ReadBack read(
      "<s:g xmlns:s='http://www.w3.org/2000/svg'><s:line x1='1' y1='1' x2='9' y2='1' "
      "stroke='red'/></s:g><o:g xmlns:o='http://other'><o:line/></o:g>");
  EXPECT_EQ(read.strokes.size(), 1U);
}

TEST(SvgLosses, SizesAndPathsInCss) {
  const ReadBack read(
      "<style>rect{width:50px;height:20px} circle{r:20px;cx:30px;cy:30px} "
      "#p{d:path('M1 1L9 1')}</style><rect stroke='red' fill='none'/><circle "
      "stroke='red' fill='none'/><path id='p' stroke='red' fill='none'/>");
  ASSERT_EQ(read.strokes.size(), 3U);
  EXPECT_NEAR(read.strokes[0].bounds().width(), 51.0, 1e-6);
  EXPECT_NEAR(read.strokes[1].bounds().x0, 9.5, 1e-3);
  EXPECT_NEAR(read.strokes[2].bounds().width(), 9.0, 1e-6);
}

TEST(SvgLosses, TransformsAsProperties) {
  const ReadBack read("<g style='translate: 10px 20px; rotate: 90deg; scale: 2'>" +
                      line("stroke='red'") + "</g>");
  ASSERT_EQ(read.strokes.size(), 1U);
  // (10, 10) is scaled to (20, 20), rotated to (-20, 20), moved to (-10, 40).
  const Point begin = read.strokes[0].position(0.0);
  EXPECT_NEAR(begin.x, -10.0, 1e-9);
  EXPECT_NEAR(begin.y, 40.0, 1e-9);
  EXPECT_THAT(read.notices, IsEmpty());
}

TEST(SvgLosses, PathLengthAndLinesThatAreNotScaled) {
  const ReadBack dashes(
      line("stroke='red' stroke-width='0.1' pathLength='8' stroke-dasharray='1 1'"));
  EXPECT_EQ(dashes.strokes.size(), 4U);
  const ReadBack thin(
      "<g transform='scale(10)'><path d='M1 1h5' stroke='red' fill='none' "
      "stroke-width='4' vector-effect='non-scaling-stroke'/></g>");
  ASSERT_EQ(thin.strokes.size(), 1U);
  EXPECT_NEAR(thin.strokes[0].width_mm(0.0), 4.0 * 25.4 / 96.0, 1e-9);
}

TEST(SvgLosses, FlatDashesStayAsLongAsTheyAre) {
  // 10 mm of line and 5 mm of gap, 0.8 mm wide: the visible ink, including caps.
  const ReadBack read(
      "<path d='M0 10h100' fill='none' stroke='red' stroke-width='.8' "
      "stroke-dasharray='10 5'/>");
  ASSERT_EQ(read.strokes.size(), 7U);
  for (std::size_t i = 0; i < 6; ++i) {
    const Rect seen = read.strokes[i].bounds();
    EXPECT_NEAR(seen.x0, 15.0 * static_cast<double>(i), 1e-6) << i;
    EXPECT_NEAR(seen.width(), 10.0, 1e-6) << i;
  }
  const ReadBack wide(
      "<path d='M0 10h100' fill='none' stroke='red' stroke-width='1' "
      "stroke-dasharray='.5 .5'/>");
  EXPECT_THAT(wide.notices, HasSubstr("dashes shorter than its width, which became dots"));
  EXPECT_THAT(wide.notices, HasSubstr("has dashes that merge"));
}

TEST(SvgLosses, WideLinesKeepTheirFlatEndsAndCorners) {
  const ReadBack read(
      "<path d='M10 10h50v30' fill='none' stroke='red' stroke-width='4'/>"
      "<path d='M10 60h80' fill='none' stroke='red' stroke-width='4' stroke-dasharray='5 3'/>");
  EXPECT_THAT(read.notices, IsEmpty());
  ASSERT_EQ(read.strokes.size(), 11U);
  const std::vector<Point>& points = read.strokes[0].data().points;
  const auto has = [&](Point p) {
    return std::any_of(points.begin(), points.end(),
                       [&](Point q) { return distance(p, q) < 0.06; });
  };
  EXPECT_TRUE(has({10.0, 8.0}) && has({10.0, 12.0}));  // the corners of the flat end
  EXPECT_TRUE(has({62.0, 8.0}));                       // the tip of the mitre
  EXPECT_FALSE(has({10.0, 10.0}));
}

TEST(SvgLosses, AFrameCutsFillsAndLines) {
  const ReadBack read(
      "<svg x='10' y='10' width='20' height='20'>"
      "<path d='M-5 5h50' fill='none' stroke='red' stroke-width='.5'/></svg>");
  ASSERT_EQ(read.strokes.size(), 1U);
  EXPECT_NEAR(read.strokes[0].data().points.front().x, 10.0, 1e-9);
  EXPECT_NEAR(read.strokes[0].data().points.back().x, 30.0, 1e-9);
  EXPECT_THAT(read.notices, HasSubstr("its lines end about there"));
}

TEST(SvgLosses, AGradientIsItsMeanColour) {
  const auto color = [](const std::string& stops) {
    const ReadBack read("<linearGradient id='g'>" + stops + "</linearGradient>" +
                        line("stroke='url(#g)'"));
    EXPECT_THAT(read.notices, HasSubstr("mean colour of its stops"));
    EXPECT_EQ(read.strokes.size(), 1U);
    return read.strokes.empty() ? Rgba{} : read.strokes[0].color();
  };
  expect_near(color("<stop offset='0' stop-color='white'/><stop offset='1'/>"),
              {128, 128, 128, 255}, 1);
  expect_near(color("<stop offset='0' stop-color='red' stop-opacity='0'/><stop offset='1' "
                    "stop-color='red'/>"),
              {255, 0, 0, 128}, 1);
  expect_near(color("<stop offset='75%' stop-color='blue'/><stop offset='.75' stop-color='red'/>"),
              {64, 0, 191, 255}, 1);
}

TEST(SvgLosses, ARectangleThatIsCutIsNoPaper) {
  const std::string rect = "<rect width='100' height='80' fill='green' clip-path='url(#c)'/>";
  const ReadBack cut("<clipPath id='c'><circle r='5'/></clipPath>" + rect);
  ASSERT_TRUE(cut.page);
  EXPECT_NE(cut.page->paper, (Rgba{0, 128, 0, 255}));
  const ReadBack inherited(
      "<g clip-path='url(#c)'><rect width='100' height='80' fill='green'/></g>");
  EXPECT_NE(inherited.page->paper, (Rgba{0, 128, 0, 255}));
  const ReadBack whole("<rect width='100' height='80' fill='green'/>");
  EXPECT_EQ(whole.page->paper, (Rgba{0, 128, 0, 255}));
}

TEST(SvgLosses, WhatIsLeftOutIsTold) {
  const std::string red = line("stroke='red'");
  EXPECT_THAT(ReadBack(red, "<?xml-stylesheet href='a.css'?>").notices,
              HasSubstr("refers to a style sheet in another file"));
  EXPECT_THAT(ReadBack("<style>g{fill:red;&:hover{fill:blue}}</style>" + red).notices,
              HasSubstr("rules of style sheets are not supported"));
  EXPECT_THAT(ReadBack("<path d='M0 0h9' fill='none' marker-end='url(#m)'/>" + red).notices,
              HasSubstr("has markers, which were skipped"));
  EXPECT_THAT(ReadBack("<g style='mix-blend-mode:screen'>" + red + "</g>").notices,
              HasSubstr("blend mode, which was ignored"));
  EXPECT_THAT(ReadBack(line("stroke='red' style='mix-blend-mode:multiply'")).notices,
              HasSubstr("blend mode, which was ignored"));
  EXPECT_THAT(ReadBack("<g style='zoom:2'>" + red + "</g>").notices, HasSubstr("has a zoom"));
  EXPECT_THAT(ReadBack("<solidColor id='s' solid-color='red'/>" + line("stroke='url(#s)'"))
                  .strokes.at(0)
                  .color(),
              kRed);
}

TEST(SvgLosses, WhatFollowsTheFirstRootIsTold) {
  const ReadBack two(
      line("stroke='red'"), "",
      "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0h9' stroke='red'/></svg>");
  EXPECT_EQ(two.strokes.size(), 1U);
  EXPECT_THAT(two.notices, HasSubstr("svg was skipped: it follows the end of the drawing"));
}

TEST(SvgLosses, APathThatIsTooLongForAStrokeBecomesSeveral) {
  std::string d = "M0 0";
  for (std::size_t i = 1; i <= limits::kMaxSvgStrokeSegments + 10; ++i) {
    d += "L" + std::to_string(i % 100) + " " + std::to_string(i % 7);
  }
  const ReadBack read("<path stroke='red' fill='none' d='" + d + "'/>");
  ASSERT_EQ(read.strokes.size(), 2U);
  const Stroke& first = read.strokes[0];
  EXPECT_EQ(first.position(first.segment_count()), read.strokes[1].position(0.0));
  EXPECT_THAT(read.notices, HasSubstr("was split into several strokes"));
}

}  // namespace
}  // namespace felt::svg_losses_test
