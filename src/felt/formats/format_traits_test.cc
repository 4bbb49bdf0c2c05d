#include "felt/formats/format_traits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "felt/base/read_file.h"
#include "felt/formats/drawing_reader.h"
#include "felt/formats/drawing_writer.h"

namespace felt::format_traits_test {
namespace {

TEST(FormatTraits, EveryRowIsWholeAndNoEndingComesTwice) {
  std::set<std::string_view> seen;
  for (const FormatTraits& row : format_table()) {
    EXPECT_EQ(&traits_of(row.format), &row);
    EXPECT_EQ(row.endings.front(), "." + std::string(row.name));
    EXPECT_FALSE(row.title.empty());
    EXPECT_FALSE(row.widths.empty());
    EXPECT_EQ(row.kept.back(), '.') << row.name;
    EXPECT_TRUE(row.reads || row.writes) << row.name;
    EXPECT_TRUE(!row.lossless || (row.layers && row.page && row.reads && row.writes)) << row.name;
    for (const std::string_view ending : row.endings) EXPECT_TRUE(seen.insert(ending).second);
    for (const std::string_view type : row.media_types) EXPECT_TRUE(seen.insert(type).second);
  }
}

TEST(FormatTraits, NamesAreUnderstoodInEitherCaseAndWithADot) {
  EXPECT_EQ(format_of_name("SVG").value(), FileFormat::kSvg);
  EXPECT_EQ(format_of_name(".jsonl").value(), FileFormat::kNdjson);
  for (const char* name : {"", ".", "doc", "felt "}) {
    const auto format = format_of_name(name);
    ASSERT_FALSE(format) << name;
    EXPECT_THAT(format.error().message, ::testing::HasSubstr("felt, svg"));
  }
}

// Reading and writing agree with the table.
TEST(FormatTraits, WhatIsWrittenAndReadIsWhatTheTableSays) {
  for (const FormatTraits& row : format_table()) {
    const auto bytes = drawing_bytes(Drawing{}, row.format, {.dpi = 10.0});
    ASSERT_EQ(bytes.has_value(), row.writes) << row.name << bytes.error().message;
    if (!row.writes) continue;
    EXPECT_EQ(drawing_bytes(Drawing{}, row.format, {.dpi = 10.0}).value(), *bytes);
    // Lines of no stroke are an empty file.
    if (!bytes->empty()) {
      EXPECT_EQ(format_of_bytes(*bytes), row.format) << row.name;
    }
    const auto read = parse_drawing(*bytes, "x" + std::string(row.endings.front()));
    EXPECT_EQ(read.has_value(), row.reads) << row.name;
    if (!read) {
      EXPECT_THAT(read.error().message, ::testing::HasSubstr("not read"));
    }
  }
}

TEST(FormatTraits, TheDocumentationShowsThisTable) {
  const auto page = read_file("docs/formats/README.md", 1 << 20);
  ASSERT_TRUE(page) << page.error().message;
  EXPECT_THAT(*page, ::testing::HasSubstr(format_table_markdown()));
  for (const FormatTraits& row : format_table()) {
    EXPECT_THAT(*page, ::testing::HasSubstr(std::string(row.kept))) << row.name;
  }
}

}  // namespace
}  // namespace felt::format_traits_test
