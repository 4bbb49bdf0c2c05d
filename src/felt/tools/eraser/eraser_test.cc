#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "felt/base/constants.h"
#include "felt/geometry/nearest.h"
#include "felt/geometry/polyline.h"
#include "felt/haptics/testing/feel_rig.h"
#include "felt/stroke/drawn_profile.h"
#include "felt/stroke/edit/hold_profile.h"
#include "felt/stroke/testing/stroke_probe.h"
#include "felt/stroke/width_profile.h"
#include "felt/tools/eraser/eraser_force.h"
#include "felt/tools/eraser/eraser_tool.h"
#include "felt/tools/pressing.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::eraser_test {
namespace {

using testing::distance_to;
using testing::Fixture;
using testing::Pen;
using testing::random_stroke;
using testing::straight_stroke;
using testing::way;
using testing::operator+;

struct Eraser {
  Fixture fixture;
  EraserTool tool;
  Pen pen{tool, fixture};

  void set(std::string_view id, const OptionValue& value) {
    const auto ok = tool.set_option(id, value);
    ASSERT_TRUE(ok) << ok.error().message;
  }
  void choose_mode(const char* mode) { set("mode", std::string(mode)); }
  /// Sends a sample of a pen with buttons, down or up.
  ToolResult at(Point p, double z, std::uint32_t buttons) {
    PenSample s;
    s.time_ns = pen.now_ns += pen.step_ns;
    s.position = {p.x, p.y, z};
    s.buttons = buttons;
    return pen.give(s);
  }
  [[nodiscard]] Overlay overlay() const {
    Overlay o;
    tool.draw(o);
    return o;
  }
};

TEST(Eraser, R40_AHoleInALineLeavesTwoInItsPlace) {
  Eraser e;
  const StrokeId below = e.fixture.add(straight_stroke({0, 90}, {9, 90}, 1, 1));
  const StrokeId line = e.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 4));
  const StrokeId above = e.fixture.add(straight_stroke({0, 80}, {9, 80}, 1, 1));
  const Document before = e.fixture.document;
  e.pen.line(way({30, -20}, {30, 20}));
  EXPECT_EQ(e.pen.commits, 1);
  EXPECT_EQ(e.fixture.history.undo_label(), "Erase");
  const auto strokes = e.fixture.strokes();
  ASSERT_EQ(strokes.size(), 4u);
  EXPECT_EQ(strokes[0], before.find(below));
  EXPECT_EQ(strokes[3], before.find(above));
  EXPECT_FALSE(e.fixture.document.find(line)) << "the pieces have new ids";
  const double left = strokes[1]->position(1).x, right = strokes[2]->position(0).x;
  EXPECT_NEAR(left, 28.0 - 0.5 * strokes[1]->width_mm(1), 1e-6) << "its cap ends at the rim";
  EXPECT_NEAR(right, 32.0 + 0.5 * strokes[2]->width_mm(0), 1e-6);
  EXPECT_NEAR(strokes[1]->width_mm(1), before.find(line)->width_mm(left / 60), 1e-9);
  EXPECT_NEAR(strokes[2]->width_mm(0), before.find(line)->width_mm(right / 60), 1e-9);
  EXPECT_EQ(strokes[1]->widths().size(), 2u) << "no more breakpoints than needed";
  e.fixture.undo();
  EXPECT_EQ(e.fixture.document, before);
  e.fixture.redo();
  EXPECT_EQ(e.fixture.strokes(), strokes);
}

