#include "felt/base/csv_value.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "felt/base/testing/csv_rows.h"

namespace felt::csv_value_test {
namespace {

using testing::csv_rows;

RC_GTEST_PROP(CsvValue, ComesBack, (std::string value)) {
  std::string line = "a,";
  append_csv_value(line, value);
  const std::string shown = spreadsheet_text(value);
  RC_ASSERT(csv_rows(line + "\n") == (std::vector<std::vector<std::string>>{{"a", shown}}));
  RC_ASSERT(shown == value || shown == "'" + value);
}

TEST(CsvValue, HoldsNothingThatASpreadsheetComputes) {
  for (const char* value : {"=1+1", "-2-3", "+1", "@SUM(A1)", "\t=1", "\r=1", "\n=1", "-", "-1e",
                            "--1", "-inf", "=", "-2 mm"}) {
    EXPECT_EQ(spreadsheet_text(value), std::string("'") + value);
  }
  for (const char* value : {"", "-2", "-0.25", "-1e-05", "1-2", "a=b", "'=1", "free"}) {
    EXPECT_EQ(spreadsheet_text(value), value);
  }
}

}  // namespace
}  // namespace felt::csv_value_test
