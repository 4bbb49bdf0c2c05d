#include "felt/io/ndjson/ndjson_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

namespace felt::ndjson_lines_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Returns lines as "number:text", or "number!" for a line that was too long.
std::vector<std::string> lines_of(LineReader& reader, std::size_t enough_bytes) {
  std::vector<std::string> lines;
  LineBatch batch;
  while (reader.fill(batch, enough_bytes).value_or(false)) {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const NdjsonLine line = batch.line(i);
      lines.push_back(std::to_string(line.number()) + (line.too_long() ? "!" : ":") +
                      std::string(line.text()));
    }
  }
  return lines;
}

std::vector<std::string> lines_of(std::string_view text, std::size_t max_line_bytes = 100) {
  LineReader reader(read_text(text), max_line_bytes);
  return lines_of(reader, 1);
}

/// A source that returns `step` bytes at a time.
ReadBytes read_slowly(std::string_view text, std::size_t step) {
  return [read = read_text(text), step](std::span<char> into) {
    return read(into.first(std::min(step, into.size())));
  };
}

TEST(LineReader, SplitsAtAnyTerminator) {
  EXPECT_THAT(lines_of("a\nbc\r\nd"), ElementsAre("1:a", "2:bc", "3:d"));
  EXPECT_THAT(lines_of("a\nbc\n"), ElementsAre("1:a", "2:bc"));
}

TEST(LineReader, CountsBlankLinesWithoutDeliveringThem) {
  EXPECT_THAT(lines_of("\n \t\r\na\n\nb\n\n"), ElementsAre("3:a", "5:b"));
}

TEST(LineReader, EmptyInputHasNoLines) {
  EXPECT_THAT(lines_of(""), IsEmpty());
  EXPECT_THAT(lines_of("\n\n"), IsEmpty());
  EXPECT_THAT(lines_of("\xEF\xBB\xBF"), IsEmpty());
}

TEST(LineReader, DropsAByteOrderMarkAtTheStartOnly) {
  EXPECT_THAT(lines_of("\xEF\xBB\xBF"
                       "a\n\xEF\xBB\xBF"
                       "b"),
              ElementsAre("1:a",
                          "2:\xEF\xBB\xBF"
                          "b"));
}

TEST(LineReader, KeepsNulBytes) {
  using namespace std::string_literals;
  EXPECT_THAT(lines_of("a\0b\nc"s), ElementsAre("1:a\0b"s, "2:c"));
}

TEST(LineReader, LongestLineAtBelowAndAboveTheLimit) {
  EXPECT_THAT(lines_of("123\n1234\n12345\n1", 4), ElementsAre("1:123", "2:1234", "3!", "4:1"));
  EXPECT_THAT(lines_of("1234\r\n12345\r\n", 4), ElementsAre("1:1234", "2!"));
  EXPECT_THAT(lines_of("a\n12345", 4), ElementsAre("1:a", "2!"));
}

TEST(LineReader, ALongLineIsNotKept) {
  const std::string text = std::string(3'000'000, 'x') + "\na\n";
  LineReader reader(read_text(text), 1000);
  LineBatch batch;
  ASSERT_TRUE(reader.fill(batch, 1));
  ASSERT_EQ(batch.size(), 2U);
  EXPECT_TRUE(batch.line(0).too_long());
  EXPECT_EQ(batch.bytes(), 1 + kLinePadding);
}

TEST(LineReader, DeliversTheLinesBeforeAnError) {
  int calls = 0;
  LineReader reader([&calls](std::span<char> into) -> Result<std::size_t> {
    if (++calls > 1) return fail(ErrorCode::kIo, "broken");
    return read_text("a\nb\ncut o")(into);
  });
  LineBatch batch;
  ASSERT_EQ(reader.fill(batch, 1000).value(), true);
  EXPECT_EQ(batch.size(), 2U);
  EXPECT_EQ(reader.fill(batch, 1000).error().message, "broken");
  EXPECT_EQ(reader.fill(batch, 1000).error().message, "broken") << "an error is final";
}

TEST(LineReader, ABatchEndsOnceItIsFull) {
  LineReader reader(read_text("aaaa\nbbbb\ncccc\n"));
  LineBatch batch;
  ASSERT_EQ(reader.fill(batch, 5).value(), true);
  EXPECT_EQ(batch.size(), 2U);
  ASSERT_EQ(reader.fill(batch, 5).value(), true);
  EXPECT_EQ(batch.size(), 1U);
  EXPECT_EQ(reader.fill(batch, 5).value(), false);
}

TEST(LineReader, ReportsAClosedDescriptor) {
  LineReader reader(read_descriptor(-1));
  LineBatch batch;
  EXPECT_EQ(reader.fill(batch, 1).error().code, ErrorCode::kIo);
}

RC_GTEST_PROP(LineReaderProperty, NeitherBlocksNorBatchesShow, ()) {
  const auto text = *rc::gen::container<std::string>(rc::gen::element('a', 'b', '\n', '\r', ' '));
  const auto step = *rc::gen::inRange<std::size_t>(1, 5);
  const auto enough = *rc::gen::inRange<std::size_t>(1, 20);
  LineReader slow(read_slowly(text, step), 3);
  RC_ASSERT(lines_of(slow, enough) == lines_of(text, 3));
}

}  // namespace
}  // namespace felt::ndjson_lines_test
