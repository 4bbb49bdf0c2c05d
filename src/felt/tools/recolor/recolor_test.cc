#include <gtest/gtest.h>

#include "felt/haptics/testing/feel_rig.h"
#include "felt/tools/recolor/recolor_tool.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::recolor_test {
namespace {

constexpr Rgba kRed{0xb0, 0x20, 0x20, 255};

struct Fixture {
  Fixture() { fixture.color = kRed; }

  testing::Fixture fixture;
  RecolorTool tool;
  testing::Pen pen{tool, fixture};
  StrokeId low = fixture.add(testing::straight_stroke({0, 0}, {60, 0}, 1, 1));
  StrokeId high = fixture.add(testing::straight_stroke({0, 20}, {60, 20}, 1, 1));

  [[nodiscard]] Rgba color(StrokeId id) const { return fixture.document.find(id)->color(); }
};

TEST(Recolor, ATapChangesTheLineUnderThePen) {
  Fixture f;
  const StrokeData before = f.fixture.document.find(f.low)->data();
  f.pen.line({{30, 1}});
  EXPECT_EQ(f.pen.commits, 1);
  EXPECT_EQ(f.color(f.low), kRed);
  EXPECT_NE(f.color(f.high), kRed);
  StrokeData expected = before;
  expected.color = kRed;
  EXPECT_EQ(f.fixture.document.find(f.low)->data(), expected) << "only the colour changes";
  f.pen.line({{30, 1}});
  EXPECT_EQ(f.pen.commits, 1) << "it has this colour already";
  f.fixture.undo();
  EXPECT_EQ(f.fixture.document.find(f.low)->data(), before);
}

TEST(Recolor, ADragChangesEveryLineThatItCrossesInOneStep) {
  Fixture f;
  f.pen.up({30, -10});
  f.pen.down({30, -10});
  const ToolResult result = (f.pen.down({30, 30}), f.pen.at({30, 31, -1}));
  EXPECT_TRUE(result.preview || result.same_preview);
  f.pen.up({30, 31});
  EXPECT_EQ(f.pen.commits, 1) << "two samples that are far apart miss no line between them";
  EXPECT_EQ(f.color(f.low), kRed);
  EXPECT_EQ(f.color(f.high), kRed);
}

TEST(Recolor, TheEdgeOfBroadInkCounts) {
  Fixture f;
  const StrokeId broad = f.fixture.add(testing::straight_stroke({0, 50}, {60, 50}, 10, 10));
  f.pen.line({{30, 44.2}});
  EXPECT_EQ(f.color(broad), kRed);
  ASSERT_TRUE(f.tool.set_option("radius_mm", 0.1));
  f.pen.line({{30, 0.7}});
  EXPECT_NE(f.color(f.low), kRed) << "the ring does not touch the ink";
}

TEST(Recolor, GivesTheMediumIfTheOptionOrTheModifierSaysSo) {
  Fixture f;
  ASSERT_TRUE(f.tool.set_option("gives", std::string("medium")));
  Scene scene = f.fixture.scene();
  scene.medium = "chalk";
  const auto tap = [&](Point at, std::uint32_t buttons) {
    Contact contact;
    for (const double z : {5.0, -1.0, 5.0}) {
      PenSample sample;
      sample.time_ns = f.pen.now_ns += 100'000'000;
      sample.position = {at.x, at.y, z};
      sample.buttons = buttons;
      const ToolResult result = f.tool.sample(sample, contact.update(sample), scene);
      if (result.commit) f.fixture.apply(*result.commit);
    }
  };
  tap({30, 0}, 0);
  EXPECT_EQ(f.fixture.document.find(f.low)->medium(), "chalk");
  EXPECT_NE(f.color(f.low), kRed);
  tap({30, 20}, kFirstModifier);
  EXPECT_EQ(f.fixture.document.find(f.high)->medium(), "chalk");
  EXPECT_EQ(f.color(f.high), kRed);
}

TEST(Recolor, LeavesLockedLayersAlone) {
  Fixture f;
  Edit lock{"Lock", {}, {}};
  const Layer& layer = f.fixture.document.layers().front();
  lock.layers.push_back(
      {layer.id, LayerState{layer.name, true, false}, LayerState{layer.name, true, true}, 0, 0});
  f.fixture.apply(lock);
  f.pen.line({{30, 0}});
  EXPECT_EQ(f.pen.commits, 0);
}

TEST(Recolor, CancelKeepsTheColours) {
  Fixture f;
  f.pen.up({30, 0});
  f.pen.down({30, 0});
  f.tool.cancel();
  f.pen.up({30, 0});
  EXPECT_EQ(f.pen.commits, 0);
  EXPECT_NE(f.color(f.low), kRed);
}

}  // namespace
}  // namespace felt::recolor_test