TEST(Eraser, R39_WhatIsLeftIsTheOriginalOutsideOfTheSweep) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    testing::RandomStroke make(1000 + seed);
    Eraser e;
    e.set("guard_n", 0.0);  // a guarded line keeps its ink
    for (std::uint64_t k = 0; k < 4; ++k) e.fixture.add(random_stroke(10 * seed + k));
    const auto before = e.fixture.strokes();
    const Document original = e.fixture.document;
    std::vector<Point> path;
    for (int k = 0; k < 3; ++k) path.push_back({make.uniform(0, 20), make.uniform(0, 20)});
    e.pen.line(way(path[0], path[1], 0.7) + way(path[1], path[2], 0.7));
    for (const StrokePtr& piece : e.fixture.strokes()) {
      if (std::find(before.begin(), before.end(), piece) != before.end()) continue;
      const double n = piece->segment_count();
      for (double u = 0.0; u <= n; u += 0.04) {
        const Point p = piece->position(u);
        double moved = 1e300;
        for (const StrokePtr& s : before) moved = std::min(moved, distance_to(*s, p));
        ASSERT_LE(moved, 1e-6) << "seed " << seed;
        const double off = std::sqrt(nearest_on_polyline(path, p).distance_squared);
        ASSERT_GE(off, 2.0 + 0.5 * piece->width_mm(u) - 0.01) << "seed " << seed;
      }
    }
    if (e.pen.commits > 0) e.fixture.undo();
    EXPECT_EQ(e.fixture.document, original) << "seed " << seed;
  }
}

/// Returns a random line whose widths are at the minimum or near it, constant or changing.
Stroke thin_line(std::uint64_t seed) {
  testing::RandomStroke random(seed);
  StrokeData data = testing::random_stroke(seed).data();
  const double n = static_cast<double>(data.points.size() / 3);
  const double wide = std::array{kMinWidthMm, 0.0501, 0.3, 2.0}[seed % 4];
  data.widths.clear();
  const int knots = random.pick(2, 7);
  for (int k = 0; k < knots; ++k) {
    const double share = k == 0           ? 0.0
                         : k + 1 == knots ? 1.0
                                          : (k + random.uniform(-0.4, 0.4)) / (knots - 1);
    data.widths.push_back({n * share, random.chance(0.6) ? kMinWidthMm : wide});
  }
  return Stroke::create(std::move(data)).value();
}

TEST(Eraser, R39_TheThinnestLinesLoseNothingOutsideOfTheSweep) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    testing::RandomStroke random(3000 + seed);
    Eraser e;
    e.fixture.add(thin_line(seed));
    const StrokePtr line = e.fixture.strokes().front();
    const auto place = [&] { return Point{random.uniform(0, 20), random.uniform(0, 20)}; };
    const std::vector<Point> path{place(), place(), place()};
    e.pen.line(way(path[0], path[1], 0.7) + way(path[1], path[2], 0.7));
    const auto pieces = e.fixture.strokes();
    for (double u = 0.0; u <= line->segment_count(); u += 0.01) {
      const Point p = line->position(u);
      // The round end of a piece and a piece that is too short to stay (R40).
      const double lost = 0.5 * line->width_mm(u) + 1.3;
      if (std::sqrt(nearest_on_polyline(path, p).distance_squared) < 2.0 + lost) continue;
      double left = 1e300;
      for (const StrokePtr& piece : pieces) left = std::min(left, distance_to(*piece, p));
      ASSERT_LE(left, 1e-6) << u;
    }
  }
}

/// Moves an eraser, 1 mm deep and then at `depth`, across a line that reaches far to both sides.
void press_across(Eraser& e, double depth) {
  e.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 4));
  e.fixture.add(straight_stroke({0, 20}, {60, 20}, 1, 1));
  for (const Point p : way({30, -20}, {30, 0})) e.at(p, -0.5, 0);
  for (int i = 0; i < 30; ++i) e.at({30, 0}, -depth, 0);
  e.pen.up({30, 0});
}

TEST(Eraser, PressingThroughErasesTheWholeLine) {
  const double hard = Pressing(Fixture().surface, Fixture().device).depth_mm_at(kPressThrough);
  for (const char* mode : {"touched", "crossing"}) {
    Eraser e;
    e.set("press_through", true);
    e.choose_mode(mode);
    press_across(e, hard + 0.1);
    ASSERT_EQ(e.fixture.strokes().size(), 1U) << mode << ": only the line that was not met is left";
    EXPECT_EQ(e.pen.commits, 1);
    e.fixture.undo();
    EXPECT_EQ(e.fixture.strokes().size(), 2U);
  }
  Eraser soft;
  soft.set("press_through", true);
  press_across(soft, hard - 0.1);
  EXPECT_EQ(soft.fixture.strokes().size(), 3U) << "a hole leaves two pieces";
  Eraser off;
  press_across(off, hard + 1.0);
  EXPECT_EQ(off.fixture.strokes().size(), 3U);
}

