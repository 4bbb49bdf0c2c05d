// Transparent groups, rotated frames, stretched lines, dashes without gaps, and files without a
// size.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "felt/io/svg/svg_frame.h"
#include "felt/io/svg/svg_import.h"
#include "felt/io/svg/svg_ink.h"
#include "felt/io/testing/import_checks.h"
#include "felt/render/page_painter.h"

namespace felt::svg_groups_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::notice_lines;

/// Reads a document with user units of one millimetre.
Imported read(const std::string& inside) {
  return import_svg(
             "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
             "width='100mm' height='80mm' viewBox='0 0 100 80'>\n" +
             inside + "</svg>")
      .value();
}

Image picture_of(const Imported& imported) {
  return render_page(imported.drawing.document,
                     {.dpi = 25.4, .area = Rect{0, 0, 100, 80}, .paper = {0, 0, 0, 0}},
                     PictureChoice::kMarked)
      .value();
}

std::vector<double> opacities(const Imported& imported) {
  std::vector<double> found;
  for (const Layer& layer : imported.drawing.document.layers()) found.push_back(layer.opacity);
  return found;
}

constexpr const char* kTwoRects =
    "<rect x='10' y='10' width='30' height='30' fill='#f00'/>"
    "<rect x='20' y='20' width='30' height='30' fill='#00f'/>";

TEST(SvgGroups, PartsOfATransparentGroupDoNotShowThrough) {
  const Imported imported =
      read("<g opacity='.5'>" + std::string(kTwoRects) + "</g><path d='M60 60h20v10z'/>");
  EXPECT_THAT(notice_lines(imported), IsEmpty());
  const Image picture = picture_of(imported);
  EXPECT_EQ(picture.at(30, 30), (Rgba{0, 0, 128, 128}));
  EXPECT_EQ(picture.at(15, 15), (Rgba{128, 0, 0, 128}));
  EXPECT_EQ(picture.at(77, 63).a, 255) << "what follows is not transparent";
  EXPECT_THAT(opacities(imported), ::testing::ElementsAre(0.5, 1.0));
}

TEST(SvgGroups, PartsThatDoNotOverlapNeedNoLayer) {
  const Imported imported = read(
      "<rect width='5' height='5' y='70'/><g opacity='.5'><rect width='9' height='9' "
      "fill='#f00'/><rect x='20' width='9' height='9' fill='#00f' fill-opacity='.5'/></g>");
  EXPECT_THAT(opacities(imported), ::testing::ElementsAre(1.0));
  EXPECT_EQ(picture_of(imported).at(4, 4).a, 128);
  EXPECT_EQ(picture_of(imported).at(25, 4).a, 64);
}

// The shapes of a group wait until it ends. They have views into the file, which is freed before
// the drawing is taken: AddressSanitizer found that.
TEST(SvgGroups, AGroupAtTheEndOfTheFileIsReadBeforeTheFileIsFreed) {
  const std::string id(300, 'n');
  const Imported imported = read("<g opacity='.5'><svg width='9' height='9'><path id='" + id +
                                 "' d='M50 50h9' stroke='#000' fill='none'/></svg></g>");
  EXPECT_THAT(notice_lines(imported), HasSubstr("path '" + id.substr(0, 100)));
}

TEST(SvgGroups, AFillAndItsLineAreTransparentTogether) {
  const Imported imported = read(
      "<rect x='20' y='20' width='40' height='40' fill='#f00' stroke='#00f' stroke-width='8' "
      "opacity='.5'/>");
  EXPECT_EQ(picture_of(imported).at(22, 40), (Rgba{0, 0, 128, 128}));
}

TEST(SvgGroups, AGroupInAGroupIsReported) {
  const Imported imported =
      read("<g opacity='.5'><g opacity='.5'>" + std::string(kTwoRects) + "</g></g>");
  EXPECT_THAT(notice_lines(imported), HasSubstr("transparent inside a transparent group"));
  EXPECT_NEAR(picture_of(imported).at(15, 15).a, 64, 1);
}

TEST(SvgGroups, ManyGroupsEndWithANotice) {
  std::string text;
  for (int i = 0; i < SvgInk::kMaxCoverLayers + 20; ++i)
    text += "<g opacity='.5'>" + std::string(kTwoRects) + "</g>";
  const Imported imported = read(text);
  EXPECT_THAT(notice_lines(imported), HasSubstr("is in a transparent group"));
  EXPECT_LE(imported.drawing.document.layers().size(), 500U);
}

TEST(SvgGroups, ManyBlendedGroupsEndWithANotice) {
  std::string text;
  for (int i = 0; i < 230; ++i) {
    text += "<g style='mix-blend-mode:multiply' opacity='.5'>" + std::string(kTwoRects) + "</g>";
  }
  const Imported imported = read(text + "<g style='mix-blend-mode:multiply'/>");
  EXPECT_THAT(notice_lines(imported), HasSubstr("more than 200 such groups"));
  const std::span<const Layer> layers = imported.drawing.document.layers();
  EXPECT_EQ(std::count_if(layers.begin(), layers.end(),
                          [](const Layer& l) { return l.blend == BlendMode::kMultiply; }),
            200);
  EXPECT_EQ(imported.drawing.document.fill_count(), 460U);
  EXPECT_EQ(layers.back().opacity, 0.5) << "the other groups are still translucent";
}

