#include "felt/io/quickdraw/quickdraw_import.h"

#include <gmock/gmock.h>

#include "felt/io/quickdraw/quickdraw_line.h"
#include "felt/io/testing/test_drawings.h"

namespace felt::quickdraw_import_test {
namespace {

using ::testing::HasSubstr;

std::string parse_error(const std::string& line) {
  LineReader reader(read_text(line));
  LineBatch batch;
  EXPECT_TRUE(reader.fill(batch, line.size()).value());
  QuickdrawParser parser;
  QuickdrawRecord record;
  const Result<void> done = parser.parse(batch.line(0), record);
  return done ? "" : done.error().message;
}

QuickdrawRecord record_of(const std::string& line) {
  LineReader reader(read_text(line));
  LineBatch batch;
  EXPECT_TRUE(reader.fill(batch, line.size()).value());
  QuickdrawParser parser;
  QuickdrawRecord record;
  const Result<void> done = parser.parse(batch.line(0), record);
  EXPECT_TRUE(done) << (done ? "" : done.error().message);
  return record;
}

TEST(QuickdrawLine, SimplifiedAndRaw) {
  const QuickdrawRecord simplified = record_of(
      R"({"word":"cat","countrycode":"VE","timestamp":"2017-03-02 23:25:10.07453 UTC",)"
      R"("recognized":true,"key_id":"5201136883597312","drawing":[[[130,113],[72,40]],[[1],[2]]]})");
  EXPECT_EQ(simplified.word, "cat");
  EXPECT_EQ(simplified.key_id, "5201136883597312");
  ASSERT_EQ(simplified.strokes.size(), 2u);
  EXPECT_EQ(simplified.strokes[0][1], (InkSample{{113, 40}, {}, {}}));
  const QuickdrawRecord raw = record_of(R"({"drawing":[[[500.5,501],[10,20.25],[0,16]]]})");
  EXPECT_EQ(raw.word, "");
  EXPECT_EQ(raw.strokes[0][1], (InkSample{{501, 20.25}, {}, 16'000'000}));
}

TEST(QuickdrawLine, ErrorsNameTheElement) {
  EXPECT_THAT(parse_error(R"({"word":"cat"})"), HasSubstr("key \"drawing\" is missing"));
  EXPECT_THAT(parse_error(R"({"drawing":[]})"), HasSubstr("contains no stroke"));
  EXPECT_THAT(parse_error(R"({"drawing":[[[1,2],[3]]]})"),
              HasSubstr("drawing[0]: a stroke needs equal numbers of"));
  EXPECT_THAT(parse_error(R"({"drawing":[[[1],[3],[]]]})"),
              HasSubstr("equal numbers of x, y and t"));
  EXPECT_THAT(parse_error(R"({"drawing":[[[],[]]]})"),
              HasSubstr("drawing[0]: a stroke needs at least one point"));
  EXPECT_THAT(parse_error(R"({"drawing":[[[1],["a"]]]})"), HasSubstr("drawing[0]: y[0]: "));
  EXPECT_THAT(parse_error(R"({"drawing":[[[1],[2]],7]})"),
              HasSubstr("drawing[1]: 7 is not an array"));
  EXPECT_THAT(parse_error(R"({"drawing":3})"), HasSubstr("drawing: 3 is not an array"));
  EXPECT_THAT(parse_error(R"({"word":3,"drawing":[[[1],[2]]]})"),
              HasSubstr("word: 3 is not a string"));
}

TEST(QuickdrawLine, NumbersAtTheirLimits) {
  const auto fits = [](const std::string& x) {
    return parse_error(R"({"drawing":[[[)" + x + R"(],[0]]]})").empty();
  };
  EXPECT_TRUE(fits("999999999"));
  EXPECT_TRUE(fits("1000000000"));
  EXPECT_FALSE(fits("1000000001"));
}

TEST(QuickdrawLine, Looks) {
  EXPECT_TRUE(looks_like_quickdraw(R"({"word":"a","drawing":[[[1],[2]]]})"));
  EXPECT_FALSE(looks_like_quickdraw(R"({"id":"drawing","points":[[1,2]]})"));
  EXPECT_FALSE(looks_like_quickdraw(R"({"drawing":1,"points":[[1,2]]})"));
}

TEST(QuickdrawLine, LinesOfSimplifiedStrokesGetPointsOnThem) {
  std::vector<InkSample> line = {{{0, 0}, {}, {}}, {{3, 4}, {}, {}}, {{3, 4}, {}, {}}};
  restore_simplified(line);
  ASSERT_EQ(line.size(), 5u);
  EXPECT_NEAR(distance(line[1].position, {0.6, 0.8}), 0.0, 1e-12);
  EXPECT_NEAR(distance(line[2].position, {2.4, 3.2}), 0.0, 1e-12);
  std::vector<InkSample> longest = {{{0, 0}, {}, {}}, {{255, 255}, {}, {}}};
  restore_simplified(longest);
  for (std::size_t i = 1; i < longest.size(); ++i) {
    EXPECT_LE(distance(longest[i - 1].position, longest[i].position), 16.0);
  }
  std::vector<InkSample> raw = {{{0, 0}, {}, 0}, {{100, 0}, {}, 9}},
                         outside = {{{0, 0}, {}, {}}, {{256, 0}, {}, {}}};
  restore_simplified(raw);
  restore_simplified(outside);
  EXPECT_EQ(raw.size(), 2u);
  EXPECT_EQ(outside.size(), 2u);
  const auto grows = [](std::size_t count) {
    std::vector<InkSample> stroke(count, InkSample{{0, 0}, {}, {}});
    stroke.back().position = {255, 0};
    restore_simplified(stroke);
    return stroke.size() > count;
  };
  EXPECT_TRUE(grows(kMaxSimplifiedPoints - 1));
  EXPECT_TRUE(grows(kMaxSimplifiedPoints));
  EXPECT_FALSE(grows(kMaxSimplifiedPoints + 1));
}

TEST(QuickdrawImport, CornersStayCorners) {
  const Imported d =
      import_quickdraw(R"({"drawing":[[[30,30,225,225,30],[255,110,112,255,255]]]})").value();
  const Stroke s = testing::strokes_in(d.drawing.document, 0)[0];
  int corners = 0;
  for (const JointKind kind : s.data().joints) corners += kind == JointKind::kCorner ? 1 : 0;
  EXPECT_EQ(corners, 3);
}

TEST(QuickdrawImport, OneDrawingInItsSquareAtTwoTenthsOfAMillimetre) {
  const Imported d =
      import_quickdraw(R"({"word":"line","drawing":[[[0,255],[0,0]],[[0,255],[255,255]]]})")
          .value();
  EXPECT_TRUE(d.report.empty());
  ASSERT_EQ(d.drawing.document.layers().size(), 1u);
  EXPECT_EQ(d.drawing.document.layers()[0].name, "line");
  ASSERT_EQ(d.drawing.document.layers()[0].strokes.size(), 2u);
  const Stroke s = testing::strokes_in(d.drawing.document, 0)[1];
  EXPECT_NEAR(distance(s.position(0.0), {4.5, 55.5}), 0.0, 1e-6);
  EXPECT_NEAR(distance(s.position(s.segment_count()), {55.5, 55.5}), 0.0, 1e-6);
  EXPECT_EQ(d.drawing.page.width_mm, 60.0);
  EXPECT_EQ(d.drawing.page.height_mm, 60.0);
}

TEST(QuickdrawImport, RawDrawingsAreScaledIntoTheSquare) {
  const Imported d =
      import_quickdraw(R"({"word":"w","drawing":[[[1000,2000],[500,700],[0,100]]]})").value();
  const Stroke s = testing::strokes_in(d.drawing.document, 0)[0];
  EXPECT_NEAR(distance(s.position(0.0), {4.5, 4.5}), 0.0, 1e-6);
  EXPECT_NEAR(distance(s.position(s.segment_count()), {55.5, 4.5 + 10.2}), 0.0, 1e-6);
}

TEST(QuickdrawImport, AContactSheet) {
  std::string text;
  for (int i = 0; i < 5; ++i) {
    text += R"({"word":"w)" + std::to_string(i) + R"(","drawing":[[[0,255],[0,255]]]})" + "\n";
  }
  text += "nonsense\n{\"drawing\":[[[1],[1]]]}\n";
  const Imported d = import_quickdraw(text).value();
  ASSERT_EQ(d.drawing.document.layers().size(), 6u);
  EXPECT_EQ(d.drawing.document.layers()[5].name, "Drawing 6");
  EXPECT_EQ(d.drawing.page.width_mm, 180.0);
  EXPECT_EQ(d.drawing.page.height_mm, 120.0);
  EXPECT_NEAR(testing::strokes_in(d.drawing.document, 4)[0].position(0).x, 64.5, 1e-6);
  EXPECT_NEAR(testing::strokes_in(d.drawing.document, 4)[0].position(0).y, 64.5, 1e-6);
  ASSERT_EQ(d.report.notices().size(), 1u);
  EXPECT_THAT(notice_text(d.report.notices()[0]),
              HasSubstr("line 6: is not a drawing and was skipped"));
}

TEST(QuickdrawImport, TheNumberOfDrawingsIsLimited) {
  const auto import = [](int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += "{\"drawing\":[[[1],[1]]]}\n";
    return import_quickdraw(text).value();
  };
  EXPECT_EQ(import(kMaxQuickdrawDrawings - 1).drawing.document.layers().size(), 999u);
  EXPECT_TRUE(import(kMaxQuickdrawDrawings).report.empty());
  const Imported above = import(kMaxQuickdrawDrawings + 2);
  EXPECT_EQ(above.drawing.document.layers().size(), 1000u);
  ASSERT_EQ(above.report.notices().size(), 1u);
  EXPECT_EQ(above.report.notices()[0].count, 2);
  EXPECT_LE(above.drawing.page.width_mm, Page::kMaxMm);
}

TEST(QuickdrawImport, NothingIsAnError) {
  EXPECT_EQ(import_quickdraw("").error().message, "contains no drawing");
  EXPECT_THAT(import_quickdraw("\n\n[1]\n").error().message, HasSubstr("contains no drawing: "));
}

}  // namespace
}  // namespace felt::quickdraw_import_test