TEST(Eraser, ALandingPenDoesNotPressThrough) {
  Eraser e;
  e.set("press_through", true);
  e.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
  const int few = static_cast<int>(0.04 / (1e-9 * static_cast<double>(e.pen.step_ns)));
  for (int i = 0; i < few; ++i) e.at({30, 0}, -5.0, 0);
  for (int i = 0; i < 100; ++i) e.at({30, 0}, -0.5, 0);
  e.pen.up({30, 0});
  EXPECT_EQ(e.fixture.strokes().size(), 2U);
}

/// Expects the control points of two fixtures to be equal.
void expect_same(const Fixture& a, const Fixture& b, double within_mm) {
  const auto one = a.strokes(), other = b.strokes();
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    const auto& p = one[i]->data().points;
    const auto& q = other[i]->data().points;
    ASSERT_EQ(p.size(), q.size());
    for (std::size_t k = 0; k < p.size(); ++k) EXPECT_LE(distance(p[k], q[k]), within_mm);
  }
}

TEST(Eraser, R39_OneStepIsAHundredSubsteps) {
  for (const char* mode : {"touched", "stroke"}) {
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
      Eraser one, many;
      for (Eraser* e : {&one, &many}) {
        e->choose_mode(mode);
        e->set("guard_n", 0.0);  // samples decide which lines are passed
        for (std::uint64_t k = 0; k < 3; ++k) e->fixture.add(random_stroke(10 * seed + k));
      }
      testing::RandomStroke make(seed);
      const Point a{make.uniform(0, 20), make.uniform(0, 20)};
      const Point b{make.uniform(0, 20), make.uniform(0, 20)};
      one.pen.line({a, b});
      many.pen.line(way(a, b, distance(a, b) / 100.0));
      expect_same(one.fixture, many.fixture, 1e-6);
      for (const Layer& layer : one.fixture.document.layers()) {
        EXPECT_EQ(layer.strokes, many.fixture.document.layer(layer.id)->strokes) << "ids, too";
      }
    }
  }
}

TEST(Eraser, CancelAndMissLeaveNothing) {
  Eraser e;
  e.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
  const Document before = e.fixture.document;
  e.pen.along(way({30, -20}, {30, 20}));
  e.tool.cancel();
  e.pen.along(way({30, 20}, {40, -20}));
  e.pen.up({40, -20});
  EXPECT_EQ(e.fixture.document, before);
  e.pen.line(way({0, 30}, {60, 30}));
  EXPECT_EQ(e.pen.commits, 0) << "a gesture that changes nothing commits nothing";
  EXPECT_EQ(e.fixture.document, before);
}

TEST(Eraser, ThePreviewIsWhatIsCommittedAndOnlyComesWhenItChanges) {
  Eraser e;
  e.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
  std::optional<Edit> shown;
  int previews = 0, samples = 0;
  e.pen.up({30, -20});
  for (const Point p : way({30, -20}, {30, 20})) {
    const ToolResult r = e.pen.at({p.x, p.y, -1});
    ++samples;
    EXPECT_TRUE(r.preview || r.same_preview);
    previews += r.preview ? 1 : 0;
    if (r.preview) shown = r.preview;
  }
  EXPECT_GT(previews, 0);
  EXPECT_LT(previews, 25) << "of " << samples;
  const ToolResult last = e.pen.at({30, 20, 10});
  ASSERT_TRUE(last.commit && shown);
  EXPECT_EQ(*last.commit, *shown);
}

TEST(Eraser, LockedAndHiddenLayersAreNotTouched) {
  for (const LayerState& state : {LayerState{"Ink", true, true}, LayerState{"Ink", false, false}}) {
    for (const char* mode : {"touched", "crossing", "stroke"}) {
      Eraser e;
      e.choose_mode(mode);
      e.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
      e.fixture.apply({"State", {}, {{{1}, LayerState{"Ink"}, state, 0, 0}}});
      const Document before = e.fixture.document;
      e.pen.line(way({30, -20}, {30, 20}));
      EXPECT_EQ(e.fixture.document, before);
    }
  }
}

