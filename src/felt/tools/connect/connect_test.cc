#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "felt/tools/connect/connect_tool.h"
#include "felt/tools/connect/near_tips.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::connect_test {
namespace {

using testing::Fixture;
using testing::Pen;
using testing::straight_stroke;
using testing::way;
using testing::operator+;

using enum StrokeTip;

struct Connect {
  Fixture fixture;
  ConnectTool tool;
  Pen pen{tool, fixture};

  void set(std::string_view id, const OptionValue& value) {
    const auto ok = tool.set_option(id, value);
    ASSERT_TRUE(ok) << ok.error().message;
  }
  void choose(std::string_view id, const char* value) { set(id, std::string(value)); }
  [[nodiscard]] Overlay overlay() const {
    Overlay o;
    tool.draw(o);
    return o;
  }
  /// Returns the lateral force while hovering.
  [[nodiscard]] double pull_at(Point p) const {
    ForceMemory memory;
    PenSample s;
    s.position = {p.x, p.y, 1.0};
    return norm(tool.force(fixture.scene())(s, memory));
  }
};

/// Two lines with a gap between (50, 0) and (53, 0).
struct Gap : Connect {
  StrokeId left = fixture.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
  StrokeId right = fixture.add(straight_stroke({53, 0}, {103, 0}, 1, 1));
};

Stroke horseshoe() {
  return Stroke::create({.points = {{0, 0}, {80, -20}, {80, 70}, {0, 6}},
                         .joints = {},
                         .closed = false,
                         .widths = {{0, 1}, {1, 2}}})
      .value();
}

TEST(Connect, R43_AnEndThatIsDraggedOntoAnotherIsConnected) {
  Gap g;
  g.pen.line(way({49, 1}, {52.5, 1}));  // the end moves by as much as the pen
  EXPECT_EQ(g.pen.commits, 1);
  EXPECT_EQ(g.fixture.history.undo_label(), "Connect");
  ASSERT_EQ(g.fixture.strokes().size(), 1u);
  const Stroke& one = *g.fixture.document.find(g.right);
  EXPECT_EQ(tip_point(one, kStart), (Point{0, 0}));
  EXPECT_EQ(tip_point(one, kEnd), (Point{103, 0}));
  g.fixture.undo();
  EXPECT_EQ(g.fixture.strokes().size(), 2u);
  EXPECT_EQ(*g.fixture.document.find(g.left), straight_stroke({0, 0}, {50, 0}, 1, 1));
}

TEST(Connect, R43_WithTheForceOnlyGeometryIsNeverConnected) {
  Gap g;
  g.choose("snap", "force");
  const Document before = g.fixture.document;
  g.pen.line(way({50, 0}, {53, 0}));
  EXPECT_EQ(g.fixture.document, before);
  g.set("extend", true);
  g.pen.line(way({50, 0}, {53, 0}));  // exactly onto the other end
  EXPECT_EQ(g.fixture.strokes().size(), 2u);
  EXPECT_EQ(tip_point(*g.fixture.document.find(g.left), kEnd), (Point{53, 0}));
  EXPECT_EQ(*g.fixture.document.find(g.right), straight_stroke({53, 0}, {103, 0}, 1, 1));
  EXPECT_EQ(g.fixture.history.undo_label(), "Move end");
  // If the hand resists, the end stays next to the target.
  g.pen.line(way({53, 0}, {50, 1}));
  g.pen.up({0, 80});
  g.pen.up({50, 1});
  EXPECT_EQ(tip_point(*g.fixture.document.find(g.left), kEnd), (Point{50, 1}));
}

TEST(Connect, R43_TheHandIsAttractedInTheModesThatSaySo) {
  for (const char* mode : {"off", "force", "snap", "both"}) {
    Gap g;
    g.choose("snap", mode);
    g.pen.up({49, 1});
    g.pen.at({49, 1, 1.0});
    const bool attracts = mode == std::string_view("force") || mode == std::string_view("both");
    EXPECT_EQ(g.pull_at({49, 1}) > 0.1, attracts) << mode;
    g.pen.along(way({49, 1}, {50, 3}));
    // The pen is attracted to the point at which the end lies on the target, because the pen
    // touched 1 mm next to the end.
    EXPECT_EQ(g.pull_at({50, 3}) > 0.3, attracts) << mode;
    if (attracts) {
      EXPECT_LT(g.pull_at({52, 1}), 0.1) << mode;  // only the drag
    }
  }
}

TEST(Connect, R44_TheOtherEndOfTheStrokeCountsAtOnce) {
  // Unlike with the pencil, the ends of one stroke may be connected immediately, without first
  // moving away.
  Connect c;
  const StrokeId id = c.fixture.add(horseshoe());
  c.pen.up({0, 6});
  c.pen.along(way({0, 6}, {0, 4.9}));  // 1.1 mm: too far for a tap
  EXPECT_FALSE(c.overlay().rings.empty());
  c.pen.along(way({0, 4.9}, {0, 1.5}));
  c.pen.up({0, 1.5});
  EXPECT_EQ(c.pen.commits, 1);
  EXPECT_EQ(c.fixture.history.undo_label(), "Close");
  EXPECT_TRUE(c.fixture.document.find(id)->closed());
  EXPECT_EQ(c.fixture.document.find(id)->position(0), (Point{0, 0}));
}

TEST(Connect, R44_NothingIsConnectedWithoutBeingAskedTo) {
  Connect c;
  c.set("reach_mm", 1.0);
  const StrokeId id = c.fixture.add(horseshoe());
  const Document before = c.fixture.document;
  c.pen.line({{0, 6}});  // a tap; the other end is out of reach
  EXPECT_EQ(c.fixture.document, before);
  c.set("reach_mm", 8.0);
  // The pen presses for a long time and is then lifted.
  c.pen.up({0, 6});
  for (int k = 0; k < 600; ++k) c.pen.down({0, 6});
  c.pen.up({0, 6});
  EXPECT_EQ(c.fixture.document, before);
  // The end is dragged away and back to its start.
  c.pen.line(way({0, 6}, {0, 1}) + way({0, 1}, {0, 6}));
  EXPECT_EQ(c.fixture.document, before);
  EXPECT_FALSE(c.fixture.document.find(id)->closed());
  EXPECT_EQ(c.pen.commits, 0);
}

TEST(Connect, R45_SmoothBelowThirtyDegreesElseCorner) {
  for (const double deg : {10.0, 29.0, 31.0, 90.0}) {
    for (const bool tap : {false, true}) {
      Connect c;
      const StrokeId to = c.fixture.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
      const double a = deg * std::numbers::pi / 180;
      const Point near{53, 1};
      c.fixture.add(straight_stroke(near, near + 80 * Vec{std::cos(a), std::sin(a)}, 1, 1));
      if (tap) {
        c.pen.line({Point{54, 2}});
      } else {
        c.pen.line(way({53, 1}, {50, 0}));
      }
      ASSERT_EQ(c.fixture.strokes().size(), 1u) << deg;
      const Stroke& one = *c.fixture.strokes()[0];
      const Point meet = tap ? lerp(near, {50, 0}, 0.5) : Point{50, 0};
      EXPECT_TRUE(c.fixture.document.find(to));
      int joint = 0;
      for (int j = 1; j < one.segment_count(); ++j) {
        if (distance(one.position(j), meet) < 1e-9) joint = j;
      }
      ASSERT_GT(joint, 0) << deg;
      EXPECT_EQ(one.joint(joint), deg < 30 ? JointKind::kSmooth : JointKind::kCorner) << deg;
    }
  }
}

TEST(Connect, ATapClosesAGapFromBothSides) {
  Gap g;
  g.pen.at({51, 1, 1});
  EXPECT_EQ(g.overlay().lines.size(), 1u);  // shown before
  g.pen.line({{51, 1}});
  EXPECT_EQ(g.pen.commits, 1);
  ASSERT_EQ(g.fixture.strokes().size(), 1u);
  bool met = false;
  const Stroke& one = *g.fixture.strokes()[0];
  for (int j = 0; j <= one.segment_count(); ++j) met = met || one.position(j) == Point{51.5, 0};
  EXPECT_TRUE(met);
}

TEST(Connect, WhatIsShownIsWhatComes) {
  Gap g;
  g.pen.up({50, 0});
  std::optional<Edit> shown;
  int same = 0;
  for (const Point p : way({50, 0}, {52.9, 0}, 0.05)) {
    const ToolResult result = g.pen.give([&] {
      PenSample s;
      s.time_ns = g.pen.now_ns += 1'000'000;
      s.position = {p.x, p.y, -1};
      return s;
    }());
    if (result.preview) shown = result.preview;
    same += result.same_preview ? 1 : 0;
  }
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->label, "Connect");
  EXPECT_GT(same, 30);  // within the snap radius nothing changes
  Document before = g.fixture.document;
  g.pen.up({52.9, 0});
  ASSERT_TRUE(before.apply(*shown));
  EXPECT_EQ(g.fixture.document, before);
}

