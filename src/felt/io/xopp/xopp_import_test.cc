#include "felt/io/xopp/xopp_import.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "felt/base/read_file.h"
#include "felt/io/testing/import_checks.h"
#include "felt/io/testing/test_drawings.h"
#include "felt/io/unpack.h"
#include "felt/material/materials.h"

namespace felt::xopp_import_test {
namespace {

using testing::only_stroke;
using testing::texts;

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string document(const std::string& inside) {
  return "<?xml version=\"1.0\" standalone=\"no\"?>\n<xournal creator=\"test\" "
         "fileversion=\"4\">\n" +
         inside + "</xournal>\n";
}

std::string page(const std::string& strokes, const std::string& width = "720") {
  return document("<page width=\"" + width +
                  "\" height=\"360\">\n<background type=\"solid\" color=\"#ffffffff\" "
                  "style=\"plain\"/>\n<layer>\n" +
                  strokes + "</layer>\n</page>\n");
}

Imported read(const std::string& text) {
  Result<Imported> drawing = import_xopp(text);
  EXPECT_TRUE(drawing) << (drawing ? "" : drawing.error().message);
  return drawing.value();
}

TEST(XoppImport, PointsBecomeMillimetres) {
  const Imported d = read(
      page("<stroke tool=\"pen\" color=\"#102030ff\" width=\"7.2\">72 144 360 144</stroke>\n"));
  EXPECT_THAT(texts(d.report), IsEmpty());
  const Stroke s = only_stroke(d);
  EXPECT_EQ(s.segment_count(), 1);
  EXPECT_NEAR(distance(s.position(0.0), {25.4, 50.8}), 0.0, 1e-9);
  EXPECT_NEAR(distance(s.position(1.0), {127.0, 50.8}), 0.0, 1e-9);
  EXPECT_NEAR(s.width_mm(0.5), 2.54, 1e-9);
  EXPECT_EQ(s.color(), (Rgba{0x10, 0x20, 0x30, 255}));
  ASSERT_TRUE(d.drawing.has_page);
  EXPECT_NEAR(d.drawing.page.width_mm, 254.0, 1e-9);
  EXPECT_NEAR(d.drawing.page.height_mm, 127.0, 1e-9);
  EXPECT_EQ(d.drawing.page.paper, (Rgba{255, 255, 255, 255}));
  EXPECT_EQ(d.drawing.document.layers()[0].name, "Layer 1");
}

TEST(XoppImport, WidthsOfPiecesGoThroughTheMiddleOfEachStep) {
  const Imported d = read(page(
      "<stroke tool=\"pen\" color=\"black\" width=\"9 1 2 3\">0 0 100 0 200 0 300 0</stroke>\n"));
  const Stroke s = only_stroke(d);
  ASSERT_EQ(s.segment_count(), 3);
  const double pt = kMmPerPoint;
  EXPECT_NEAR(s.width_mm(0.0), 1.0 * pt, 1e-9);
  EXPECT_NEAR(s.width_mm(1.0), 1.5 * pt, 1e-9);
  EXPECT_NEAR(s.width_mm(2.0), 2.5 * pt, 1e-9);
  EXPECT_NEAR(s.width_mm(3.0), 3.0 * pt, 1e-9);
}

TEST(XoppImport, SmallPiecesAreFitted) {
  std::string points;
  for (int i = 0; i <= 400; ++i) {
    points +=
        std::to_string(100 + 0.5 * i) + " " + std::to_string(100 + 30 * std::sin(0.03 * i)) + " ";
  }
  const Imported d =
      read(page("<stroke tool=\"pen\" color=\"black\" width=\"1.41\" capStyle=\"round\">" + points +
                "</stroke>"));
  EXPECT_THAT(texts(d.report), IsEmpty());
  EXPECT_LE(only_stroke(d).segment_count(), 20);
}

TEST(XoppImport, ToolsColoursAndStylesThatWeDoNotHaveAreNoticed) {
  const Imported d =
      read(page("<stroke tool=\"highlighter\" color=\"yellow\" width=\"20\">0 0 99 0</stroke>\n"
                "<stroke tool=\"highlighter\" color=\"#ffa15420\" width=\"20\" capStyle=\"butt\">0 "
                "0 99 0</stroke>\n"
                "<stroke tool=\"eraser\" color=\"#ffffffff\" width=\"8.5\">0 0 99 0</stroke>\n"
                "<stroke tool=\"pen\" color=\"blue\" width=\"1\" style=\"dash\" fill=\"128\">0 0 "
                "99 0</stroke>\n"
                "<stroke tool=\"chalk\" color=\"nocolour\" width=\"1\">0 0 99 0</stroke>\n"));
  const std::vector<Stroke> s = testing::strokes_in(d.drawing.document, 0);
  ASSERT_EQ(s.size(), 5u);
  EXPECT_EQ(s[0].color(), (Rgba{255, 255, 0, 0x7f}));
  EXPECT_EQ(s[1].color(), (Rgba{0xff, 0xa1, 0x54, 0x20}));
  EXPECT_EQ(s[2].color(), (Rgba{255, 255, 255, 255}));
  EXPECT_EQ(s[3].color(), (Rgba{0x33, 0x33, 0xcc, 255}));
  EXPECT_EQ(s[4].color(), (Rgba{0, 0, 0, 255}));
  const auto notes = texts(d.report);
  EXPECT_THAT(notes, Contains("line 7: stroke got round ends"));
  EXPECT_THAT(notes,
              Contains("line 8: stroke of the white-out eraser was read as ink of its colour"));
  EXPECT_THAT(notes, Contains("line 9: stroke is no longer dashed"));
  EXPECT_THAT(notes, Contains("line 9: stroke lost the fill of its area"));
  EXPECT_THAT(notes, Contains("line 10: stroke of an unknown tool was read as a pen's"));
  EXPECT_THAT(notes, Contains("line 10: stroke has an unknown colour; black was used"));
}

TEST(XoppImport, WhatIsNoInkIsNamedWithItsLine) {
  const Imported d =
      read(page("<text font=\"Sans\" size=\"12\" x=\"1\" y=\"1\" color=\"#000000ff\">hello</text>\n"
                "<image left=\"0\" top=\"0\">AAAA</image>\n<teximage text=\"x\"/>\n<wobble/>\n"));
  EXPECT_THAT(
      texts(d.report),
      ::testing::ElementsAre("line 6: text is text, not a stroke, and was skipped",
                             "line 7: image is a picture and was skipped (and 1 more like it)",
                             "line 9: wobble is unknown and was skipped"));
}

TEST(XoppImport, PagesLieBelowEachOther) {
  std::string pages;
  for (int i = 1; i <= 3; ++i) {
    pages += "<page width=\"720\" height=\"360\"><background type=\"solid\" color=\"" +
             std::string(i == 3 ? "#112233ff" : "yellow") + "\" style=\"lined\"/><layer/>";
    if (i != 2) {
      pages +=
          "<layer name=\"top\"><stroke tool=\"pen\" color=\"black\" width=\"1\">0 0 99 "
          "0</stroke></layer>";
    }
    pages += "</page>\n";
  }
  const Imported d = read(document(pages));
  ASSERT_EQ(d.drawing.document.layers().size(), 2u);
  EXPECT_EQ(d.drawing.document.layers()[0].name, "Page 1: top");
  EXPECT_EQ(d.drawing.document.layers()[1].name, "Page 3: top");
  EXPECT_NEAR(testing::strokes_in(d.drawing.document, 1)[0].position(0).y, 2 * (127.0 + kPageGapMm),
              1e-9);
  EXPECT_EQ(d.drawing.document.layers()[1].strokes[0].value, 2u);
  EXPECT_NEAR(d.drawing.page.height_mm, 3 * 127.0 + 2 * kPageGapMm, 1e-9);
  EXPECT_EQ(d.drawing.page.paper, (Rgba{0xff, 0xff, 0x80, 255}));
  EXPECT_THAT(
      texts(d.report),
      ::testing::ElementsAre(
          "line 3: background of style 'lined': its lines were skipped (and 2 more like it)",
          "line 5: background has a different colour from the first page; the first page's colour "
          "was used"));
}

TEST(XoppImport, PagesWithoutInkGiveALayerToDrawOn) {
  const std::string empty = "<page width=\"720\" height=\"360\"><layer/></page>";
  EXPECT_EQ(read(document(empty + empty)).drawing.document.layers().size(), 1u);
  EXPECT_EQ(read(document("")).drawing.document.layers().size(), 1u);
}

TEST(XoppImport, DotsAreDabs) {
  const Imported d =
      read(page("<stroke tool=\"pen\" color=\"black\" width=\"2.26\">"
                "200.2 358 200.2 358</stroke>"));
  EXPECT_NEAR(distance(only_stroke(d).position(0.0), {200.2 * kMmPerPoint, 358 * kMmPerPoint}), 0,
              1e-9);
  EXPECT_NEAR(only_stroke(d).width_mm(0.0), 2.26 * kMmPerPoint, 1e-9);
}

TEST(XoppImport, BadNumbersAreNoticedAndTheRestIsKept) {
  const auto notes = [](const std::string& strokes) { return texts(read(page(strokes)).report); };
  EXPECT_THAT(notes("<stroke tool=\"pen\" color=\"black\" width=\"1\">0 0 9 9 x 7</stroke>"),
              Contains(HasSubstr("is not a number; only the points before it were read")));
  EXPECT_THAT(notes("<stroke tool=\"pen\" color=\"black\" width=\"1\">0 0 9 9 1e10 0</stroke>"),
              Contains(HasSubstr("is not a number; only the points before it were read")));
  EXPECT_THAT(notes("<stroke tool=\"pen\" color=\"black\" width=\"1\">0 0 9</stroke>"),
              Contains(HasSubstr("a last point without y")));
  EXPECT_THAT(notes("<stroke tool=\"pen\" color=\"black\" width=\"1\"></stroke>"),
              Contains(HasSubstr("has no points")));
  EXPECT_THAT(notes("<stroke tool=\"pen\" color=\"black\">0 0 9 9</stroke>"),
              Contains(HasSubstr("has no width")));
  EXPECT_THAT(notes("<stroke tool=\"pen\" color=\"black\" width=\"1 2\">0 0 9 9 8 8</stroke>"),
              Contains(HasSubstr("has too few widths")));
  EXPECT_THAT(notes("<stroke tool=\"pen\" color=\"black\" width=\"1 nan 2\">0 0 9 9 8 8</stroke>"),
              Contains(HasSubstr("has widths that are not positive numbers (1)")));
}

TEST(XoppImport, NumbersAtTheirLimits) {
  const auto count = [](const std::string& x) {
    const Imported d =
        read(page("<stroke tool=\"pen\" color=\"black\" width=\"1\">0 0 " + x + " 0</stroke>"));
    return texts(d.report).size();
  };
  EXPECT_EQ(count("999999999"), 0u);
  EXPECT_EQ(count("1000000000"), 0u);
  EXPECT_EQ(count("1000000001"), 1u);
  EXPECT_EQ(count("100." + std::string(59, '0')), 0u);
  EXPECT_EQ(count("100." + std::string(60, '0')), 0u);
  EXPECT_EQ(count("100." + std::string(61, '0')), 1u);
}

TEST(XoppImport, TakesEveryPacking) {
  const std::string text =
      page("<stroke tool=\"pen\" color=\"black\" width=\"1\">0 0 99 0</stroke>");
  EXPECT_EQ(read(text).drawing, read(gzip(text)).drawing);
  EXPECT_FALSE(import_xopp(gzip(gzip(text))));
}

TEST(XoppImport, OtherFilesAreErrors) {
  const auto error = [](std::string_view bytes) { return import_xopp(bytes).error().message; };
  EXPECT_THAT(error("<svg/>"), HasSubstr("not a Xournal++ document: the first element is 'svg'"));
  EXPECT_THAT(error(""), HasSubstr("is not XML"));
  EXPECT_THAT(error("\x1F\x8B"), HasSubstr("is incomplete"));
  EXPECT_THAT(error("PK\x03\x04 and so on"), HasSubstr("is a damaged zip archive"));
}

/// Files written by Xournal++, in the folder "xopp" of FELT_SHARED_FILES.
TEST(XoppImport, RealFiles) {
  const char* variable = std::getenv("FELT_SHARED_FILES");
  const std::filesystem::path folder =
      (variable != nullptr ? std::filesystem::path(variable) : "../shared/data") / "xopp";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  const std::vector<std::pair<const char*, std::size_t>> files = {
      {"load_layers.xopp", 0},
      {"load_pages.xopp", 0},
      {"load_strokes.xopp", 12},
      {"packaged_xopp_layer.xopp", 0},
      {"packaged_xopp_stroke_new.xopp", 1},
      {"packaged_xopp_stroke_old.xopp", 1}};
  for (const auto& [name, strokes] : files) {
    SCOPED_TRACE(name);
    const Imported d = read(read_file((folder / name).string(), 1 << 20).value());
    std::size_t count = 0;
    for (const Layer& layer : d.drawing.document.layers()) count += layer.strokes.size();
    EXPECT_EQ(count, strokes);
  }
}

TEST(XoppImport, LinesAreSolidAndOfExactlyTheirColour) {
  const Stroke s = only_stroke(read(
      page("<stroke tool=\"pen\" color=\"#cc0000ff\" width=\"1.41\">72 144 360 144</stroke>\n")));
  const Medium* medium = find_medium(s.medium());
  ASSERT_TRUE(medium) << s.medium();
  EXPECT_EQ(medium->look.grain, 0.0);
  EXPECT_EQ(medium->look.opacity_light, 1.0);
  EXPECT_EQ(medium->look.opacity_heavy, 1.0);
  EXPECT_EQ(medium->look.rim, 0.0);
  EXPECT_EQ(medium->look.edge, 0.0);
  EXPECT_EQ(s.color(), (Rgba{0xcc, 0, 0, 255}));
}

/// Returns the ink of a line of four points whose pieces have these widths.
Imported line_of_widths(const std::string& widths) {
  return read(page("<stroke tool=\"pen\" color=\"black\" width=\"" + widths +
                   "\">0 0 100 0 200 0 300 0</stroke>\n"));
}

TEST(XoppImport, AWidthThatIsNoneIsThatOfThePieceBesideIt) {
  const double pt = kMmPerPoint;
  const auto width_at = [](const Imported& d, double u) {
    return d.drawing.document.find(d.drawing.document.layers()[0].strokes[0])->width_mm(u);
  };
  for (const char* bad : {"nan", "-1", "0", "inf", "wide", "1e99"}) {
    const Imported last = line_of_widths(std::string("9 1 2 ") + bad);
    ASSERT_EQ(last.report.notices().size(), 1U) << bad;
    EXPECT_THAT(last.report.notices()[0].what, HasSubstr("not positive numbers (1)"));
    EXPECT_NEAR(width_at(last, 1.0), 1.5 * pt, 1e-9);
    EXPECT_NEAR(width_at(last, 3.0), 2.0 * pt, 1e-9);
    EXPECT_NEAR(width_at(line_of_widths(std::string("9 1 ") + bad + " 3"), 1.0), 1.0 * pt, 1e-9);
    EXPECT_NEAR(width_at(line_of_widths(std::string("9 ") + bad + " 2 3"), 0.0), 2.0 * pt, 1e-9);
    const std::string three = std::string(" ") + bad + " " + bad + " " + bad;
    const Imported none = line_of_widths("9" + three);
    ASSERT_EQ(none.report.notices().size(), 1U) << bad;
    EXPECT_THAT(none.report.notices()[0].what, HasSubstr("a single width was used"));
    EXPECT_NEAR(width_at(none, 1.5), 9.0 * pt, 1e-9);
  }
  EXPECT_TRUE(line_of_widths("9 1 2 3").report.empty());
}

TEST(XoppImport, NamesDocumentsAfterTheFirst) {
  const std::string one = page("<stroke tool=\"pen\" color=\"black\" width=\"1\">0 0 9 9</stroke>");
  const std::string two = one + one.substr(one.find("<xournal"));
  EXPECT_TRUE(read(one).report.empty());
  ASSERT_EQ(read(two).report.notices().size(), 1U);
  EXPECT_THAT(read(two).report.notices()[0].what, HasSubstr("documents after it (1)"));
}

}  // namespace
}  // namespace felt::xopp_import_test
