#include "felt/tools/junctions.h"

#include <gtest/gtest.h>

#include "felt/tools/testing/desk.h"

namespace felt::junctions_test {
namespace {

using testing::Desk;
using testing::straight_stroke;

TEST(Junctions, R33_AreSharedEndsAndEndsOnOtherLines) {
  Desk desk;
  const StrokeId line = desk.add(straight_stroke({0, 0}, {40, 0}, 1, 1));
  const StrokeId next = desk.add(straight_stroke({40, 0}, {60, 30}, 1, 1));
  const StrokeId post = desk.add(straight_stroke({10, -20}, {10, 0}, 1, 1));
  const StrokeId crossing = desk.add(straight_stroke({30, -9}, {30, 9}, 1, 1));
  const StrokeId base = desk.add(straight_stroke({0, -5}, {0, 5}, 1, 1));
  desk.add(straight_stroke({20, 0.03}, {20, 9}, 1, 1));  // near, but does not touch
  const auto found = junctions_of(desk.document, desk.index, line, *desk.document.find(line));
  ASSERT_EQ(found.size(), 3u) << "a crossing shares no end: " << crossing.value;
  EXPECT_EQ(found[0].other, next);
  EXPECT_EQ(found[0].u, 1.0);
  EXPECT_EQ(found[0].other_u, 0.0);
  EXPECT_EQ(found[1].other, post);
  EXPECT_NEAR(found[1].u, 0.25, 1e-9);
  EXPECT_EQ(found[1].other_u, 1.0);
  EXPECT_EQ(found[2].other, base);
  EXPECT_EQ(found[2].u, 0.0);
  EXPECT_NEAR(found[2].other_u, 0.5, 1e-9);
}

TEST(Junctions, HiddenLayersDoNotCountAndLockedOnesAreNotEditable) {
  for (const bool visible : {false, true}) {
    Desk desk;
    desk.apply({"Layer", {}, {{{2}, std::nullopt, LayerState{"Other"}, 0, 1}}});
    const StrokeId line = desk.add(straight_stroke({0, 0}, {40, 0}, 1, 1));
    desk.layer = LayerId{2};
    desk.add(straight_stroke({40, 0}, {60, 30}, 1, 1));
    desk.apply(
        {"State", {}, {{{2}, LayerState{"Other"}, LayerState{"Other", visible, true}, 1, 1}}});
    const auto found = junctions_of(desk.document, desk.index, line, *desk.document.find(line));
    ASSERT_EQ(found.size(), visible ? 1u : 0u);
    if (visible) {
      EXPECT_FALSE(found[0].editable);
    }
  }
}

}  // namespace
}  // namespace felt::junctions_test