TEST(Connect, R23_TheWayOfTheEndDoesNotMatter) {
  const auto drag = [](const std::vector<Point>& points) {
    Connect c;
    c.set("extend", true);
    c.fixture.add(straight_stroke({0, 0}, {80, 0}, 1, 2));
    c.pen.line(points);
    return *c.fixture.strokes()[0];
  };
  const Stroke straight = drag(way({80, 0}, {90, 12}));
  EXPECT_EQ(drag(way({80, 0}, {10, 70}) + way({10, 70}, {90, 12})), straight);
  EXPECT_EQ(drag({{80, 0}, {90, 12}}), straight);
  EXPECT_EQ(tip_point(straight, kEnd), (Point{90, 12}));
}

TEST(Connect, ExtendOrItsModifierLeavesTheEnd) {
  for (const bool option : {false, true}) {
    for (const bool modifier : {false, true}) {
      Connect c;
      c.set("extend", option);
      const StrokeId id = c.fixture.add(straight_stroke({0, 0}, {80, 0}, 1, 2));
      c.pen.up({80, 0});
      for (const Point p : way({80, 0}, {90, 5})) {
        PenSample s;
        s.time_ns = c.pen.now_ns += 1'000'000;
        s.position = {p.x, p.y, -1};
        s.buttons = modifier ? kFirstModifier : 0;
        c.pen.give(s);
      }
      c.pen.up({90, 5});
      const bool stays = option != modifier;
      EXPECT_EQ(tip_point(*c.fixture.document.find(id), kEnd),
                (stays ? Point{90, 5} : Point{80, 0}));
      EXPECT_EQ(c.pen.commits, stays ? 1 : 0);
    }
  }
}

