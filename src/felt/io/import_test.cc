#include "felt/io/import.h"

#include <gtest/gtest.h>

namespace felt::import_test {
namespace {

TEST(ImportReport, TheSameIsCountedAndTheFirstPlaceKept) {
  ImportReport report;
  report.add(12, "text 'title'", "is not a stroke and was skipped");
  report.add(20, "image", "is a picture and was skipped");
  report.add(40, "text", "is not a stroke and was skipped");
  ASSERT_EQ(report.notices().size(), 2u);
  EXPECT_EQ(notice_text(report.notices()[0]),
            "line 12: text 'title' is not a stroke and was skipped (and 1 more like it)");
  EXPECT_EQ(notice_text(report.notices()[1]), "line 20: image is a picture and was skipped");
  EXPECT_EQ(notice_text({0, "", "a page was left out", 1}), "a page was left out");
}

TEST(ImportReport, IsBoundedWhateverTheFile) {
  ImportReport report;
  for (int k = 0; k < 5000; ++k) {
    const std::string letters{char('a' + k % 26), char('a' + k / 26 % 26), char('a' + k / 676)};
    report.add(k, std::string(100'000, 'x'), "oddity " + letters);
  }
  ASSERT_EQ(report.notices().size(), ImportReport::kMaxKinds);
  EXPECT_EQ(report.notices().back().count, 5000 - 99);
  EXPECT_LE(report.notices().front().element.size(), ImportReport::kMaxElementBytes + 3);
}

TEST(ImportReport, OfAKindThreeAreShownAndTheRestIsCounted) {
  ImportReport report;
  for (int k = 0; k < 66'000; ++k) {
    report.add(k + 1, "stroke",
               "turns by 0." + std::to_string(k) + " degrees at 's1." + std::to_string(k) + "'");
  }
  report.add(7, "stroke", "has no points");
  ASSERT_EQ(report.notices().size(), 4u);
  EXPECT_EQ(notice_text(report.notices()[1]), "line 2: stroke turns by 0.1 degrees at 's1.1'");
  EXPECT_EQ(notice_text(report.notices()[2]),
            "line 3: stroke turns by 0.2 degrees at 's1.2' (and 65997 more like it)");
}

TEST(ImportReport, ANameIsNotCutWithinACharacter) {
  ImportReport report;
  std::string name(ImportReport::kMaxElementBytes - 1, 'x');
  report.add(1, name + "\xc3\xa4\xc3\xa4", "is odd");
  EXPECT_EQ(report.notices()[0].element, name + "...");
}

}  // namespace
}  // namespace felt::import_test
