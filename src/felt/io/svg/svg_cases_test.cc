// SVG of other programs: path effects that are off or not alone, a transform of the root, and
// shapes without paint.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "felt/document/visible_strokes.h"
#include "felt/io/svg/svg_import.h"
#include "felt/io/testing/import_checks.h"
#include "felt/io/testing/test_drawings.h"

namespace felt::svg_cases_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::notice_lines;

/// Reads a document with the given attributes of the root.
Imported read(const std::string& inside, const std::string& root) {
  Result<Imported> result = import_svg(
      "<svg xmlns='http://www.w3.org/2000/svg' "
      "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' " +
      root + ">\n" + inside + "</svg>");
  EXPECT_TRUE(result) << result.error().message;
  return result ? *std::move(result) : Imported();
}

/// Reads a document with user units of one millimetre.
Imported read(const std::string& inside) {
  return read(inside, "width='100mm' height='80mm' viewBox='0 0 100 80'");
}

std::vector<Stroke> strokes(const Imported& imported) {
  return testing::strokes_in(imported.drawing.document);
}

/// Returns a line of width 1 with path effects. Each has an id "e0", "e1" and so on.
Imported with_effects(const std::vector<std::string>& effects,
                      const std::string& style = "fill='none' stroke='#000' stroke-width='1'") {
  std::string defs, ids;
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const std::string id = "e" + std::to_string(i);
    defs += "<inkscape:path-effect id='" + id + "' " + effects[i] + "/>";
    ids += (i > 0 ? ";#" : "#") + id;
  }
  return read("<defs>" + defs + "</defs><path " + style + " inkscape:path-effect='" + ids +
              "' inkscape:original-d='M10 30L50 20L90 30' d='M10 30C30 10 60 50 90 30'/>");
}

constexpr const char* kOff =
    "effect='powerstroke' is_visible='false' offset_points='0,1 | 1,2.5' "
    "interpolator_type='Linear'";
constexpr const char* kOn =
    "effect='powerstroke' is_visible='true' offset_points='0,1 | 1,2.5' interpolator_type='Linear'";

/// Expects one stroke that is the path `d` with a width of 1 mm.
void expect_plain_line(const Imported& drawing) {
  const std::vector<Stroke> ink = strokes(drawing);
  ASSERT_EQ(ink.size(), 1U) << notice_lines(drawing);
  EXPECT_EQ(ink[0].segment_count(), 1);
  EXPECT_EQ(ink[0].data().points.at(1), (Point{30, 10}));
  for (const WidthKnot& knot : ink[0].data().widths) EXPECT_EQ(knot.width_mm, 1.0);
  EXPECT_EQ(drawing.drawing.document.fill_count(), 0U);
}

TEST(SvgEffects, ThatAreOffDoNotChangeTheLine) {
  expect_plain_line(with_effects({kOff}));
  expect_plain_line(with_effects({kOff, kOff}));
  expect_plain_line(with_effects({"effect='simplify' is_visible='false'"}));
}

TEST(SvgEffects, ThatAreOffDoNotHideThoseThatAreOn) {
  for (const std::vector<std::string>& effects : {std::vector<std::string>{kOn},
                                                  {kOff, kOn},
                                                  {"effect='simplify' is_visible='false'", kOn}}) {
    const std::vector<Stroke> ink = strokes(with_effects(effects, "fill='#000'"));
    ASSERT_EQ(ink.size(), 1U);
    EXPECT_EQ(ink[0].segment_count(), 2) << "original-d";
    EXPECT_EQ(ink[0].data().widths, (std::vector<WidthKnot>{{0, 2}, {1, 5}, {2, 5}}));
  }
}

TEST(SvgEffects, BesideAPowerStrokeAreShownAsTheyAre) {
  for (const std::vector<std::string>& effects :
       {std::vector<std::string>{"effect='simplify' is_visible='true'", kOn},
        {kOn, "effect='simplify'"},
        {kOn, kOn},
        {"effect='roughen'"}}) {
    const Imported drawing = with_effects(effects, "fill='#000'");
    EXPECT_TRUE(strokes(drawing).empty());
    EXPECT_EQ(drawing.drawing.document.fill_count(), 1U);
  }
}

