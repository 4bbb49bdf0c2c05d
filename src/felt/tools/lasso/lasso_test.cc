#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

#include "felt/geometry/polyline.h"
#include "felt/stroke/edit/point_marks.h"
#include "felt/tools/lasso/lasso_force.h"
#include "felt/tools/lasso/lasso_tool.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::lasso_test {
namespace {

using testing::arc;
using testing::Fixture;
using testing::Pen;
using testing::random_stroke;
using testing::straight_stroke;
using testing::way;
using testing::operator+;

struct Lasso {
  Fixture fixture;
  LassoTool tool;
  Pen pen{tool, fixture};

  Lasso() { choose("take", "points"); }

  void set(std::string_view id, const OptionValue& value) {
    const auto ok = tool.set_option(id, value);
    ASSERT_TRUE(ok) << ok.error().message;
  }
  void choose(std::string_view id, const char* value) { set(id, std::string(value)); }
  /// Draws along a path with buttons pressed: a lasso, a rectangle or a click.
  void draw(const std::vector<Point>& line, std::uint32_t buttons = 0) {
    pen.up(line.front());
    for (const Point p : line) {
      pen.give({.time_ns = pen.now_ns += 1'000'000,
                .position = {p.x, p.y, -1.0},
                .velocity = {},
                .pressure = {},
                .buttons = buttons});
    }
    pen.up(line.back());
  }
  [[nodiscard]] const Selection& selection() const { return fixture.selection; }
  [[nodiscard]] Overlay overlay() const {
    Overlay o;
    tool.draw(o);
    return o;
  }
};

Fixture& fill(Fixture& fixture, int count) {
  for (int i = 0; i < count; ++i) fixture.add(random_stroke(static_cast<std::uint64_t>(i)));
  return fixture;
}

TEST(Lasso, R31_TakesTheControlPointsInside) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Lasso lasso;
    fill(lasso.fixture, 12);
    testing::RandomStroke random(seed);
    // A star that crosses itself. Its straight lines are simplified to their corners.
    std::vector<Point> corners;
    for (int i = random.pick(3, 7); i > 0; --i) {
      corners.push_back({random.uniform(-2, 22), random.uniform(-2, 22)});
    }
    std::vector<Point> line;
    for (std::size_t i = 1; i < corners.size(); ++i) line = line + way(corners[i - 1], corners[i]);
    lasso.draw(line);

    LassoOutline outline;
    outline.begin(line[0]);
    for (const Point p : line) outline.add(p);
    const std::vector<Point> polygon = outline.finished();
    for (const Layer& layer : lasso.fixture.document.layers()) {
      for (const StrokeId id : layer.strokes) {
        const Stroke& stroke = *lasso.fixture.document.find(id);
        Selection::Marks marks;
        for (const Point p : stroke.data().points) {
          marks.push_back(contains(polygon, p, FillRule::kEvenOdd) ? 1 : 0);
        }
        close_marks(stroke, marks);
        const Selection::Marks* found = lasso.selection().find(id);
        const bool any = std::find(marks.begin(), marks.end(), 1) != marks.end();
        ASSERT_EQ(found != nullptr, any) << "seed " << seed;
        if (found) {
          EXPECT_EQ(*found, marks) << "seed " << seed;
        }
      }
    }
  }
}

TEST(Lasso, R31_TakesHandlesOfALineWhoseInkIsElsewhere) {
  Lasso lasso;
  const StrokeId id =
      lasso.fixture.add(Stroke::create({.points = {{0, 0}, {20, 60}, {40, 60}, {60, 0}},
                                        .joints = {},
                                        .closed = false,
                                        .widths = {{0, 1}, {1, 1}}})
                            .value());
  lasso.draw(arc({20, 60}, 5, 0, 350));  // the ink reaches only to 45 mm
  ASSERT_NE(lasso.selection().find(id), nullptr);
  EXPECT_EQ(*lasso.selection().find(id), (Selection::Marks{0, 1, 0, 0}));
}

