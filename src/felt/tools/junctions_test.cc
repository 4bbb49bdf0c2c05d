#include "felt/tools/junctions.h"

#include <gtest/gtest.h>

#include "felt/tools/testing/tool_fixture.h"

namespace felt::junctions_test {
namespace {

using testing::Fixture;
using testing::straight_stroke;

TEST(Junctions, R33_AreSharedEndsAndEndsOnOtherLines) {
  Fixture fixture;
  const StrokeId line = fixture.add(straight_stroke({0, 0}, {40, 0}, 1, 1));
  const StrokeId next = fixture.add(straight_stroke({40, 0}, {60, 30}, 1, 1));
  const StrokeId post = fixture.add(straight_stroke({10, -20}, {10, 0}, 1, 1));
  const StrokeId crossing = fixture.add(straight_stroke({30, -9}, {30, 9}, 1, 1));
  const StrokeId base = fixture.add(straight_stroke({0, -5}, {0, 5}, 1, 1));
  fixture.add(straight_stroke({20, 0.03}, {20, 9}, 1, 1));  // near, but does not touch
  const auto found =
      junctions_of(fixture.document, fixture.index, line, *fixture.document.find(line));
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
    Fixture fixture;
    fixture.apply({"Layer", {}, {{{2}, std::nullopt, LayerState{"Other"}, 0, 1}}});
    const StrokeId line = fixture.add(straight_stroke({0, 0}, {40, 0}, 1, 1));
    fixture.layer = LayerId{2};
    fixture.add(straight_stroke({40, 0}, {60, 30}, 1, 1));
    fixture.apply(
        {"State", {}, {{{2}, LayerState{"Other"}, LayerState{"Other", visible, true}, 1, 1}}});
    const auto found =
        junctions_of(fixture.document, fixture.index, line, *fixture.document.find(line));
    ASSERT_EQ(found.size(), visible ? 1u : 0u);
    if (visible) {
      EXPECT_FALSE(found[0].editable);
    }
  }
}

TEST(Junctions, EndsOnTheMiddleOfALockedLineAreFoundFromBothLines) {
  Fixture fixture;
  fixture.apply({"Layer", {}, {{{2}, std::nullopt, LayerState{"Other"}, 0, 1}}});
  const StrokeId post = fixture.add(straight_stroke({20, 30}, {20, 0}, 1, 1));
  fixture.layer = LayerId{2};
  const StrokeId base = fixture.add(straight_stroke({0, 0}, {40, 0}, 1, 1));
  fixture.apply({"Lock", {}, {{{2}, LayerState{"Other"}, LayerState{"Other", true, true}, 1, 1}}});
  const auto of_post =
      junctions_of(fixture.document, fixture.index, post, *fixture.document.find(post));
  ASSERT_EQ(of_post.size(), 1u);
  EXPECT_EQ(of_post[0].other, base);
  EXPECT_EQ(of_post[0].u, 1.0);
  EXPECT_NEAR(of_post[0].other_u, 0.5, 1e-9);
  EXPECT_FALSE(of_post[0].editable);
  const auto of_base =
      junctions_of(fixture.document, fixture.index, base, *fixture.document.find(base));
  ASSERT_EQ(of_base.size(), 1u);
  EXPECT_TRUE(of_base[0].editable);
}

}  // namespace
}  // namespace felt::junctions_test
