#include "felt/formats/file_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace felt::file_format_test {
namespace {

using namespace std::string_literals;

TEST(FileFormat, IsNamedByTheEndingInEitherCase) {
  EXPECT_EQ(format_of_path("a/b.felt").value(), FileFormat::kFelt);
  EXPECT_EQ(format_of_path("A.XOPP").value(), FileFormat::kXopp);
  EXPECT_EQ(format_of_path("lines.jsonl").value(), FileFormat::kNdjson);
  EXPECT_EQ(format_of_path("a.felt/b.png").value(), FileFormat::kPng);
}

TEST(FileFormat, AnotherEndingIsAnErrorThatListsThem) {
  for (const char* path : {"a", "", ".felt", "folder/.felt", "a.doc", "felt", "a.felt/b"}) {
    const auto format = format_of_path(path);
    ASSERT_FALSE(format) << path;
    EXPECT_THAT(format.error().message, ::testing::HasSubstr(".inkml"));
  }
}

TEST(FileFormat, IsShownByTheFirstBytes) {
  EXPECT_EQ(format_of_bytes("SQLite format 3\0more"s), FileFormat::kFelt);
  EXPECT_EQ(format_of_bytes("\x1f\x8b\x08"), FileFormat::kXopp);
  EXPECT_EQ(format_of_bytes("PK\x03\x04"), FileFormat::kXopp);
  EXPECT_EQ(format_of_bytes("%PDF-1.4"), FileFormat::kPdf);
  EXPECT_EQ(format_of_bytes("\x89PNG\r\n\x1a\n"), FileFormat::kPng);
  EXPECT_EQ(format_of_bytes(" \n{\"id\":"), FileFormat::kNdjson);
  EXPECT_EQ(format_of_bytes("\xef\xbb\xbf{"), FileFormat::kNdjson);
  EXPECT_EQ(format_of_bytes("<svg"), FileFormat::kSvg);
  EXPECT_EQ(format_of_bytes("<ink>"), FileFormat::kInkml);
  EXPECT_EQ(format_of_bytes("<xournal version='1'>"), FileFormat::kXopp);
}

TEST(FileFormat, XmlIsKnownByItsFirstElementBehindAllThatMayStandBefore) {
  const char* head =
      "\xef\xbb\xbf<?xml version='1.0'?>\n<!-- <ink> no -->\n"
      "<!DOCTYPE svg:svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'x' [ <!ENTITY a '<ink>'> ]>\n"
      "<s:svg\txmlns:s='http://www.w3.org/2000/svg'>";
  EXPECT_EQ(format_of_bytes(head), FileFormat::kSvg);
  EXPECT_EQ(format_of_bytes("<?xml version='1.0'?><inkml:ink/>"), FileFormat::kInkml);
  std::string little = "\xff\xfe", big = "\xfe\xff";
  for (const char c : std::string("<?xml version='1.0'?><svg>")) {
    little += c;
    little += '\0';
    big += '\0';
    big += c;
  }
  EXPECT_EQ(format_of_bytes(little), FileFormat::kSvg);
  EXPECT_EQ(format_of_bytes(big), FileFormat::kSvg);
}

TEST(FileFormat, WhatShowsNothingIsNothingAndCutsAreNoHarm) {
  for (const char* head : {"", " ", "hello", "<", "<!", "<?", "<!--", "<!DOCTYPE [", "<html>",
                           "[1]", "< svg", "<svgs>", "PK", "%PD"}) {
    EXPECT_EQ(format_of_bytes(head), std::nullopt) << head;
  }
  EXPECT_EQ(format_of_bytes(std::string(5000, ' ')), std::nullopt);
  EXPECT_EQ(format_of_bytes("\xff\xfe<"), std::nullopt);
}

TEST(FileFormat, LinesOfJsonTellWhatTheyHold) {
  EXPECT_EQ(ndjson_content("{\"feltline\":1}\n{\"id\":\"a\",\"points\":[]}"),
            NdjsonContent::kStrokes);
  EXPECT_EQ(ndjson_content("{\"word\":\"cat\",\"drawing\":[[[1],[2]]]}"),
            NdjsonContent::kQuickdraw);
  EXPECT_EQ(ndjson_content("{\"feltline\":1}\n\n{\"t_ms\":0,\"event\":\"undo\"}"),
            NdjsonContent::kEvents);
  EXPECT_EQ(ndjson_content("hello\n{"), NdjsonContent::kStrokes);
}

}  // namespace
}  // namespace felt::file_format_test
