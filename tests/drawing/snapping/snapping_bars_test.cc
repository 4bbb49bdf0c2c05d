#include <gtest/gtest.h>

#include <array>
#include <span>

#include "tests/drawing/snapping/snap_count.h"
#include "tests/support/repeats.h"

namespace felt::snap_test::snapping_bars_test {
namespace {

/// The test runs a part of ./dev bench feel --snapping: with these two hands, or with sanitizers
/// with the first of them.
const std::array kAllHands = {SnapHand{.name = "typical"},
                              SnapHand{.name = "firm", .forces = false}};
const std::span<const SnapHand> kHands = std::span(kAllHands).first(kSanitized ? 1 : 2);

TEST(SnappingBars, R43_LinesThatAreNotMeantToMeetComeOutOneByOne) {
  for (const SnapHand& hand : kHands) {
    int strokes = 0, met = 0;
    for (const SnapScene& scene : scenes_to_leave_alone()) {
      const std::string lines = lines_of(scene);
      const auto off = draw_lines(lines, hand, "off"), count = draw_lines(lines, hand);
      ASSERT_TRUE(off && count);
      EXPECT_EQ(count->joined(), 0) << scene.name;
      EXPECT_EQ(count->closed, 0) << scene.name;
      strokes += count->meant;
      met += ends_met_unasked(*count, *off);
      EXPECT_LE(count->mean_mm, 1.1 * off->mean_mm) << scene.name;
    }
    EXPECT_LE(300 * met, strokes) << hand.name;
  }
}

TEST(SnappingBars, R44_ShapesThatAreMeantToCloseDo) {
  for (const SnapHand& hand : kHands) {
    int drawn = 0, closed = 0;
    for (const SnapScene& scene : scenes_to_close()) {
      const std::string lines = lines_of(scene);
      const auto off = draw_lines(lines, hand, "off"), count = draw_lines(lines, hand);
      ASSERT_TRUE(off && count);
      const int shapes = shapes_drawn(*off, paths_of(lines), scene.lines_per_shape);
      drawn += shapes;
      closed += std::min(shapes, shapes_closed(*count, scene.lines_per_shape));
    }
    EXPECT_GE(drawn, 80) << hand.name;
    EXPECT_GE(closed, 0.95 * drawn) << hand.name;
  }
}

}  // namespace
}  // namespace felt::snap_test::snapping_bars_test