TEST(Eraser, DotsGoAndClosedStrokesOpen) {
  Eraser e;
  e.fixture.add(straight_stroke({10, 10}, {10.05, 10}, 1, 1));
  e.fixture.add(straight_stroke({40, 10}, {40.05, 10}, 1, 1));
  e.pen.line({{11.9, 10}});
  ASSERT_EQ(e.fixture.strokes().size(), 1u);
  EXPECT_EQ(e.fixture.strokes()[0]->position(0).x, 40.0);
  const Stroke ring =
      Stroke::create(
          {.points = {{80, 50}, {80, 77}, {120, 77}, {120, 50}, {120, 23}, {80, 23}, {80, 50}},
           .joints = {JointKind::kSmooth, JointKind::kSmooth},
           .closed = true,
           .widths = {{0, 1}, {2, 1}}})
          .value();
  const StrokeId id = e.fixture.add(ring);
  e.pen.line(way({70, 50}, {90, 50}));  // across the seam
  ASSERT_EQ(e.fixture.strokes().size(), 2u);
  EXPECT_FALSE(e.fixture.document.find(id));
  EXPECT_FALSE(e.fixture.strokes()[1]->closed());
  e.fixture.undo();
  e.set("radius_mm", 30.0);
  e.pen.line({{100, 50}});
  EXPECT_EQ(e.fixture.strokes().size(), 1u) << "wholly inside: nothing is left of it";
}

TEST(Eraser, R39_TheMiddleOfALineDecidesIfAsked) {
  Eraser e;
  e.set("include_width", false);
  e.fixture.add(straight_stroke({0, 0}, {60, 0}, 6, 6));
  const Document before = e.fixture.document;
  e.pen.line(way({20, 4}, {40, 4}));
  EXPECT_EQ(e.fixture.document, before) << "it covered a third of the ink, but not the middle";
  e.pen.line(way({30, -20}, {30, 20}));
  ASSERT_EQ(e.fixture.strokes().size(), 2u);
  EXPECT_NEAR(e.fixture.strokes()[0]->position(1).x, 28.0, 1e-6);
  EXPECT_NEAR(e.fixture.strokes()[1]->position(0).x, 32.0, 1e-6);
}

TEST(Eraser, R39_ALineThatLosesItsRimBecomesNarrowerThere) {
  Eraser e;
  e.fixture.add(straight_stroke({0, 0}, {60, 0}, 6, 6));
  e.pen.line(way({20, 4}, {40, 4}));  // covers 1 mm of the rim
  ASSERT_EQ(e.fixture.strokes().size(), 1u);
  const Stroke& line = *e.fixture.strokes()[0];
  EXPECT_EQ(line.segment_count(), 1);
  EXPECT_NEAR(line.width_mm(0.5), 4.0, 0.02);
  EXPECT_EQ(line.width_mm(0.2), 6.0);
  EXPECT_EQ(line.width_mm(0.8), 6.0);
}

TEST(Eraser, R39_ALineThatLosesItsRimKeepsItsTone) {
  StrokeData data = straight_stroke({0, 0}, {60, 0}, 6, 6).data();
  data.widths.clear();
  for (int i = 0; i <= 30; ++i) data.widths.push_back({i / 30.0, 6.0, i % 2 == 0 ? 0.2 : 0.9});
  const Stroke before = Stroke::create(std::move(data)).value();
  Eraser e;
  e.fixture.add(before);
  e.pen.line(way({10, 4}, {50, 4}));
  ASSERT_EQ(e.fixture.strokes().size(), 1u);
  const Stroke& line = *e.fixture.strokes()[0];
  EXPECT_NEAR(line.width_mm(0.5), 4.0, 0.02);
  const std::vector<WidthKnot> drawn = drawn_knots(before, 0.001), after = drawn_knots(line, 0.001);
  for (double u = 0.0; u <= 1.0; u += 0.001) {
    ASSERT_NEAR(tone_at(after, u), tone_at(drawn, u), 0.06) << u;
  }
}

