#include "felt/solid/gap_search.h"

#include <gtest/gtest.h>

#include "felt/solid/testing/solid_drawings.h"

namespace felt::gap_search_test {
namespace {

/// A square whose outline has a gap at its first corner.
void open_square(testing::SolidDrawing& drawing, Point at, double side_mm, double gap_mm) {
  drawing.polyline({{at.x + gap_mm, at.y},
                    {at.x + side_mm, at.y},
                    {at.x + side_mm, at.y + side_mm},
                    {at.x, at.y + side_mm},
                    at});
}

TEST(GapSearch, TheSmallestGapThatClosesMostOfTheDrawing) {
  for (const double gap_mm : {1.0, 3.0, 6.0}) {
    testing::SolidDrawing drawing;
    drawing.circle({150, 30}, 8.0);
    EXPECT_EQ(automatic_gap_mm(drawing.document), 2.0);
    open_square(drawing, {10, 10}, 60.0, gap_mm);
    EXPECT_EQ(automatic_gap_mm(drawing.document), gap_mm < 2.0 ? 2.0 : gap_mm < 4.0 ? 4.0 : 8.0);
  }
}

TEST(GapSearch, SmallPartsDoNotWidenIt) {
  testing::SolidDrawing drawing;
  drawing.circle({150, 80}, 60.0);
  open_square(drawing, {10, 10}, 20.0, 6.0);
  EXPECT_EQ(automatic_gap_mm(drawing.document), 2.0);
}

TEST(GapSearch, WithoutAnOutlineItSaysWhatWouldCloseOne) {
  testing::SolidDrawing drawing;
  open_square(drawing, {10, 10}, 60.0, 14.0);
  EXPECT_EQ(automatic_gap_mm(drawing.document), 2.0);
  EXPECT_EQ(enclosed_area_mm2(drawing.document, 2.0), 0.0);
  EXPECT_EQ(wider_gap_mm(drawing.document, 2.0, 0.0), 16.0);
  EXPECT_NEAR(enclosed_area_mm2(drawing.document, 16.0), 3600.0, 10.0);
}

TEST(GapSearch, EndsWhenItIsCancelled) {
  testing::SolidDrawing drawing;
  open_square(drawing, {10, 10}, 60.0, 6.0);
  const std::atomic<bool> is_cancelled{true};
  EXPECT_EQ(automatic_gap_mm(drawing.document, is_cancelled), 2.0);
}

}  // namespace
}  // namespace felt::gap_search_test
