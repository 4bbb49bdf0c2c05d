#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/stroke/profile_builder.h"
#include "felt/tools/testing/tool_fixture.h"
#include "felt/tools/width/width_tool.h"

namespace felt::width_test {
namespace {

using testing::Fixture;
using testing::Pen;
using testing::straight_stroke;
using testing::way;

struct Width {
  Fixture fixture;
  WidthTool tool;
  Pen pen{tool, fixture};

  Width() { pen.pressure = 0.5; }
  void set(std::string_view id, const OptionValue& value) {
    const auto ok = tool.set_option(id, value);
    ASSERT_TRUE(ok) << ok.error().message;
  }
  void mode(const char* name) { set("mode", std::string(name)); }
  [[nodiscard]] const Stroke& stroke(std::size_t i = 0) const { return *fixture.strokes().at(i); }
  /// Lets the pen rest at a point with a pressure.
  void press(Point at, double pressure, double seconds, std::uint32_t buttons = 0) {
    const auto n = std::llround(seconds * 1e9 / static_cast<double>(pen.step_ns));
    for (std::int64_t i = 0; i <= n; ++i) {
      pen.give({.time_ns = pen.now_ns += pen.step_ns,
                .position = {at.x, at.y, -1.0},
                .velocity = {},
                .pressure = pressure,
                .buttons = buttons});
    }
  }
  [[nodiscard]] Overlay overlay() const {
    Overlay o;
    tool.draw(o);
    return o;
  }
};

/// Returns an arc of about 80 mm with a corner and a profile of its own.
Stroke wavy() {
  StrokeData d;
  d.points = {{0, 0},    {10, 15}, {20, 15}, {30, 0},  {40, -15},
              {50, -15}, {60, 0},  {62, 10}, {70, 20}, {80, 20}};
  d.joints = {JointKind::kSmooth, JointKind::kCorner};
  d.widths = {{0.0, 1.0, 0.2}, {0.7, 2.0, 0.9}, {1.2, 1.4, 0.5}, {3.0, 1.8, 0.0}};
  return Stroke::create(d).value();
}

/// Expects that only widths differ, neither the curve nor the tone.
void expect_same_curve(const Stroke& a, const Stroke& b) {
  EXPECT_EQ(a.data().points, b.data().points);
  EXPECT_EQ(a.data().joints, b.data().joints);
  for (int i = 0; i <= 300; ++i) {
    const double u = a.segment_count() * i / 300.0;
    EXPECT_NEAR(a.tone(u), b.tone(u), kFollowedTone + 1e-9) << u;
  }
}

TEST(WidthTool, R46_APressedPlaceChangesByRateTimesTimeAndTheCurveNotAtAll) {
  for (const double pressure : {0.0, 0.2, 0.4, 0.6, 0.9, 1.0}) {
    SCOPED_TRACE(pressure);
    Width w;
    w.fixture.add(wavy());
    const Stroke before = w.stroke();
    const double u = 1.37;
    const Point at = before.position(u);
    w.pen.up(at);
    w.press(at, pressure, 0.25);
    w.pen.up(at);
    ASSERT_EQ(w.pen.commits, 1);
    const Stroke& after = w.stroke();
    expect_same_curve(before, after);
    const double wanted = std::max(kMinWidthMm, before.width_mm(u) + 6.0 * (pressure - 0.5) * 0.25);
    EXPECT_NEAR(after.width_mm(u), wanted, 1e-9);
    const ArcMap map(before);
    for (int i = 0; i <= 300; ++i) {
      const double v = 0.01 * i;
      if (std::fabs(map.length_at(v) - map.length_at(u)) < 10.5) continue;
      EXPECT_NEAR(after.width_mm(v), before.width_mm(v), 1e-9);
    }
    w.fixture.undo();
    EXPECT_EQ(w.stroke(), before);
  }
}

TEST(WidthTool, R46_TheResultDoesNotDependOnTheRateOfTheSamples) {
  for (const double speed : {10.0, 100.0, 400.0}) {
    SCOPED_TRACE(speed);
    std::vector<Stroke> results;
    for (const double hz : {60.0, 250.0, 1000.0}) {
      Width w;
      w.fixture.add(straight_stroke({0, 0}, {100, 0}, 2, 2));
      const double seconds = 80.0 / speed;
      const auto n = static_cast<int>(std::lround(seconds * hz));
      for (int i = 0; i <= n; ++i) {
        const double t = static_cast<double>(i) / n;
        w.pen.give({.time_ns = std::llround(t * seconds * 1e9),
                    .position = {10 + 80 * t, 0.3, -1.0},
                    .velocity = {},
                    .pressure = 0.7 + 0.25 * std::sin(6.0 * t),
                    .buttons = 0});
      }
      w.pen.now_ns = 100'000'000'000;
      w.pen.up({90, 0});
      results.push_back(w.stroke());
    }
    double largest = 0.0;
    for (int i = 0; i <= 1000; ++i) {
      largest = std::max(largest, results[2].width_mm(0.001 * i) - 2.0);
    }
    EXPECT_GT(largest, 0.03);
    for (int i = 0; i <= 1000; ++i) {
      const double u = 0.001 * i, exact = results[2].width_mm(u);
      // Each profile has been thinned within 0.01 mm.
      EXPECT_NEAR(results[0].width_mm(u), exact, 0.01 * largest + 0.02) << u;
      EXPECT_NEAR(results[1].width_mm(u), exact, 0.01 * largest + 0.02) << u;
    }
  }
}

TEST(WidthTool, ThePenDecidesTheDirectionAndButtonsAndTheOptionOverrideIt) {
  const auto change = [](double pressure, std::uint32_t buttons, const char* direction) {
    Width w;
    w.fixture.add(straight_stroke({0, 0}, {100, 0}, 3, 3));
    w.set("direction", std::string(direction));
    w.press({50, 0}, pressure, 0.2, buttons);
    w.pen.up({50, 0});
    return w.stroke().width_mm(0.5) - 3.0;
  };
  EXPECT_NEAR(change(0.8, 0, "pressure"), 6 * 0.3 * 0.2, 1e-9);
  EXPECT_NEAR(change(0.2, 0, "pressure"), -6 * 0.3 * 0.2, 1e-9);
  EXPECT_NEAR(change(0.8, 0, "thinner"), -6 * 0.4 * 0.2, 1e-9);
  EXPECT_NEAR(change(0.2, 0, "thicker"), 6 * 0.1 * 0.2, 1e-9);
  EXPECT_NEAR(change(0.8, kFirstModifier, "pressure"), -6 * 0.4 * 0.2, 1e-9);
  EXPECT_NEAR(change(0.2, kSecondModifier, "pressure"), 6 * 0.1 * 0.2, 1e-9);
}

TEST(WidthTool, AClockThatJumpsOrRunsBackChangesNothingMuch) {
  Width w;
  w.fixture.add(straight_stroke({0, 0}, {100, 0}, 2, 2));
  constexpr auto kMin = std::numeric_limits<std::int64_t>::min();
  constexpr auto kMax = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t t : {std::int64_t{0}, std::int64_t{1'000'000},
                               std::int64_t{3'600'000'000'000}, std::int64_t{5}, kMin, kMax}) {
    w.pen.give(
        {.time_ns = t, .position = {50, 0, -1}, .velocity = {}, .pressure = 1.0, .buttons = 0});
  }
  const auto done = w.tool.finish(w.fixture.scene());
  ASSERT_TRUE(done.commit);
  // The brush made two steps of 50 ms and one of 1 ms, at 3 mm/s.
  EXPECT_NEAR(done.commit->changes[0].after->width_mm(0.5), 2.0 + 3.0 * 0.101, 1e-9);
}

TEST(WidthTool, R20_FarFromEveryLineNothingHappensButALineMetLaterIsTaken) {
  Width w;
  w.fixture.add(straight_stroke({0, 0}, {100, 0}, 2, 2));
  w.pen.pressure = 1.0;
  w.pen.line(way({50, 30}, {50, 9}));
  EXPECT_EQ(w.pen.commits, 0);
  w.pen.line(way({50, 30}, {50, 0}));
  EXPECT_EQ(w.pen.commits, 1);
  EXPECT_GT(w.stroke().width_mm(0.5), 2.0);
}

TEST(WidthTool, AGestureThatChangesNothingIsNoStepOfUndo) {
  Width w;
  w.fixture.add(straight_stroke({0, 0}, {100, 0}, 2, 2));
  for (const char* mode : {"brush", "retrace", "scale"}) {
    w.mode(mode);
    w.press({50, 0}, 0.5, 0.3);
    w.pen.up({50, 0});
  }
  EXPECT_EQ(w.pen.commits, 0);
}

TEST(WidthTool, CancelLeavesNothingAndThePenMustBeLifted) {
  for (const char* mode : {"brush", "retrace", "scale"}) {
    SCOPED_TRACE(mode);
    Width w;
    w.mode(mode);
    w.fixture.add(straight_stroke({0, 0}, {100, 0}, 2, 2));
    const Stroke before = w.stroke();
    w.pen.pressure = 1.0;
    w.pen.along(way({30, 0}, {50, 6}));
    w.tool.cancel();
    EXPECT_TRUE(w.overlay().spans.empty());
    w.pen.along(way({50, 6}, {80, 0}));
    w.pen.up({80, 0});
    EXPECT_EQ(w.pen.commits, 0);
    EXPECT_EQ(w.stroke(), before);
  }
}

TEST(WidthTool, ALockedLayerIsLeftAlone) {
  for (const char* mode : {"brush", "retrace", "scale"}) {
    SCOPED_TRACE(mode);
    Width w;
    w.mode(mode);
    w.fixture.add(straight_stroke({0, 0}, {100, 0}, 2, 2));
    const Layer* layer = w.fixture.document.layer(w.fixture.layer);
    LayerState locked = layer->state();
    locked.locked = true;
    w.fixture.apply({"Lock", {}, {{w.fixture.layer, layer->state(), locked, 0, 0}}});
    w.pen.pressure = 1.0;
    w.pen.line(way({30, 0}, {50, 6}));
    EXPECT_EQ(w.pen.commits, 0);
  }
}

TEST(WidthTool, RetraceGivesTheLineTheNewPressureBetweenTheFirstAndTheLastPlace) {
  Width w;
  w.mode("retrace");
  w.set("max_width_mm", 4.3);
  w.fixture.add(wavy());
  const Stroke before = w.stroke();
  const ArcMap map(before);
  const double first = 20.0, last = 70.0;
  w.pen.pressure = 0.75;
  std::vector<Point> points;
  for (double s = first; s <= last; s += 0.1) points.push_back(before.position(map.u_at(s)));
  w.pen.line(points);
  ASSERT_EQ(w.pen.commits, 1);
  const Stroke& after = w.stroke();
  expect_same_curve(before, after);
  for (int i = 0; i <= 600; ++i) {
    const double u = 0.005 * i, s = map.length_at(u);
    if (s < first - 0.05 || s > last + 0.05) {
      EXPECT_NEAR(after.width_mm(u), before.width_mm(u), 1e-9) << s;
    } else if (s > first + 2.3 && s < last - 2.3) {
      EXPECT_NEAR(after.width_mm(u), 0.3 + 4.0 * 0.75, 0.051) << s;
    } else {
      EXPECT_GE(after.width_mm(u), std::min(before.width_mm(u), 3.3) - 0.06) << s;
      EXPECT_LE(after.width_mm(u), 3.36) << s;
    }
  }
  w.fixture.undo();
  EXPECT_EQ(w.stroke(), before);
}

TEST(WidthTool, RetraceGoesBackwardsTooAndUpToTheEnds) {
  Width w;
  w.mode("retrace");
  w.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
  // The pen draws back from the end and presses less and less.
  w.pen.up({60, 0});
  for (int i = 0; i <= 600; ++i) {
    w.pen.give({.time_ns = w.pen.now_ns += 1'000'000,
                .position = {60.2 - 0.1 * i, 0.5, -1},
                .velocity = {},
                .pressure = 1.0 - i / 600.0,
                .buttons = 0});
  }
  w.pen.up({0, 0});
  ASSERT_EQ(w.pen.commits, 1);
  // The low-pass of 20 ms delays the width by 2 mm here.
  for (int i = 0; i <= 60; ++i) {
    EXPECT_NEAR(w.stroke().width_mm(i / 60.0), 0.3 + 5.7 * i / 60.0, 0.3) << i;
  }
  EXPECT_LE(w.stroke().widths().size(), 25u);
}

TEST(WidthTool, RetracingTheSamePartTwiceKeepsTheSecondWithoutAStep) {
  Width w;
  w.mode("retrace");
  w.fixture.add(straight_stroke({0, 0}, {80, 0}, 1, 1));
  w.pen.up({10, 0});
  w.pen.pressure = 0.2;
  w.pen.along(way({10, 0}, {70, 0}));
  w.pen.pressure = 0.9;
  w.pen.along(way({70, 0}, {40, 0}));
  w.pen.up({40, 0});
  const Stroke& after = w.stroke();
  EXPECT_NEAR(after.width_mm(25 / 80.0), 0.3 + 5.7 * 0.2, 0.06);
  EXPECT_NEAR(after.width_mm(55 / 80.0), 0.3 + 5.7 * 0.9, 0.06);
  for (int i = 1; i <= 800; ++i) {
    const double step = after.width_mm(i / 800.0) - after.width_mm((i - 1) / 800.0);
    EXPECT_LE(std::fabs(step), 0.45) << i;  // at most 4 mm over 2 mm, sampled every 0.1 mm
  }
}

TEST(WidthTool, ScaleMultipliesFromTheSnapshot) {
  Width w;
  w.mode("scale");
  w.fixture.add(wavy());
  w.fixture.add(straight_stroke({0, 60}, {50, 60}, 1, 2));
  const Stroke before = w.stroke(0), other = w.stroke(1);
  const Point at = before.position(1.0);
  w.pen.up(at);
  w.pen.along(way(at, {at.x + 5, at.y - 40}));
  w.pen.along(way({at.x + 5, at.y - 40}, {at.x - 20, at.y + 33}));
  w.pen.along(way({at.x - 20, at.y + 33}, {at.x + 3, at.y - 10}));
  w.pen.up(at);
  ASSERT_EQ(w.pen.commits, 1);
  expect_same_curve(w.stroke(0), before);
  ASSERT_EQ(w.stroke(0).widths().size(), before.widths().size());
  for (std::size_t i = 0; i < before.widths().size(); ++i) {
    EXPECT_EQ(w.stroke(0).widths()[i].u, before.widths()[i].u);
    EXPECT_NEAR(w.stroke(0).widths()[i].width_mm,
                before.widths()[i].width_mm * std::exp2(10.0 / WidthTool::kDoublingMm), 1e-9);
  }
  EXPECT_EQ(w.stroke(1), other);  // not selected
}

TEST(WidthTool, ScaleTakesTheSelectedLinesAlongButNotThoseOfLockedLayers) {
  Width w;
  w.mode("scale");
  const StrokeId a = w.fixture.add(straight_stroke({0, 0}, {50, 0}, 1, 2));
  const StrokeId b = w.fixture.add(straight_stroke({0, 60}, {50, 60}, 1, 2));
  const StrokeId c = w.fixture.add(straight_stroke({0, 90}, {50, 90}, 1, 2));
  const LayerId locked = w.fixture.document.new_layer_id();
  w.fixture.apply({"Layer", {}, {{locked, std::nullopt, LayerState{"Locked", true, true}, 0, 1}}});
  const LayerId layer = std::exchange(w.fixture.layer, locked);
  const StrokeId d = w.fixture.add(straight_stroke({0, 120}, {50, 120}, 1, 2));
  w.fixture.layer = layer;
  for (const StrokeId id : {a, b, d}) w.fixture.selection.set_whole(id, 4);
  w.pen.line(way({20, 0}, {20, -20}));
  ASSERT_EQ(w.pen.commits, 1);
  for (const StrokeId id : {a, b})
    EXPECT_NEAR(w.fixture.document.find(id)->width_mm(1.0), 4.0, 1e-9);
  for (const StrokeId id : {c, d}) EXPECT_EQ(w.fixture.document.find(id)->width_mm(1.0), 2.0);
  w.fixture.undo();
  for (const StrokeId id : {a, b}) EXPECT_EQ(w.fixture.document.find(id)->width_mm(1.0), 2.0);
  // A line that is not selected is scaled without the others.
  w.pen.line(way({20, 90}, {20, 70}));
  EXPECT_NEAR(w.fixture.document.find(c)->width_mm(1.0), 4.0, 1e-9);
  EXPECT_EQ(w.fixture.document.find(a)->width_mm(1.0), 2.0);
}

TEST(WidthTool, AClosedLineChangesAcrossItsSeam) {
  StrokeData d;
  d.points = {{0, 0}, {0, 20}, {30, 20}, {30, 0}, {30, -20}, {0, -20}, {0, 0}};
  d.joints = {JointKind::kSmooth, JointKind::kSmooth};
  d.closed = true;
  d.widths = {{0.0, 1.0}, {2.0, 1.0}};
  for (const char* mode : {"brush", "retrace"}) {
    SCOPED_TRACE(mode);
    Width w;
    w.mode(mode);
    w.fixture.add(Stroke::create(d).value());
    w.pen.pressure = 0.9;
    std::vector<Point> points;
    for (double u = 1.8; u < 2.2; u += 0.002) {
      points.push_back(w.stroke().position(u < 2.0 ? u : u - 2.0));
    }
    w.pen.line(points);
    ASSERT_EQ(w.pen.commits, 1);
    EXPECT_GT(w.stroke().width_mm(0.0), 1.05);
    EXPECT_NEAR(w.stroke().width_mm(0.0), w.stroke().width_mm(2.0), 1e-9);
    EXPECT_EQ(w.stroke().width_mm(1.0), 1.0);
  }
}

TEST(WidthTool, HoverShowsTheReachAndTheWidthThere) {
  Width w;
  w.fixture.add(straight_stroke({0, 0}, {100, 0}, 1, 2));
  w.pen.up({50, 3});
  const Overlay o = w.overlay();
  ASSERT_EQ(o.rings.size(), 1u);
  EXPECT_NEAR(o.rings[0].center.x, 50.0, 1e-6);
  EXPECT_EQ(o.rings[0].center.y, 0.0);
  ASSERT_EQ(o.spans.size(), 1u);
  EXPECT_NEAR(o.spans[0].curve.p[0].x, 40.0, 1e-3);
  EXPECT_NEAR(o.spans[0].curve.p[3].x, 60.0, 1e-3);
  ASSERT_EQ(o.labels.size(), 1u);
  EXPECT_EQ(o.labels[0].text, "1.50 mm");
  w.pen.up({50, 30});
  EXPECT_TRUE(w.overlay().rings.empty());
}

TEST(WidthTool, WhatIsShownLastIsWhatIsDone) {
  for (const char* mode : {"brush", "retrace", "scale"}) {
    SCOPED_TRACE(mode);
    Width w;
    w.mode(mode);
    w.fixture.add(wavy());
    std::optional<Edit> shown;
    w.pen.pressure = 0.8;
    for (const Point p : way({20, 10}, {40, -10})) {
      const auto r = w.pen.at({p.x, p.y, -1});
      if (r.preview) shown = r.preview;
    }
    for (int i = 0; i < 10; ++i) {
      const auto r = w.pen.at({40, -10, -1});
      if (r.preview) shown = r.preview;
    }
    w.pen.pressure = 0.5;
    w.pen.up({40, -10});
    ASSERT_TRUE(shown);
    const Stroke& done = w.stroke();
    for (int i = 0; i <= 300; ++i) {
      EXPECT_NEAR(done.width_mm(0.01 * i), shown->changes[0].after->width_mm(0.01 * i), 0.03);
    }
  }
}

}  // namespace
}  // namespace felt::width_test