TEST(Eraser, R39_BreakpointsAwayFromTheEraserStay) {
  StrokeData data = straight_stroke({0, 0}, {90, 0}, 2, 2).data();
  data.widths.clear();
  for (int i = 0; i <= 30; ++i) data.widths.push_back({i / 30.0, i % 3 == 0 ? 2.0 : 4.0 + i % 2});
  const Stroke before = Stroke::create(std::move(data)).value();
  Eraser e;
  e.fixture.add(before);
  e.pen.line(way({45, 3.5}, {48, 3.5}));  // narrows the line in the middle
  ASSERT_EQ(e.fixture.strokes().size(), 1u);
  const Stroke& line = *e.fixture.strokes()[0];
  EXPECT_NEAR(line.width_mm(16.0 / 30), 3.0, 0.02);
  for (const double from : {0.0, 0.7}) {
    const auto within = [&](const WidthKnot& k) { return from <= k.u && k.u <= from + 0.3; };
    std::vector<WidthKnot> old, kept;
    std::ranges::copy_if(before.widths(), std::back_inserter(old), within);
    std::ranges::copy_if(line.widths(), std::back_inserter(kept), within);
    EXPECT_EQ(kept, old) << "from " << from;
    for (double u = from; u <= from + 0.3; u += 0.001) {
      ASSERT_NEAR(drawn_width_mm(line, u), drawn_width_mm(before, u), 1e-9) << u;
    }
  }
  for (double u = 0.0; u <= 1.0; u += 0.001) {
    if (std::fabs(u - 0.5) < 0.1) continue;
    ASSERT_NEAR(drawn_width_mm(line, u), drawn_width_mm(before, u), 0.012) << u;
  }
}

TEST(Eraser, R39_AClosedLineIsNarrowedAndCutThroughItsSeam) {
  const Stroke ring =
      Stroke::create({.points = {{0, 0}, {0, 27}, {40, 27}, {40, 0}, {40, -27}, {0, -27}, {0, 0}},
                      .joints = {JointKind::kSmooth, JointKind::kSmooth},
                      .closed = true,
                      .widths = {{0, 6}, {2, 6}}})
          .value();
  Eraser e;
  e.fixture.add(ring);
  e.pen.line({{-4.0, 0}});
  ASSERT_EQ(e.fixture.strokes().size(), 1u);
  const Stroke& narrowed = *e.fixture.strokes()[0];
  EXPECT_TRUE(narrowed.closed());
  EXPECT_NEAR(narrowed.width_mm(0.0), 4.0, 0.02);
  EXPECT_EQ(narrowed.width_mm(0.0), narrowed.width_mm(2.0));
  EXPECT_EQ(narrowed.width_mm(0.5), 6.0);
  e.pen.line({{-1.0, 0}});
  ASSERT_EQ(e.fixture.strokes().size(), 1u);
  EXPECT_FALSE(e.fixture.strokes()[0]->closed());
  e.set("radius_mm", 50.0);
  e.pen.line({{20, 0}});
  EXPECT_TRUE(e.fixture.strokes().empty());
}

/// Three rails along x, three posts across them.
void add_grid(Fixture& fixture) {
  for (const double y : {10.0, 30.0, 50.0}) fixture.add(straight_stroke({0, y}, {100, y}, 1, 1));
  for (const double x : {20.0, 50.0, 80.0}) fixture.add(straight_stroke({x, 0}, {x, 60}, 1, 1));
}

TEST(Eraser, CrossingTakesThePartBetweenTheNeighbours) {
  for (const bool modifier : {false, true}) {
    Eraser e;
    if (!modifier) e.choose_mode("crossing");
    add_grid(e.fixture);
    const std::uint32_t buttons = modifier ? kFirstModifier : 0;
    e.at({35, 30.5}, 5, buttons);
    e.at({35, 30.5}, -1, buttons);
    e.at({35, 30.6}, -1, 0);  // the button at the touch decides
    e.at({35, 30.6}, 10, 0);
    ASSERT_EQ(e.fixture.strokes().size(), 7u);
    const auto strokes = e.fixture.strokes();
    EXPECT_NEAR(strokes[1]->position(1).x, 20.0, 1e-9);
    EXPECT_NEAR(strokes[2]->position(0).x, 50.0, 1e-9);
    EXPECT_EQ(strokes[2]->position(1), (Point{100, 30}));
  }
}