TEST(Lasso, R65_TakesPartOfALineThatLeavesTheLoopUnlessAskedForLines) {
  Fixture fixture;
  LassoTool tool;
  Pen pen(tool, fixture);
  const StrokeId id = fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
  pen.line(arc({0, 0}, 25, 0, 355));
  ASSERT_NE(fixture.selection.find(id), nullptr);
  EXPECT_EQ(*fixture.selection.find(id), (Selection::Marks{1, 1, 0, 0}));
  ASSERT_TRUE(tool.set_option("take", std::string("strokes")));
  pen.line(arc({0, 0}, 25, 0, 355));
  EXPECT_TRUE(fixture.selection.is_whole(id));
}

TEST(Lasso, IsNoEditAndNoUndoStep) {
  Lasso lasso;
  const StrokeId id = lasso.fixture.add(straight_stroke({0, 0}, {10, 0}, 1, 1));
  const Document before = lasso.fixture.document;
  lasso.draw(arc({5, 0}, 9, 0, 350));
  EXPECT_TRUE(lasso.selection().is_whole(id));
  EXPECT_EQ(lasso.pen.commits, 0);
  EXPECT_EQ(lasso.fixture.document, before);
}

TEST(Lasso, TakesPartOfALine) {
  Lasso lasso;
  const StrokeId id = lasso.fixture.add(straight_stroke({0, 0}, {30, 0}, 1, 1));
  lasso.draw(arc({0, 0}, 5, 0, 355));
  EXPECT_EQ(*lasso.selection().find(id), (Selection::Marks{1, 0, 0, 0}));
  lasso.draw(arc({0, 0}, 12, 0, 355));
  EXPECT_EQ(*lasso.selection().find(id), (Selection::Marks{1, 1, 0, 0}));
}

TEST(Lasso, OnCurveTakesHandlesWithTheirJoints) {
  Lasso lasso;
  const StrokeId id = lasso.fixture.add(straight_stroke({0, 0}, {30, 0}, 1, 1));
  lasso.choose("take", "on-curve");
  lasso.draw(arc({0, 0}, 5, 0, 355));
  EXPECT_EQ(*lasso.selection().find(id), (Selection::Marks{1, 1, 0, 0}));
  lasso.draw(arc({10, 0}, 5, 0, 355));
  EXPECT_TRUE(lasso.selection().empty()) << "a handle alone does not count";
}

TEST(Lasso, StrokesTakesWhatIsTouched) {
  Lasso lasso;
  const StrokeId id = lasso.fixture.add(straight_stroke({0, 0}, {90, 0}, 1, 1));
  const StrokeId other = lasso.fixture.add(straight_stroke({0, 9}, {90, 9}, 1, 1));
  lasso.choose("take", "strokes");
  lasso.draw(arc({45, 0}, 3, 0, 355));
  EXPECT_TRUE(lasso.selection().is_whole(id));
  EXPECT_EQ(lasso.selection().find(other), nullptr);
}

TEST(Lasso, R65_PartsTakesALineWholeIfAtMostATailIsOutside) {
  // A line of 90 mm whose control points are 30 mm apart, looped from its start.
  for (const double inside_mm : {95.0, 85.0, 82.0, 78.0, 65.0, 35.0}) {
    Lasso lasso;
    const StrokeId id = lasso.fixture.add(straight_stroke({0, 0}, {90, 0}, 1, 1));
    lasso.choose("take", "parts");
    lasso.choose("mode", "rectangle");
    lasso.draw(way({-5, -5}, {inside_mm, 5}));
    SCOPED_TRACE(inside_mm);
    EXPECT_EQ(lasso.selection().is_whole(id), inside_mm > 81.0);
    const Selection::Marks* marks = lasso.selection().find(id);
    ASSERT_TRUE(marks);
    EXPECT_TRUE(marks->front());
    EXPECT_EQ(marks->back() != 0, inside_mm > 81.0);
  }
}

