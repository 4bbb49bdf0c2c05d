#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "felt/base/atomic_file.h"
#include "felt/base/testing/test_folder.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_reader.h"
#include "felt/formats/drawing_writer.h"
#include "felt/formats/format_traits.h"
#include "felt/formats/testing/random_drawing.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/io/testing/test_drawings.h"
#include "felt/io/unpack.h"

namespace felt::drawing_door_test {
namespace {

using felt::testing::by_value;
using felt::testing::random_drawing;
using felt::testing::strokes_in;
using felt::testing::TestFolder;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class Door : public ::testing::Test {
 protected:
  [[nodiscard]] std::string at(const std::string& name) const { return folder_.at(name); }
  [[nodiscard]] std::string put(const std::string& name, std::string_view bytes) const {
    return folder_.put(name, bytes);
  }

 private:
  TestFolder folder_;
};

std::string message(const Result<Imported>& result) {
  return result ? "" : result.error().message;
}

TEST_F(Door, LosslessFormatsGiveTheSameDrawingBack) {
  for (const FormatTraits& row : format_table()) {
    if (!row.lossless) continue;
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
      Drawing drawing = random_drawing(seed);
      const auto bytes = drawing_bytes(drawing, row.format);
      ASSERT_TRUE(bytes) << row.name << " seed " << seed << ": " << bytes.error().message;
      const auto back = parse_drawing(*bytes, "-");
      ASSERT_TRUE(back) << row.name << " seed " << seed << ": " << message(back);
      EXPECT_EQ(back->drawing.document, drawing.document) << row.name << " seed " << seed;
      EXPECT_EQ(back->drawing.page, drawing.page) << row.name << " seed " << seed;
      EXPECT_TRUE(back->is_exact) << row.name;
      EXPECT_TRUE(back->drawing.has_page) << row.name;
      EXPECT_TRUE(back->report.empty()) << notice_text(back->report.notices().front());
      EXPECT_TRUE(drawing_bytes(back->drawing, row.format).value() == *bytes) << row.name;
    }
  }
}

TEST_F(Door, FormatsWithoutLayersHoldWhatIsSeen) {
  std::uint64_t seed = 1;
  const auto hides_some = [](const Drawing& d) {
    const std::size_t seen = visible_strokes(d.document).size();
    return seen > 0 && seen < d.document.stroke_count();
  };
  while (!hides_some(random_drawing(seed))) ++seed;
  const Drawing drawing = random_drawing(seed);
  const auto seen = by_value(visible_strokes(drawing.document));
  const auto bytes = drawing_bytes(drawing, FileFormat::kNdjson);
  const auto back = parse_drawing(*bytes, "a.ndjson");
  ASSERT_TRUE(back) << message(back);
  EXPECT_EQ(strokes_in(back->drawing.document), seen);
  EXPECT_EQ(back->drawing.document.layers().size(), 1u);
  EXPECT_FALSE(back->drawing.has_page);
}

TEST_F(Door, TheContentIsBelievedAndAWrongNameTold) {
  const Drawing drawing = random_drawing(5);
  const auto felt = drawing_bytes(drawing, FileFormat::kFelt);
  const auto opened = read_drawing(put("a.svg", *felt));
  ASSERT_TRUE(opened) << message(opened);
  EXPECT_EQ(opened->format, FileFormat::kFelt);
  EXPECT_EQ(opened->drawing, drawing);
  ASSERT_EQ(opened->report.notices().size(), 1u);
  EXPECT_EQ(
      notice_text(opened->report.notices()[0]),
      "the name says SVG drawing, but the content is a Feltline drawing and was read as such");
  EXPECT_TRUE(read_drawing(put("no ending", *felt))->report.empty());
}

TEST_F(Door, RawSamplesBecomeInkAndBadLinesNotices) {
  const auto opened = parse_drawing(
      "{\"id\":\"a\",\"points\":[[0,0],[5,5],[9,5]]}\nhello\n{\"points\":[[1,2],[NaN,3]]}\nhello\n",
      "x.ndjson");
  ASSERT_TRUE(opened) << message(opened);
  EXPECT_EQ(opened->drawing.document.stroke_count(), 1u);
  ASSERT_EQ(opened->report.notices().size(), 2u);
  EXPECT_THAT(notice_text(opened->report.notices()[0]),
              StartsWith("line 2: was skipped: not a JSON object"));
  EXPECT_EQ(opened->report.notices()[0].count, 2);
  EXPECT_THAT(message(parse_drawing("hello\n", "x.ndjson")), StartsWith("line 1: was skipped"));
  EXPECT_THAT(message(parse_drawing("{\"t_ms\":0,\"event\":\"undo\"}\n", "x.ndjson")),
              HasSubstr("feltline replay"));
}

TEST_F(Door, WhatCannotBeReadSaysWhy) {
  EXPECT_THAT(message(read_drawing(at("none.felt"))), StartsWith(at("none.felt") + ": "));
  EXPECT_THAT(message(read_drawing(at(""))), HasSubstr("folder"));
  EXPECT_THAT(message(read_drawing(put("a", "hello"))),
              HasSubstr("is not a drawing that Feltline"));
  EXPECT_THAT(message(read_drawing(put("b", ""))), HasSubstr("is empty"));
  EXPECT_THAT(message(read_drawing(put("a.pdf", "%PDF-1.4"))), HasSubstr("write but not read"));
  EXPECT_THAT(message(read_drawing(put("a.felt", "%PDF-1.4"))), HasSubstr("PDF"));
  EXPECT_THAT(message(read_drawing(put("cut.felt", "SQLite"))), HasSubstr("incomplete"));
  ASSERT_EQ(::mkfifo(at("pipe.svg").c_str(), 0600), 0);
  EXPECT_THAT(message(read_drawing(at("pipe.svg"), {.files_only = true})),
              HasSubstr("not a regular"));
  EXPECT_THAT(message(read_drawing("/dev/zero", {.files_only = true})), HasSubstr("not a regular"));
}

TEST_F(Door, WritesWholeOrNotAtAllAndSaysWhere) {
  const Drawing drawing = random_drawing(2);
  for (const FormatTraits& row : format_table()) {
    if (!row.writes) continue;
    const std::string path = at("a" + std::string(row.endings.front()));
    ASSERT_TRUE(write_drawing(path, drawing, row.format, {.dpi = 20.0}));
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    EXPECT_TRUE(bytes == drawing_bytes(drawing, row.format, {.dpi = 20.0}).value()) << row.name;
    const std::string nowhere = at("no/a" + std::string(row.endings.front()));
    const auto failed = write_drawing(nowhere, drawing, row.format, {.dpi = 20.0});
    ASSERT_FALSE(failed);
    EXPECT_THAT(failed.error().message, HasSubstr(nowhere));
  }
  const auto huge = write_drawing(at("a.png"), drawing, FileFormat::kPng, {.dpi = 48000.0});
  ASSERT_FALSE(huge);
  EXPECT_THAT(huge.error().message, StartsWith(at("a.png")));
}

TEST_F(Door, AnSvgzIsReallyCompressed) {
  const Drawing drawing = random_drawing(3);
  ASSERT_TRUE(write_drawing(at("a.SVGZ"), drawing, FileFormat::kSvg));
  std::ifstream file(at("a.SVGZ"), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_TRUE(is_gzip(bytes));
  const auto back = read_drawing(at("a.SVGZ"));
  ASSERT_TRUE(back) << message(back);
  EXPECT_EQ(back->drawing.document, drawing.document);
}

}  // namespace
}  // namespace felt::drawing_door_test