TEST(Eraser, CrossingTakesATailWithoutWhatItHangsOn) {
  Eraser e;
  e.choose_mode("crossing");
  e.fixture.add(straight_stroke({0, 0}, {100, 0}, 1, 1));
  e.fixture.add(straight_stroke({50, 40}, {50, -1.5}, 1, 1));  // 1.5 mm too long
  e.pen.line({{50, -1}, {50.05, -1.03}, {50, -0.97}});         // nearer than the radius to both
  const auto strokes = e.fixture.strokes();
  ASSERT_EQ(strokes.size(), 2u);
  EXPECT_EQ(*strokes[0], straight_stroke({0, 0}, {100, 0}, 1, 1));
  EXPECT_LE(distance(strokes[1]->position(1), {50, 0}), 1e-9);
}

TEST(Eraser, CrossingTakesEveryLineThatThePenGoesThrough) {
  Eraser e;
  e.choose_mode("crossing");
  add_grid(e.fixture);
  e.pen.line({{35, 5}, {35, 55}});  // one step through all rails
  ASSERT_EQ(e.fixture.strokes().size(), 9u);
  for (std::size_t i = 0; i < 6; i += 2) {
    EXPECT_NEAR(e.fixture.strokes()[i]->position(1).x, 20.0, 1e-9);
    EXPECT_NEAR(e.fixture.strokes()[i + 1]->position(0).x, 50.0, 1e-9);
  }
  e.fixture.undo();
  EXPECT_EQ(e.fixture.strokes().size(), 6u);
}

TEST(Eraser, StrokeTakesTheWholeLineAndNeverBySurprise) {
  Eraser by_default;
  add_grid(by_default.fixture);
  by_default.pen.line({{35, 30}});
  EXPECT_EQ(by_default.fixture.strokes().size(), 7u) << "touched is the default";
  Eraser e;
  add_grid(e.fixture);
  e.at({35, 30}, -1, kSecondModifier);
  e.at({35, 30}, 10, kSecondModifier);
  ASSERT_EQ(e.fixture.strokes().size(), 5u);
  EXPECT_EQ(e.fixture.strokes()[0]->position(0).y, 10.0);
  EXPECT_EQ(e.fixture.strokes()[1]->position(0).y, 50.0);
}

TEST(Eraser, TheRingAndWhatWouldGoAreShownBefore) {
  Eraser e;
  add_grid(e.fixture);
  EXPECT_TRUE(e.overlay().rings.empty()) << "no pen yet";
  e.pen.up({35, 30.5});
  ASSERT_EQ(e.overlay().rings.size(), 1u);
  EXPECT_EQ(e.overlay().rings[0].center, (Point{35, 30.5}));
  EXPECT_EQ(e.overlay().rings[0].radius_mm, 2.0);
  EXPECT_TRUE(e.overlay().spans.empty());
  e.at({35, 30.5}, 10, kFirstModifier);
  ASSERT_EQ(e.overlay().spans.size(), 1u);
  EXPECT_EQ(e.overlay().spans[0].role, Overlay::Role::kCut);
  EXPECT_NEAR(e.overlay().spans[0].curve.p[0].x, 20.0, 1e-9);
  EXPECT_NEAR(e.overlay().spans[0].curve.p[3].x, 50.0, 1e-9);
  e.at({21, 31}, 10, kSecondModifier);
  EXPECT_EQ(e.overlay().spans.size(), 2u) << "a rail and a post";
  e.at({21, 40.0}, -1, kSecondModifier);
  EXPECT_TRUE(e.overlay().spans.empty()) << "it is gone already";
  EXPECT_EQ(e.overlay().rings.size(), 1u);
}