TEST(Lasso, R65_PartsTakesNoLineWhoseInkIsOutside) {
  Lasso lasso;
  // The handles are inside, but the ink passes below.
  StrokeData arch;
  arch.points = {{0, 0}, {10, 40}, {20, 40}, {30, 0}};
  arch.widths = {{0.0, 1.0, 0.5}, {1.0, 1.0, 0.5}};
  lasso.fixture.add(Stroke::create(arch).value());
  lasso.choose("take", "parts");
  lasso.draw(arc({15, 42}, 8, 0, 355));
  EXPECT_TRUE(lasso.selection().empty());
  lasso.choose("take", "points");
  lasso.draw(arc({15, 42}, 8, 0, 355));
  EXPECT_FALSE(lasso.selection().empty());
}

RC_GTEST_PROP(LassoProperty, R65_PartsIsBetweenPointsAndStrokes, (std::uint64_t seed)) {
  const Stroke stroke = random_stroke(seed);
  testing::RandomStroke random(seed);
  std::vector<Point> corners;
  for (int i = random.pick(3, 7); i > 0; --i) {
    corners.push_back({random.uniform(-2, 22), random.uniform(-2, 22)});
  }
  const LassoArea area(corners);
  const double inside = area.share_inside(stroke);
  RC_ASSERT(inside >= 0.0 && inside <= 1.0 + 1e-9);
  const Selection::Marks parts = marks_inside(stroke, area, LassoTake::kParts);
  const Selection::Marks points = marks_inside(stroke, area, LassoTake::kPoints);
  const Selection::Marks strokes = marks_inside(stroke, area, LassoTake::kStrokes);
  if (inside > 0.0) RC_ASSERT(all_marked(strokes));
  if (inside >= 1.0 - kTailShare) {
    RC_ASSERT(all_marked(parts));
  } else {
    RC_ASSERT(parts == (inside > 0.0 ? points : Selection::Marks(points.size(), 0)));
  }
}

TEST(Lasso, ARectangleGoesFromCornerToCorner) {
  Lasso lasso;
  const StrokeId id = lasso.fixture.add(straight_stroke({10, 10}, {20, 20}, 1, 1));
  lasso.choose("mode", "rectangle");
  lasso.draw(way({21, 9}, {9, 21}));
  EXPECT_TRUE(lasso.selection().is_whole(id));
  lasso.draw(way({10, 10}, {20, 20}));
  EXPECT_TRUE(lasso.selection().is_whole(id)) << "edges are inside";
  lasso.draw(way({0, 0}, {9, 9}));
  EXPECT_TRUE(lasso.selection().empty());
}

TEST(Lasso, AClickTakesTheNearestLineOrClears) {
  Lasso lasso;
  const StrokeId low = lasso.fixture.add(straight_stroke({0, 0}, {30, 0}, 1, 1));
  const StrokeId high = lasso.fixture.add(straight_stroke({0, 5}, {30, 5}, 1, 1));
  lasso.draw({{15, 2}});
  EXPECT_TRUE(lasso.selection().is_whole(low));
  EXPECT_EQ(lasso.selection().strokes().size(), 1u);
  lasso.draw(way({15, 4}, {15.4, 4.3}));
  EXPECT_TRUE(lasso.selection().is_whole(high));
  EXPECT_EQ(lasso.selection().strokes().size(), 1u);
  lasso.draw({{15, 9.1}});
  EXPECT_TRUE(lasso.selection().empty()) << "nothing within 4 mm: clears";
  lasso.set("click_radius_mm", 5.0);
  lasso.draw({{15, 9.1}});
  EXPECT_TRUE(lasso.selection().is_whole(high));
}

TEST(Lasso, R31_ALongWayThatEnclosesNothingSelectsNothing) {
  Lasso lasso;
  const StrokeId id = lasso.fixture.add(straight_stroke({0, 0}, {30, 0}, 1, 1));
  lasso.draw({{15, 1}});
  ASSERT_TRUE(lasso.selection().is_whole(id));
  lasso.draw(way({0, 0}, {30, 0}));
  EXPECT_TRUE(lasso.selection().is_whole(id)) << "neither a lasso nor a click: stays as it was";
}

