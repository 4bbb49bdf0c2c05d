#include "text_table.h"

#include <gtest/gtest.h>

namespace felt::cli::text_table_test {
namespace {

TEST(TextTable, ColumnsLineUpAndNumbersStandRight) {
  TextTable table({{"name"}, {"N", TextTable::Align::kRight}, {"what"}});
  table.add_row({"touch", "3.3", "a stylus"});
  table.add_row({"omega", "12.0", "an arm"});
  EXPECT_EQ(table.text({}),
            "name      N  what\n"
            "touch   3.3  a stylus\n"
            "omega  12.0  an arm\n");
}

TEST(TextTable, OnATerminalTheLastColumnWrapsAndNamesAreBold) {
  TextTable table({{"id"}, {"help"}});
  table.add_row({"pencil", "one two three four five six seven"});
  const std::string text = table.text({.is_terminal = true, .emphasis = true, .width = 34});
  EXPECT_EQ(text,
            "\x1b[1mid      help\x1b[0m\n"
            "pencil  one two three four five\n"
            "        six seven\n");
}

TEST(TextTable, InAPipeNothingIsWrappedOrColoured) {
  TextTable table({{"id"}, {"help"}});
  table.add_row({"a", std::string(300, 'x') + " y"});
  const std::string text = table.text({});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
}

TEST(Wrapped, BreaksAtBlanksOnly) {
  EXPECT_EQ(wrapped("a bb ccc dddd", 4, 2), "a bb\n  ccc\n  dddd");
  EXPECT_EQ(wrapped("longerthanthat", 4, 0), "longerthanthat");
  EXPECT_EQ(wrapped("", 4, 0), "");
}

}  // namespace
}  // namespace felt::cli::text_table_test
