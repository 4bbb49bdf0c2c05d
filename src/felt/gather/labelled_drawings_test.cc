#include <gtest/gtest.h>

#include <cstdlib>

#include "felt/gather/line_groups.h"
#include "felt/gather/testing/group_score.h"
#include "felt/gather/testing/labelled_drawing.h"

namespace felt::labelled_drawings_test {
namespace {

TEST(GroupScore, IsOneForEqualGroupsAndAboutZeroForOthers) {
  const std::vector<std::uint32_t> labels{0, 0, 1, 1, 2, 2}, renamed{5, 5, 3, 3, 9, 9};
  EXPECT_DOUBLE_EQ(group_score(labels, renamed).rand_index, 1.0);
  // By hand: 1 common pair of 3 and 3; 3 * 3 / 15 are expected.
  const GroupScore score = group_score(labels, std::vector<std::uint32_t>{0, 0, 1, 2, 1, 2});
  EXPECT_DOUBLE_EQ(score.precision, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(score.recall, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(score.rand_index, (1.0 - 0.6) / (3.0 - 0.6));
}

// FELT_ROUGH_DRAWINGS is a folder of .scap files (bench/gather/README.md).
TEST(LabelledDrawings, GroupsAgreeWithTheLabels) {
  const char* folder = std::getenv("FELT_ROUGH_DRAWINGS");
  if (!folder) GTEST_SKIP() << "FELT_ROUGH_DRAWINGS does not name a folder of labelled drawings";
  const auto drawings = read_scap_folder(folder);
  ASSERT_TRUE(drawings) << drawings.error().message;
  double rand_index = 0.0, precision = 0.0;
  for (const LabelledDrawing& drawing : *drawings) {
    const GroupScore score = group_score(drawing.labels, line_groups(drawing.lines).value());
    rand_index += score.rand_index / static_cast<double>(drawings->size());
    precision += score.precision / static_cast<double>(drawings->size());
  }
  EXPECT_GE(rand_index, 0.75);
  EXPECT_GE(precision, 0.93);
}

}  // namespace
}  // namespace felt::labelled_drawings_test