TEST(Eraser, RandomGesturesInEveryModeOnlyTakeAwayAndAreTakenBack) {
  int commits = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    testing::RandomStroke make(seed);
    Eraser e;
    e.choose_mode(kEraserModes[seed % 3].data());
    e.set("radius_mm", make.uniform(0.2, 6.0));
    e.set("include_width", make.chance(0.5));
    for (std::uint64_t k = 0; k < 5; ++k) e.fixture.add(random_stroke(100 * seed + k));
    const auto before = e.fixture.strokes();
    const Document original = e.fixture.document;
    const Point a{make.uniform(0, 20), make.uniform(0, 20)};
    const Point b{make.uniform(0, 20), make.uniform(0, 20)};
    e.pen.line(way(a, b, make.uniform(0.01, 5.0)));
    for (const StrokePtr& piece : e.fixture.strokes()) {
      const double n = piece->segment_count();
      for (double u = 0.0; u <= n; u += 0.1) {
        double off = 1e300;
        for (const StrokePtr& s : before) off = std::min(off, distance_to(*s, piece->position(u)));
        ASSERT_LE(off, 1e-6) << "seed " << seed;
      }
    }
    commits += e.pen.commits;
    if (e.pen.commits > 0) e.fixture.undo();
    EXPECT_EQ(e.fixture.document, original) << "seed " << seed;
  }
  EXPECT_GT(commits, 40);
}

TEST(Eraser, WhatIsLeftIsShownWithinAFrameOfThePen) {
  // The pen touches more strokes than one sample can cut. Then the pen rests.
  Eraser e;
  e.set("radius_mm", 20.0);
  for (int i = 0; i < 300; ++i) e.fixture.add(straight_stroke({0, 0.1 * i}, {100, 0.1 * i}, 1, 1));
  e.pen.down({50, -30});
  std::size_t shown = 0;
  for (int i = 0; i < 100; ++i) {
    const ToolResult r = e.pen.at({50, 15, -1});
    EXPECT_TRUE(r.preview || r.same_preview);
    if (r.preview) shown = r.preview->changes.size();
  }
  EXPECT_EQ(shown, 900u) << "each stroke goes and leaves two";
  e.pen.up({50, 15});
  EXPECT_EQ(e.fixture.strokes().size(), 600u);
}

/// Returns the target of a hand that rests, slides, or rubs back and forth.
Vec3 hand(int scenario, double time, double aim) {
  const double x = std::min(time / 0.4, 1.0), z = 1 + (aim - 1) * x * x * (3 - 2 * x);
  const double t = std::max(0.0, time - 0.7);
  if (scenario == 0) return {0, 0, z};
  if (scenario == 1) return {20 * t, 5 * t, z};
  return {20 * std::sin(kTau * t), 8 * std::sin(1.5 * kTau * t), z};
}

TEST(Eraser, R72_AGuardedLineKeepsItsInkUntilThePenPushesOn) {
  for (const bool has_force : {true, false}) {
    Eraser e;
    if (!has_force) e.fixture.device.max_force_n = 0.0;
    e.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
    const StrokeId other = e.fixture.add(straight_stroke({30, -20}, {30, 20}, 1, 1));
    e.pen.line(way({10, 0}, {28, 0}));  // 0.5 mm over its ink
    EXPECT_EQ(e.fixture.document.find(other) != nullptr, has_force);
    e.pen.line(way({10, 0}, {29.5, 0}));
    EXPECT_FALSE(e.fixture.document.find(other)) << "2 mm over its ink";
  }
}

TEST(Eraser, R72_AFastPenErasesTheLinesThatItPassesBetweenSamples) {
  Eraser e;
  e.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
  const StrokeId other = e.fixture.add(straight_stroke({30, -20}, {30, 20}, 1, 1));
  e.pen.line({{10, 0}, {40, 0}});
  EXPECT_FALSE(e.fixture.document.find(other));
}

TEST(Eraser, R72_TheModeOfTheTouchGuardsUntilTheLift) {
  for (const bool presses : {true, false}) {  // the first modifier, in the middle of the gesture
    Eraser e;
    e.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
    const StrokeId other = e.fixture.add(straight_stroke({30, -20}, {30, 20}, 1, 1));
    e.at({10, 0}, -1.0, presses ? 0 : kFirstModifier);
    for (double x = 10.0; x <= (presses ? 28.0 : 40.0); x += 0.2) {
      e.at({x, 0}, -1.0, presses ? kFirstModifier : 0);
    }
    for (int i = 0; i < 100; ++i) e.at({presses ? 28.0 : 40.0, 0}, 5.0, 0);
    EXPECT_EQ(e.fixture.document.find(other) != nullptr, presses);
  }
}

