#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

#include "felt/fill/fill_shape.h"
#include "felt/haptics/testing/feel_rig.h"
#include "felt/tools/fill/fill_tool.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::fill_tool_test {
namespace {

constexpr Rgba kRed{0xb0, 0x20, 0x20, 255}, kBlue{0x20, 0x20, 0xb0, 128};

/// Two areas side by side: a frame of two by one squares of 20 mm, each line a stroke.
struct Fixture {
  Fixture() {
    fixture.color = kRed;
    line({-2, 0}, {42, 0});
    line({-2, 20}, {42, 20});
    for (const double x : {0.0, 20.0, 40.0}) line({x, -2}, {x, 22});
  }
  void line(Point a, Point b) { fixture.add(testing::straight_stroke(a, b, 1, 1)); }
  void tap(Point p) { pen.line({p}); }
  [[nodiscard]] std::vector<FillPtr> fills() const {
    std::vector<FillPtr> found;
    for (const Layer& layer : fixture.document.layers()) {
      for (const FillId id : layer.fills) found.push_back(fixture.document.find_fill(id));
    }
    return found;
  }
  [[nodiscard]] Overlay shown() const {
    Overlay overlay;
    tool.draw(overlay);
    return overlay;
  }

  testing::Fixture fixture;
  FillTool tool;
  testing::Pen pen{tool, fixture};
};

TEST(Fill, ATapFillsTheAreaUnderThePen) {
  Fixture f;
  f.tap({10, 5});
  ASSERT_EQ(f.fills().size(), 1U);
  EXPECT_EQ(f.pen.commits, 1);
  EXPECT_EQ(f.fills()[0]->color, kRed);
  const Rect box = fill_bounds(*f.fills()[0]);
  EXPECT_NEAR(std::abs(box.x0) + std::abs(box.x1 - 20) + std::abs(box.y0) + std::abs(box.y1 - 20),
              0.0, 1e-9);
  f.fixture.undo();
  EXPECT_TRUE(f.fills().empty());
}

TEST(Fill, AnotherTapGivesAnotherColourAndTheSameColourRemoves) {
  Fixture f;
  f.tap({10, 5});
  f.fixture.color = kBlue;
  f.tap({12, 15});
  ASSERT_EQ(f.fills().size(), 1U);
  EXPECT_EQ(f.fills()[0]->color, kBlue);
  f.tap({10, 10});
  EXPECT_TRUE(f.fills().empty());
  EXPECT_EQ(f.pen.commits, 3);
}

TEST(Fill, ADragFillsEveryAreaOnItsPathInOneStep) {
  Fixture f;
  f.pen.up({10, 5});
  f.pen.down({10, 5});
  const ToolResult result = f.pen.at({30, 5, -1});
  ASSERT_TRUE(result.preview);
  EXPECT_EQ(result.preview->fills.size(), 2U) << "an area between two samples is not missed";
  f.pen.up({30, 5});
  EXPECT_EQ(f.pen.commits, 1);
  EXPECT_EQ(f.fills().size(), 2U);
  f.pen.buttons = kSecondModifier;
  f.pen.line({{10, 5}, {30, 5}});
  EXPECT_TRUE(f.fills().empty()) << "the second modifier removes";
}

TEST(Fill, ADragFromAFillOfTheSameColourKeepsIt) {
  Fixture f;
  f.tap({10, 5});
  f.pen.line({{10, 5}, {30, 5}});
  EXPECT_EQ(f.fills().size(), 2U);
}

TEST(Fill, ClosesGapsUpToTheOptionAndShowsTheGapOfAnOpenArea) {
  Fixture f;
  f.line({100, 0}, {120, 0});
  f.line({120, 0}, {120, 20});
  f.line({120, 20}, {100, 20});
  f.line({100, 20}, {100, 5});
  f.tap({110, 10});
  EXPECT_TRUE(f.fills().empty()) << "a gap of 5 mm";
  ASSERT_EQ(f.shown().labels.size(), 1U);
  EXPECT_LE(distance(f.shown().labels[0].at, {100, 2.5}), 3.0);
  EXPECT_FALSE(f.shown().lines.empty());
  ASSERT_TRUE(f.tool.set_option("gap_mm", 6.0));
  f.pen.up({110, 10});
  f.pen.down({110, 10});
  EXPECT_TRUE(f.shown().labels.empty());
  EXPECT_FALSE(f.shown().lines.empty()) << "the bridge is shown while the pen is down";
  f.pen.up({110, 10});
  ASSERT_EQ(f.fills().size(), 1U);
  EXPECT_EQ(f.fills()[0]->max_gap_mm, 6.0);
}

TEST(Fill, LeavesLockedLayersAlone) {
  Fixture f;
  f.tap({10, 5});
  const Layer& layer = f.fixture.document.layers().front();
  f.fixture.apply({"Lock",
                   {},
                   {{layer.id, LayerState{layer.name, true, false},
                     LayerState{layer.name, true, true}, 0, 0}}});
  f.fixture.color = kBlue;
  f.tap({10, 5});
  f.tap({30, 5});
  EXPECT_EQ(f.pen.commits, 1);
}

TEST(Fill, HiddenLinesBoundNothing) {
  Fixture f;
  const LayerId top = f.fixture.document.new_layer_id();
  f.fixture.apply({"Add layer", {}, {{top, std::nullopt, LayerState{"Top"}, 0, 1}}});
  const Layer low = f.fixture.document.layers().front();
  f.fixture.apply({"Hide", {}, {{low.id, low.state(), LayerState{low.name, false, false}, 0, 0}}});
  f.fixture.layer = top;
  f.tap({10, 5});
  EXPECT_EQ(f.pen.commits, 0);
}

TEST(Fill, CancelLeavesNothing) {
  Fixture f;
  f.pen.up({10, 5});
  f.pen.down({10, 5});
  f.tool.cancel();
  f.pen.up({10, 5});
  EXPECT_TRUE(f.fills().empty());
}

/// Returns the force along the surface without friction and grain, at rest.
double lateral_n(const ForceModel& model, Point p) {
  ForceMemory memory;
  double sum = 0.0;
  for (int i = 0; i < 400; ++i) {
    PenSample sample;
    sample.position = {p.x, p.y, -1.0};
    memory.begin_tick(0.001);
    (void)model(sample, memory);
    sum = 0.0;
    for (const ForceTerms::Term& term : memory.terms) {
      if (std::string_view(term.name) == "guide") sum = term.force.x;
    }
  }
  return sum;
}

TEST(Fill, TheEdgeIsASoftRidgeWhileThePenFills) {
  Fixture f;
  f.pen.line({{10, 10}});
  f.pen.down({18, 10});
  EXPECT_EQ(lateral_n(f.tool.force(f.fixture.scene()), {18, 10}), 0.0) << "off by default";
  f.pen.up({18, 10});
  ASSERT_TRUE(f.tool.set_option("ridge", 1.0));
  f.pen.up({18, 10});
  f.pen.down({18, 10});
  const double inside = lateral_n(f.tool.force(f.fixture.scene()), {18, 10});
  const double outside = lateral_n(f.tool.force(f.fixture.scene()), {22, 10});
  EXPECT_LT(inside, -0.02) << "away from the edge at x = 20";
  EXPECT_GT(outside, 0.02);
  EXPECT_LE(std::max(-inside, outside), 0.5);
  f.pen.up({18, 10});
  EXPECT_EQ(lateral_n(f.tool.force(f.fixture.scene()), {18, 10}), 0.0);
}

}  // namespace
}  // namespace felt::fill_tool_test