/// Expects the ink of a line from (10, 10) over (50, 10) to (50, 20), 1 mm wide.
void expect_ink(const std::string& root, const Rect& expected) {
  const Imported drawing = read(
      "<path fill='none' stroke='#000' stroke-linecap='round' stroke-linejoin='round' "
      "d='M10 10H50V20'/>",
      root);
  EXPECT_THAT(notice_lines(drawing), IsEmpty()) << root;
  const Rect box = ink_bounds(drawing.drawing.document);
  EXPECT_NEAR(box.x0, expected.x0, 1e-6) << root;
  EXPECT_NEAR(box.y0, expected.y0, 1e-6) << root;
  EXPECT_NEAR(box.x1, expected.x1, 1e-6) << root;
  EXPECT_NEAR(box.y1, expected.y1, 1e-6) << root;
}

TEST(SvgRoot, TurnsAboutItsMiddle) {
  const std::string size = "width='80mm' height='80mm' viewBox='0 0 80 80' ";
  expect_ink(size, {9.5, 9.5, 50.5, 20.5});
  expect_ink(size + "style='transform:rotate(180deg)'", {29.5, 59.5, 70.5, 70.5});
  expect_ink(size + "transform='rotate(180)'", {29.5, 59.5, 70.5, 70.5});
  expect_ink(size + "style='rotate:180deg'", {29.5, 59.5, 70.5, 70.5});
  expect_ink(size + "style='transform:scale(-1,1)'", {29.5, 9.5, 70.5, 20.5});
  // A page that is not square, whose view box begins elsewhere.
  expect_ink("width='80mm' height='60mm' viewBox='-10 0 80 60' transform='rotate(180)'",
             {19.5, 39.5, 60.5, 50.5});
}

TEST(SvgRoot, HasLengthsOfThePageInItsTransform) {
  // One user unit is 2 mm.
  const std::string size = "width='160mm' height='160mm' viewBox='0 0 80 80' ";
  expect_ink(size, {19, 19, 101, 41});
  expect_ink(size + "style='transform:translate(96px,-48px)'", {44.4, 6.3, 126.4, 28.3});
  expect_ink(size + "style='translate:10mm 5mm'", {29, 24, 111, 46});
  expect_ink(size + "style='transform-origin:0 0;transform:rotate(90deg)'", {-41, 19, -19, 101});
  expect_ink(size + "style='transform-origin:100% 0;transform:scale(.5)'",
             {89.5, 9.5, 130.5, 20.5});
}

TEST(SvgRoot, KeepsItsPositionWithXAndY) {
  // The outermost element ignores x and y.
  const std::string size = "width='80mm' height='80mm' viewBox='0 0 80 80' x='30' y='40' ";
  expect_ink(size, {9.5, 9.5, 50.5, 20.5});
  expect_ink(size + "transform='rotate(180)'", {29.5, 59.5, 70.5, 70.5});
}

TEST(SvgUnpainted, ShapesAreCounted) {
  const Imported drawing = read(
      "<path style='fill:none;stroke:#f00;stroke-width:0' d='M10 10H90V50'/>\n"
      "<path style='fill:none' d='M20 10V50'/>\n"
      "<line x1='1' y1='2' x2='30' y2='40'/>\n"
      "<circle r='9' fill='none'/><path fill='transparent' d='M1 1h9v5z'/>"
      "<path style='fill:none;stroke:#000' d='M10 40H90'/>");
  EXPECT_EQ(strokes(drawing).size(), 1U);
  EXPECT_EQ(drawing.drawing.document.fill_count(), 0U);
  std::int64_t count = 0;
  for (const ImportNotice& n : drawing.report.notices()) {
    if (n.what.find("neither a line nor a fill") != std::string::npos) count += n.count;
  }
  EXPECT_EQ(count, 5) << notice_lines(drawing);
  EXPECT_THAT(notice_lines(drawing), HasSubstr("line 2: path has neither a line nor a fill"));
}