TEST(Lasso, AddsAndTakesAway) {
  Lasso lasso;
  const StrokeId left = lasso.fixture.add(straight_stroke({0, 0}, {10, 0}, 1, 1));
  const StrokeId right = lasso.fixture.add(straight_stroke({40, 0}, {50, 0}, 1, 1));
  lasso.draw(arc({5, 0}, 9, 0, 355));
  lasso.draw(arc({45, 0}, 9, 0, 355), kFirstModifier);
  EXPECT_TRUE(lasso.selection().is_whole(left));
  EXPECT_TRUE(lasso.selection().is_whole(right));
  lasso.draw(arc({10, 0}, 2, 0, 355), kSecondModifier);
  EXPECT_EQ(*lasso.selection().find(left), (Selection::Marks{1, 1, 1, 0}));
  lasso.draw({{45, 1}}, kSecondModifier);
  EXPECT_EQ(lasso.selection().find(right), nullptr);
  lasso.draw({{45, 1}}, kFirstModifier);
  EXPECT_TRUE(lasso.selection().is_whole(right));
  lasso.draw({{25, 30}}, kFirstModifier);
  EXPECT_EQ(lasso.selection().strokes().size(), 2u) << "a click beside all with a modifier is none";

  lasso.choose("combine", "subtract");
  lasso.draw(arc({5, 0}, 9, 0, 355));
  EXPECT_EQ(lasso.selection().find(left), nullptr);
  lasso.choose("combine", "add");
  lasso.draw(arc({5, 0}, 9, 0, 355));
  EXPECT_EQ(lasso.selection().strokes().size(), 2u);
}

TEST(Lasso, R32_WhatIsLeftIsClosedAgain) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Lasso lasso;
    fill(lasso.fixture, 8);
    testing::RandomStroke random(seed);
    for (int i = 0; i < 6; ++i) {
      const Point at{random.uniform(0, 20), random.uniform(0, 20)};
      const std::uint32_t button = i % 3 == 2 ? kSecondModifier : kFirstModifier;
      lasso.draw(arc(at, random.uniform(2, 9), 0, 350), button);
    }
    for (const auto& [id, marks] : lasso.selection().strokes()) {
      Selection::Marks closed = marks;
      close_marks(*lasso.fixture.document.find(id), closed);
      EXPECT_EQ(closed, marks) << "seed " << seed;
    }
  }
}

TEST(Lasso, LockedAndHiddenLayersAreLeftAlone) {
  for (const bool locked : {true, false}) {
    Lasso lasso;
    lasso.fixture.add(straight_stroke({0, 0}, {10, 0}, 1, 1));
    const Layer layer = lasso.fixture.document.layers()[0];
    LayerState after = layer.state();
    (locked ? after.locked : after.visible) = locked;
    lasso.fixture.apply({"Layer", {}, {{layer.id, layer.state(), after, 0, 0}}});
    lasso.draw(arc({5, 0}, 9, 0, 355));
    EXPECT_TRUE(lasso.selection().empty());
    lasso.draw({{5, 1}});
    EXPECT_TRUE(lasso.selection().empty());
  }
}

TEST(Lasso, CancelLeavesTheSelection) {
  Lasso lasso;
  const StrokeId id = lasso.fixture.add(straight_stroke({0, 0}, {10, 0}, 1, 1));
  lasso.draw({{5, 1}});
  const std::vector<Point> line = arc({50, 50}, 9, 0, 355);
  lasso.pen.up(line.front());
  lasso.pen.along(line);
  lasso.tool.cancel();
  lasso.pen.up(line.back());
  EXPECT_TRUE(lasso.selection().is_whole(id));
  EXPECT_TRUE(lasso.overlay().outlines.empty());
}