TEST(SvgGroups, ARotatedFrameCutsFills) {
  const Imported imported = read(
      "<svg width='100' height='80'><symbol id='s'><rect width='90' height='90'/></symbol>"
      "<use xlink:href='#s' width='30' height='30' transform='translate(40 10) "
      "rotate(45)'/></svg>");
  EXPECT_THAT(notice_lines(imported), Not(HasSubstr("frame, which was ignored")));
  const Image picture = picture_of(imported);
  EXPECT_EQ(picture.at(40, 30).a, 255);
  EXPECT_EQ(picture.at(40, 55).a, 0) << "below the corner of the frame";
  EXPECT_EQ(picture.at(58, 50).a, 0);
}

TEST(SvgGroups, FramesHaveABoundedNumberOfEdges) {
  SvgFrame frame(Rect{0, 0, 10, 10});
  int cuts = 0;
  for (int i = 1; i < 60; ++i) {
    cuts += frame.cut({-5, -5, 15, 15}, rotation(0.02 * i, {5.0, 5.0})) ? 1 : 0;
  }
  EXPECT_LE(frame.planes().size(), SvgFrame::kMaxPlanes);
  EXPECT_EQ(cuts, 15);
  EXPECT_TRUE(frame.contains({4, 4, 6, 6}, 0.0));
  EXPECT_TRUE(frame.misses({11, 4, 12, 6}));
}

TEST(SvgGroups, AStretchedStraightLineKeepsItsFlatEnds) {
  const Imported imported = read(
      "<path d='M10 40h60' stroke='#000' stroke-width='20' transform='skewX(30)' fill='none'/>");
  EXPECT_THAT(notice_lines(imported), IsEmpty());
  const Image picture = picture_of(imported);
  // The left end goes from (10 + 30 tan 30, 30) to (10 + 50 tan 30, 50).
  EXPECT_EQ(picture.at(30, 31).a, 255);
  EXPECT_EQ(picture.at(25, 31).a, 0);
  EXPECT_EQ(picture.at(41, 48).a, 255);
  EXPECT_EQ(picture.at(35, 48).a, 0);
}

TEST(SvgGroups, DashesWithoutGapsLeaveTheirCornersOpen) {
  const std::string path = "<path d='M20 20h40v40' fill='none' stroke='#000' stroke-width='10' ";
  const auto corner = [&](const char* dashes) {
    return picture_of(read(path + dashes + "/>")).at(63, 17).a;
  };
  EXPECT_EQ(corner("stroke-dasharray='20 0'"), 0);
  EXPECT_EQ(corner("stroke-dasharray='30 0'"), 255);
  EXPECT_EQ(corner(""), 255);
  const Imported joined = read(path + "stroke-dasharray='20 0'/>");
  EXPECT_EQ(joined.drawing.document.stroke_count(), 2U) << "one stroke for each side";
}

TEST(SvgGroups, FilesWithoutASize) {
  const Imported none = import_svg(
                            "<svg xmlns='http://www.w3.org/2000/svg'><rect x='96' y='96' "
                            "width='96' height='192'/></svg>")
                            .value();
  ASSERT_TRUE(none.drawing.has_page);
  EXPECT_NEAR(none.drawing.page.width_mm, 50.8, 1e-9);
  EXPECT_NEAR(none.drawing.page.height_mm, 76.2, 1e-9);
  for (const char* size : {"width='0' height='9'", "height='0mm'"}) {
    const Imported zero = import_svg("<svg xmlns='http://www.w3.org/2000/svg' " +
                                     std::string(size) + "><rect width='9' height='9'/></svg>")
                              .value();
    EXPECT_EQ(zero.drawing.document.fill_count(), 0U);
    EXPECT_THAT(notice_lines(zero), HasSubstr("nothing of it is visible"));
  }
}

TEST(SvgGroups, IccColorsCountOnlyWithTheirProfile) {
  const std::string rect = "<rect width='9' height='9' fill='#f00 icc-color(p, 1)'/>";
  const Imported without = read(rect);
  EXPECT_EQ(picture_of(without).at(4, 4), (Rgba{0, 0, 0, 255})) << "as in browsers";
  EXPECT_THAT(notice_lines(without), HasSubstr("fill that could not be read"));
  const Imported with = read("<defs><color-profile name='p'/></defs>" + rect);
  EXPECT_EQ(picture_of(with).at(4, 4), (Rgba{255, 0, 0, 255})) << "as Inkscape writes it";
  EXPECT_THAT(notice_lines(with), IsEmpty());
}

TEST(SvgGroups, AShapeWithManyEdgesIsConverted) {
  // A non-zero outline with 6000 edges whose two halves overlap.
  std::string path = "M10 10";
  for (int i = 0; i < 6000; ++i) {
    path += "L" + std::to_string(10 + 0.01 * i) + " " + std::to_string(i % 2 == 0 ? 10 : 10.02);
  }
  path += "L70 60L40 60L40 5L60 5L60 50L10 50Z";
  const Imported imported = read("<path d='" + path + "'/>");
  EXPECT_THAT(notice_lines(imported), IsEmpty());
  EXPECT_EQ(picture_of(imported).at(50, 30), (Rgba{0, 0, 0, 255})) << "covered twice";
}

}  // namespace
}  // namespace felt::svg_groups_test