TEST(EraserForce, R41_DragsMoreThanTwiceAsMuchAsAPencilAndIsCalm) {
  Fixture fixture;
  double worst = 0.0;
  for (int delay = 0; delay <= 1; ++delay) {
    rig::for_each_grip(0.001, delay, [&](const rig::Setup& setup) {
      fixture.device = setup.capabilities();
      for (int scenario = 0; scenario < 3; ++scenario) {
        rig::Bench bench(setup, make_eraser_force({}, fixture.scene()), {0, 0, 1});
        const double aim = rig::aim_z_mm(setup.hand, 1.0, 500.0);
        const auto target = [&](double time) { return hand(scenario, time, aim); };
        bench.run(0.8, target);
        bench.begin_measuring();
        double drag = 0.0, push = 0.0;
        bench.run(1.0, target, [&](const rig::Bench& b) {
          drag += norm(Force{b.force().x, b.force().y, 0.0});
          push += b.force().z;
        });
        EXPECT_LT(bench.figures().hf_n, 0.03) << setup.name() << ", scenario " << scenario;
        worst = std::max(worst, bench.figures().hf_n);
        // A soft hand does not slide steadily yet; friction drags it along.
        if (scenario == 1 && setup.hand.stiffness_n_per_m >= 300) {
          EXPECT_NEAR(drag / push, 0.6, 0.06) << setup.name();
          EXPECT_GE(drag / push, 2.0 * friction_of(*find_medium("pencil"), fixture.surface));
        }
      }
    });
  }
  RecordProperty("worst_hf_n", std::to_string(worst));
}

TEST(EraserForce, R42_LeaningOnItForFourSecondsDoesNotCreep) {
  Fixture fixture;
  for (int delay = 0; delay <= 1; ++delay) {
    const rig::Setup setup{rig::kHands[0], rig::kStyluses[0], 0.001, delay};
    fixture.device = setup.capabilities();
    rig::Bench bench(setup, make_eraser_force({}, fixture.scene()), {0, 0, 0});
    const double aim_z = rig::aim_z_mm(setup.hand, 1.0, 500.0);
    const double tilt = 0.5 * 0.6 * 1.0;  // half of mu Fn
    const double aim_x = 1e3 * tilt * (1 / setup.hand.stiffness_n_per_m + 1 / 600.0);
    const auto target = [&](double t) -> Vec3 {
      const double x = std::clamp((t - 0.8) / 0.4, 0.0, 1.0);
      return {aim_x * x * x * (3 - 2 * x), 0, aim_z};
    };
    bench.run(1.5, target);
    const Point foot = bench.memory().bristle;
    const Vec3 place = bench.position();
    bench.run(4.0, target);
    EXPECT_LT(distance(foot, bench.memory().bristle), 0.05) << setup.name();
    EXPECT_LT(std::fabs(bench.position().x - place.x), 0.05) << setup.name();
  }
}

TEST(EraserForce, StrengthScalesTheDragAndTheFeelIsOneFeel) {
  Eraser e;
  const auto drag = [&] {
    const ForceModel model = e.tool.force(e.fixture.scene());
    ForceMemory memory;
    Force f;
    for (double x = 0.0; x < 5.0; x += 0.05) {
      memory.begin_tick(0.001);
      f = model(rig::pen_at({x, 0, -2}), memory);
    }
    return -f.x / f.z;
  };
  EXPECT_NEAR(drag(), 0.6, 0.03);
  const std::uint32_t id = e.tool.force(e.fixture.scene()).fade_id();
  e.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
  e.pen.along(way({30, -5}, {30, 5}));
  EXPECT_EQ(e.tool.force(e.fixture.scene()).fade_id(), id);
  e.pen.up({30, 5});
  e.set("strength", 0.5);
  EXPECT_NEAR(drag(), 0.3, 0.03);
  e.set("strength", 0.0);
  EXPECT_NEAR(drag(), 0.0, 1e-9);
  EXPECT_NE(e.tool.force(e.fixture.scene()).fade_id(), id);
}

}  // namespace
}  // namespace felt::eraser_test