TEST(Lasso, FinishEndsTheGestureAsALiftDoes) {
  Lasso lasso;
  const StrokeId id = lasso.fixture.add(straight_stroke({0, 0}, {10, 0}, 1, 1));
  lasso.pen.up({14, 0});
  lasso.pen.along(arc({5, 0}, 9, 0, 355));
  const ToolResult result = lasso.tool.finish(lasso.fixture.scene());
  ASSERT_TRUE(result.selection);
  EXPECT_TRUE(result.selection->is_whole(id));
}

TEST(Lasso, MarksWhileItIsDrawnWhatItTakes) {
  Lasso lasso;
  lasso.fixture.add(straight_stroke({0, 0}, {10, 0}, 1, 1));
  lasso.fixture.add(straight_stroke({3, 3}, {8, 3}, 1, 1));
  lasso.fixture.add(straight_stroke({40, 0}, {50, 0}, 1, 1));
  lasso.pen.up({17, 0});
  lasso.pen.along(arc({5, 0}, 12, 0, 355));
  const Overlay during = lasso.overlay();
  ASSERT_EQ(during.outlines.size(), 1u);
  EXPECT_TRUE(during.outlines[0].closed);
  EXPECT_EQ(during.spans.size(), 2u);
  ASSERT_EQ(during.labels.size(), 1u);
  EXPECT_EQ(during.labels[0].text, "2 lines");
  lasso.pen.up({17, 0});
  const Overlay after = lasso.overlay();
  EXPECT_EQ(after.spans.size(), 2u);
  EXPECT_EQ(after.spans[0].role, Overlay::Role::kSelected);
  EXPECT_TRUE(after.outlines.empty());
}

TEST(Lasso, ShowsWhatAClickWouldTakeBeforeTheTouch) {
  Lasso lasso;
  lasso.fixture.add(straight_stroke({0, 0}, {10, 0}, 1, 1));
  lasso.pen.up({5, 30});
  EXPECT_TRUE(lasso.overlay().spans.empty());
  lasso.pen.up({5, 3});
  EXPECT_EQ(lasso.overlay().spans.size(), 1u);
}

TEST(Lasso, LosesNothingInHugeOrWildGestures) {
  Lasso lasso;
  fill(lasso.fixture, 20);
  testing::RandomStroke random(5);
  for (int gesture = 0; gesture < 30; ++gesture) {
    lasso.choose("mode", gesture % 2 ? "free" : "rectangle");
    constexpr std::array kTakes = {"points", "strokes", "on-curve", "parts"};
    lasso.choose("take", kTakes[static_cast<std::size_t>(gesture) % kTakes.size()]);
    std::vector<Point> line;
    const double far = std::pow(10.0, random.uniform(0, 8.9));
    for (int i = random.pick(1, 60); i > 0; --i) {
      line.push_back({random.uniform(-far, far), random.uniform(-far, far)});
    }
    lasso.draw(line, static_cast<std::uint32_t>(gesture % 4));
    for (const auto& [id, marks] : lasso.selection().strokes()) {
      ASSERT_EQ(marks.size(), lasso.fixture.document.find(id)->data().points.size());
    }
  }
}

TEST(Lasso, GlidesMoreThanAPencil) {
  Lasso lasso;
  const auto slide = [&](double strength) {
    ForceModel model = make_lasso_force({.strength = strength}, lasso.fixture.scene());
    ForceMemory memory;
    Force force;
    PenSample s;
    for (int i = 0; i < 400; ++i) {
      s.time_ns += 1'000'000;
      s.position = {0.05 * i, 0.0, -2.0};
      s.velocity = {50.0, 0.0, 0.0};
      memory.begin_tick(0.001);
      force = model(s, memory);
    }
    return force;
  };
  const Force full = slide(1.0);
  EXPECT_NEAR(-full.x / full.z, kLassoGlide * 0.25, 0.1 * 0.25);
  EXPECT_NEAR(slide(0.0).x, 0.0, 1e-12);
  EXPECT_EQ(slide(0.0).z, full.z) << "Does not affect the hardness";
}

}  // namespace
}  // namespace felt::lasso_test