// A frame may leave only an edge of a shape. Such a fill would be lost when its file is read again.
TEST(SvgUnpainted, FillOfWhichOnlyAnEdgeIsInItsFrameIsNamed) {
  const Imported drawing = read(
      "<svg width='9' height='9'>"
      "<rect y='9' width='9' height='9'/><rect x='-9' width='9' height='9'/>"
      "<path d='M9 0h9v9z'/></svg>");
  EXPECT_EQ(drawing.drawing.document.fill_count(), 0U);
  EXPECT_THAT(notice_lines(drawing), HasSubstr("rect is outside the frame"));
  EXPECT_THAT(notice_lines(drawing), HasSubstr("(and 2 more like it)"));
}

TEST(SvgUnpainted, FrameWithALineOfNoWidthIsCounted) {
  EXPECT_THAT(notice_lines(read("<rect fill='none' stroke='red' stroke-width='0' width='9' "
                                "height='5'/>")),
              HasSubstr("neither a line nor a fill"));
}

TEST(SvgUnpainted, FramesOfIconsAreNotNamed) {
  for (const char* frame :
       {"<path d='M0 0h24v24H0z' fill='none'/>",
        "<path stroke='none' d='M0 0h24v24H0z' fill='none'/>",
        "<path d='M0 0h24v24H0V0z' fill='none'/>", "<rect fill='none' width='24' height='24'/>",
        "<path d='M.1.1h23.3v23.3H.1z' fill='none'/>", "<path d='M24 24H0V0h24v24z' fill='none'/>",
        "<path d='M0 0h24v24H0V0zm0 0h24v24H0V0z' fill='none'/>",
        "<path d='M0 0h24M24 24H0' fill='none'/>", "<path fill='none' d='M5 5'/>",
        "<path fill='none' d=''/>", "<rect fill='none' width='0' height='24'/>",
        "<defs><path fill='none' d='M0 0h9'/></defs>",
        "<clipPath id='c'><path fill='none' d='M0 0h9'/></clipPath>"}) {
    const Imported drawing = read(frame + std::string("<path d='M1 1h9v9z'/>"));
    EXPECT_THAT(notice_lines(drawing), IsEmpty()) << frame;
  }
}

TEST(SvgUnpainted, ShapesThatAreNoFramesAreNamed) {
  for (const char* shape :
       {"<path d='M0 0h24v24H0' fill='none'/>", "<path d='M0 0L24 24' fill='none'/>",
        "<path d='M0 0h24v24z' fill='none'/>", "<rect fill='none' rx='4' width='24' height='24'/>",
        "<path d='M0 12h24M12 0v24' fill='none'/>",
        "<path d='M0 0L24 24L24 0L0 24z' fill='none'/>"}) {
    EXPECT_THAT(notice_lines(read(shape)), HasSubstr("neither a line nor a fill")) << shape;
  }
}

TEST(SvgUnpainted, ShapesThatAreHiddenAreNamedOnce) {
  const std::string text = notice_lines(read("<path fill='none' visibility='hidden' d='M0 0h9'/>"));
  EXPECT_THAT(text, HasSubstr("is hidden in the file"));
  EXPECT_THAT(text, Not(HasSubstr("neither a line")));
}

TEST(SvgScripts, AreNotCalledAnimations) {
  const std::string text =
      notice_lines(read("<script>a()</script><path d='M1 1h9v9z'><script/></path>"));
  EXPECT_THAT(text, HasSubstr("script was skipped: scripts are not run (and 1 more like it)"));
  EXPECT_THAT(text, Not(HasSubstr("animation")));
  EXPECT_THAT(notice_lines(read("<path d='M1 1h9v9z'><set/></path>")),
              HasSubstr("animation is not supported"));
}

}  // namespace
}  // namespace felt::svg_cases_test