TEST(Connect, R20_FarFromEveryEndNothingHappens) {
  Gap g;
  const Document before = g.fixture.document;
  g.pen.up({25, 0});
  g.pen.at({25, 0, 1});
  EXPECT_TRUE(g.overlay().dots.empty());
  g.pen.line(way({25, 0}, {50, 0}));
  EXPECT_EQ(g.fixture.document, before);
  EXPECT_EQ(g.pull_at({25, 0}), 0.0);
}

TEST(Connect, CancelAndFinish) {
  Gap g;
  const Document before = g.fixture.document;
  g.pen.up({50, 0});
  g.pen.along(way({50, 0}, {53, 0}));
  g.tool.cancel();
  g.pen.along(way({53, 0}, {50, 0}));
  g.pen.up({50, 0});
  EXPECT_EQ(g.fixture.document, before);
  g.pen.at({50, 3, 1});
  EXPECT_GT(g.pull_at({50, 3}), 0.1);  // ready for the next gesture
  g.pen.along(way({50, 0}, {53, 0}));
  const ToolResult end = g.tool.finish(g.fixture.scene());
  ASSERT_TRUE(end.commit);
  EXPECT_EQ(end.commit->label, "Connect");
}

TEST(Connect, TheEndThatIsShownIsTaken) {
  Connect c;
  c.set("extend", true);
  const StrokeId a = c.fixture.add(straight_stroke({0, 0}, {50, 0}, 1, 1));
  const StrokeId b = c.fixture.add(straight_stroke({52, 0}, {102, 0}, 1, 1));
  c.pen.at({50.5, 0, 1});
  for (int k = 0; k < 50; ++k) c.pen.at({51 + 0.4 * std::sin(k), 0, 1});  // stays
  EXPECT_EQ(c.overlay().rings.at(0).center, (Point{50, 0}));
  c.pen.along(way({51.4, 0}, {51.4, 20}));
  c.pen.up({51.4, 20});
  EXPECT_NE(*c.fixture.document.find(a), straight_stroke({0, 0}, {50, 0}, 1, 1));
  EXPECT_EQ(*c.fixture.document.find(b), straight_stroke({52, 0}, {102, 0}, 1, 1));
}

TEST(Connect, EndsInLockedLayersAreNotTakenHoweverMany) {
  for (const int locked : {1, 200}) {
    Fixture fixture;
    const StrokeId mine = fixture.add(straight_stroke({5, 0}, {90, 90}, 1, 1));
    fixture.apply({"Layer", {}, {{{2}, std::nullopt, LayerState{"Below"}, 0, 1}}});
    fixture.layer = {2};
    for (int k = 0; k < locked; ++k) {
      const double a = 2 * std::numbers::pi * k / locked;
      fixture.add(straight_stroke({0.01 * k, 0}, Point{70 * std::cos(a), 70 * std::sin(a)}, 1, 1));
    }
    fixture.apply(
        {"Lock", {}, {{{2}, LayerState{"Below"}, LayerState{"Below", true, true}, 1, 1}}});
    const auto tips = editable_tips_near(fixture.scene(), {0, 0}, 8.0, 4);
    ASSERT_EQ(tips.size(), 1u) << locked;
    EXPECT_EQ(tips[0].id, (TipId{mine, kStart}));
    EXPECT_EQ(tips[0].distance_mm, 5.0);
    EXPECT_TRUE(editable_tips_near(fixture.scene(), {0, 0}, 4.99, 4).empty());
  }
}

TEST(Connect, OptionsAndHostileSamplesAreHarmless) {
  Gap g;
  for (const OptionSpec& spec : g.tool.info().options) g.set(spec.id, default_value(spec));
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), inf, -inf, 1e300}) {
    g.pen.at({bad, 0, -1});
    g.pen.at({50, bad, -1});
    g.pen.at({50, 0, bad});
  }
  g.set("extend", true);
  g.pen.line({{50, 0}, {1e9, 1e9}, {50, 0}, {-1e9, 3}});
  for (const StrokePtr& s : g.fixture.strokes()) EXPECT_TRUE(check_invariants(s->data()));
}

}  // namespace
}  // namespace felt::connect_test
