#include "felt/tools/pencil/pencil_tool.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "felt/base/constants.h"
#include "felt/tools/pencil/pencil_force.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::pencil_test {
namespace {

using testing::arc;
using testing::Fixture;
using testing::Pen;
using testing::way;
using testing::operator+;

struct Pencil {
  Fixture fixture;
  PencilTool tool;
  Pen pen{tool, fixture};

  void set(std::string_view id, const OptionValue& value) {
    const auto ok = tool.set_option(id, value);
    ASSERT_TRUE(ok) << ok.error().message;
  }
  void choose(std::string_view id, const char* value) { set(id, std::string(value)); }
  /// Returns the only stroke.
  [[nodiscard]] const Stroke& stroke() const {
    EXPECT_EQ(fixture.strokes().size(), 1u);
    return *fixture.strokes().at(0);
  }
  [[nodiscard]] Overlay overlay() const {
    Overlay o;
    tool.draw(o);
    return o;
  }
};

double largest_gap(const Stroke& stroke, const std::vector<Point>& points) {
  double worst = 0.0;
  for (const Point p : points) {
    double best = 1e300;
    for (int i = 0; i < stroke.segment_count(); ++i) {
      const Cubic c = stroke.segment(i);
      for (int k = 0; k <= 500; ++k) best = std::min(best, distance(p, evaluate(c, 0.002 * k)));
    }
    worst = std::max(worst, best);
  }
  return worst;
}

TEST(Pencil, OneLineIsOneStrokeAndOneUndoStep) {
  Pencil p;
  p.fixture.color = {10, 20, 30, 255};
  p.choose("medium", "crayon");
  const auto points = way({20, 20}, {80, 40});
  p.pen.line(points);
  EXPECT_EQ(p.pen.commits, 1);
  EXPECT_EQ(p.fixture.history.undo_count(), 1u);
  EXPECT_EQ(p.fixture.history.undo_label(), "Draw");
  EXPECT_EQ(p.stroke().medium(), "crayon");
  EXPECT_EQ(p.stroke().color(), (Rgba{10, 20, 30, 255}));
  EXPECT_LE(largest_gap(p.stroke(), points), 0.15 + 0.1);  // the check samples every 0.2 mm
  const StrokePtr drawn = p.fixture.strokes()[0];
  p.fixture.undo();
  EXPECT_EQ(p.fixture.document, Document());
  p.fixture.redo();
  EXPECT_EQ(p.fixture.strokes()[0], drawn);
}

TEST(Pencil, AModifierDrawsAStraightLineFromTheTouch) {
  Pencil p;
  p.pen.pressure = 0.5;
  p.pen.up({10, 10});
  p.pen.along(way({10, 10}, {30, 40}));
  p.pen.buttons = kFirstModifier;
  p.pen.along(way({30, 40}, {70, 30}));
  const Overlay seen = p.overlay();
  ASSERT_FALSE(seen.ink.empty());
  EXPECT_EQ(seen.ink.back().curve.p[3], (Point{70, 30}));
  EXPECT_LT(distance(evaluate(seen.ink.front().curve, 0.5), {10, 10}), 1.0);
  p.pen.buttons = 0;  // released just before the lift
  p.pen.down({70, 30});
  p.pen.up({70, 30});
  ASSERT_EQ(p.stroke().segment_count(), 1);
  EXPECT_EQ(p.stroke().position(0), (Point{10, 10}));
  EXPECT_EQ(p.stroke().position(1), (Point{70, 30}));
  EXPECT_EQ(p.stroke().widths().size(), 2U) << "constant pressure";
  EXPECT_EQ(p.fixture.history.undo_label(), "Draw");
  p.pen.line(way({10, 60}, {30, 80}) + way({30, 80}, {50, 60}));
  EXPECT_GT(p.fixture.strokes().back()->bounds().y1, 79) << "the next line is free again";
}

/// Draws a bent line with a modifier down from one time to another, ms after the touch, at each
/// sample or at every other one, and returns the number of segments, which is 1 if it is straight.
int segments_with_press(std::int64_t from_ms, std::int64_t to_ms, bool bounces = false) {
  Pencil p;
  const auto points = way({10, 60}, {30, 80}) + way({30, 80}, {50, 60});
  for (std::int64_t ms = -500; ms < static_cast<std::int64_t>(points.size()); ++ms) {
    const bool is_down = ms >= from_ms && ms < to_ms && !(bounces && ms % 2 != 0);
    p.pen.buttons = is_down ? kSecondModifier : 0;
    if (ms < 0) p.pen.up(points.front());
    if (ms >= 0) p.pen.down(points[static_cast<std::size_t>(ms)]);
  }
  p.pen.up(points.back());
  return p.stroke().segment_count();
}

TEST(Pencil, AModifierThatIsNotMeantLeavesTheLineFree) {
  constexpr std::int64_t kEndMs = 10'000;
  EXPECT_GT(segments_with_press(100, 101), 1);
  EXPECT_GT(segments_with_press(100, 350), 1) << "shorter than 0.3 s";
  EXPECT_GT(segments_with_press(0, 250), 1) << "at the touch";
  EXPECT_GT(segments_with_press(-500, -1), 1) << "in the air";
  EXPECT_GT(segments_with_press(400, kEndMs), 1) << "at the lift";
  EXPECT_GT(segments_with_press(-500, kEndMs, true), 1) << "bounces all the time";
  EXPECT_EQ(segments_with_press(100, 450), 1) << "stays straight";
  EXPECT_EQ(segments_with_press(-300, 50), 1) << "meant before the touch";
  EXPECT_EQ(segments_with_press(0, kEndMs), 1);
}

TEST(Pencil, AQuickLineIsStraightIfTheModifierIsDownAllTheTime) {
  Pencil p;
  p.pen.buttons = kFirstModifier;
  p.pen.line(way({10, 10}, {20, 20}, 0.5) + way({20, 20}, {30, 10}, 0.5));
  EXPECT_EQ(p.stroke().segment_count(), 1);
  EXPECT_LT(p.pen.now_ns, 100'000'000);
}

TEST(Pencil, AStraightLineHasTheWidthThatThePenHadAtEachPlace) {
  Pencil p;
  p.pen.buttons = kFirstModifier;
  p.pen.up({0, 0});
  // The pen goes beyond the end and back, and presses harder beyond the end.
  for (const Point q : way({0, 0}, {90, 0})) {
    p.pen.pressure = std::min(1.0, 0.01 * q.x);
    p.pen.down(q);
  }
  p.pen.pressure = 1.0;
  p.pen.along(way({90, 0}, {60, 0}));
  p.pen.up({60, 0});
  const Stroke& line = p.stroke();
  EXPECT_EQ(line.position(1), (Point{60, 0}));
  for (const double u : {0.25, 0.5, 0.75}) {
    EXPECT_NEAR(line.width_mm(u), 0.3 + 5.7 * 0.6 * u, 0.3) << "low-pass of 20 ms at 0.1 m/s";
  }
}

TEST(Pencil, TheSecondModifierDrawsInStepsOf15Degrees) {
  Pencil p;
  p.pen.buttons = kSecondModifier | kFirstModifier;
  p.pen.line(way({50, 50}, {90, 53}));
  EXPECT_EQ(p.stroke().position(1), (Point{90, 50}));
}

// A straight line stays straight when its ends snap, instead of bending towards the targets.
TEST(Pencil, AStraightLineSnapsAsAWhole) {
  Pencil p;
  p.choose("snap", "both");
  p.fixture.add(testing::straight_stroke({60, 30}, {100, 30}, 1, 1));
  p.pen.buttons = kFirstModifier;
  p.pen.up({10, 30.4});
  p.pen.along(way({10, 30.4}, {55, 30.5}, 0.1));
  p.pen.along(way({55, 30.5}, {59.4, 30.5}, 0.02));
  p.pen.up({59.4, 30.5});
  const StrokePtr drawn = p.fixture.strokes().back();
  ASSERT_EQ(drawn->segment_count(), 1);
  EXPECT_EQ(drawn->position(1), (Point{60, 30}));
  EXPECT_NEAR(drawn->position(0.5).y, 30.2, 1e-9);
}

TEST(Pencil, NothingIsShownOrDoneInTheAir) {
  Pencil p;
  for (const Point q : way({0, 0}, {50, 50})) p.pen.at({q.x, q.y, 3});
  EXPECT_EQ(p.fixture.document, Document());
  EXPECT_TRUE(p.overlay().ink.empty());
}

TEST(Pencil, R14_HarderIsBroaderUpToTheClamps) {
  double last = 0.0;
  for (double depth = 0.01; depth < 6.0; depth *= 1.2) {
    Pencil p;
    p.pen.depth = depth;
    p.pen.line(way({0, 0}, {50, 0}));
    const double width = p.stroke().width_mm(0.5 * p.stroke().segment_count());
    EXPECT_GE(width, last);
    last = width;
    if (depth <= 0.2) {
      EXPECT_EQ(width, 0.3);  // F0 = 0.1 N
    }
    if (depth >= 4.0) {
      EXPECT_EQ(width, 6.0);  // F1 = 2 N
    }
  }
  EXPECT_EQ(last, 6.0);
}

TEST(Pencil, WidthsInStepsAreHeldWhileThePushGrows) {
  Pencil p;
  p.set("width_steps", true);
  p.choose("snap", "off");
  const std::vector<Point> path = way({0, 0}, {100, 0});
  p.pen.depth = 0.3;
  for (std::size_t i = 0; i < path.size(); ++i) {
    p.pen.depth = 0.3 + 4.0 * static_cast<double>(i) / static_cast<double>(path.size());
    p.pen.at({path[i].x, path[i].y, -p.pen.depth});
  }
  p.pen.up({100, 0});
  const Stroke& stroke = p.stroke();
  const std::vector<double> steps = {0.3, 0.7, 1.4, 2.8, 5.6};
  int held = 0;
  std::vector<bool> met(steps.size());
  for (int i = 0; i < 1000; ++i) {
    const double width = stroke.width_mm(0.001 * i * stroke.segment_count());
    for (std::size_t k = 0; k < steps.size(); ++k) {
      if (std::abs(width - steps[k]) > 0.15) continue;  // the tolerance of widths
      ++held;
      met[k] = true;
    }
  }
  EXPECT_GE(held, 700);  // 260 without steps
  EXPECT_EQ(met, std::vector<bool>(steps.size(), true));
}

TEST(Pencil, WidthsInStepsAreFeltAsClicksByDevicesThatSenseDepth) {
  Pencil p;
  PencilSettings settings;
  settings.medium = "pencil";
  settings.ink.width_map.min_mm = 0.3;
  settings.ink.width_map.max_mm = 6.0;
  EXPECT_EQ(width_clicks(settings, p.fixture.scene()).size(), 0U);
  settings.width_steps = true;
  EXPECT_EQ(width_clicks(settings, p.fixture.scene()).size(), 4U);
  p.fixture.device.senses_pressure = true;
  EXPECT_EQ(width_clicks(settings, p.fixture.scene()).size(), 0U);
}

TEST(Pencil, R14_TheSameForceDrawsTheSameWidthOnEverySurface) {
  for (const double force : {0.2, 0.5, 0.8, 1.1}) {
    std::vector<double> widths;
    for (const SurfaceMaterial& surface : surface_materials()) {
      Pencil p;
      p.fixture.surface = surface;
      p.pen.depth = force / (0.001 * surface.stiffness_n_per_m);
      p.pen.line(way({0, 0}, {50, 0}));
      widths.push_back(p.stroke().width_mm(0.5 * p.stroke().segment_count()));
    }
    for (const double w : widths) EXPECT_NEAR(w, widths[0], 1e-9);
    EXPECT_NEAR(widths[0], 0.3 + 5.7 * (force - 0.1) / 1.1, 1e-9);
  }
}

TEST(Pencil, R18_TabletPressureDecidesAndAMouseHasAConstant) {
  for (const double pressure : {0.0, 0.25, 0.5, 1.0}) {
    Pencil p;
    p.pen.pressure = pressure;
    p.pen.depth = 3.0;  // ignored
    p.pen.line(way({0, 0}, {50, 0}));
    EXPECT_NEAR(p.stroke().width_mm(0.5 * p.stroke().segment_count()), 0.3 + 5.7 * pressure, 1e-9);
  }
  for (const double depth : {0.01, 1.0, 5.0}) {
    Pencil p;
    p.fixture.device.sensed_axes = 2;
    p.pen.depth = depth;
    p.pen.line(way({0, 0}, {50, 0}));
    EXPECT_NEAR(p.stroke().width_mm(0.5 * p.stroke().segment_count()), 0.3 + 5.7 * 0.5, 1e-9);
  }
}

TEST(Pencil, ChatterOnTheSurfaceDoesNotBreakTheLine) {
  Pencil p;
  testing::RandomStroke random(3);
  p.pen.up({0, 0});
  for (const Point q : way({0, 0}, {100, 10}, 0.05)) {
    p.pen.at({q.x, q.y, random.uniform(-0.03, 0.03)});
  }
  p.pen.up({100, 10});
  EXPECT_EQ(p.pen.commits, 1);
  EXPECT_LE(largest_gap(p.stroke(), way({0, 0}, {99, 9.9}, 1.0)), 0.8);
}

TEST(Pencil, ALiftBetweenTwoLinesMakesTwo) {
  for (const double height : {0.1, 5.0}) {
    Pencil p;
    p.choose("snap", "off");
    p.pen.along(way({0, 0}, {20, 0}));
    for (int k = 0; k < 40; ++k) p.pen.at({20, 0, height});
    p.pen.along(way({20, 0}, {40, 0}));
    p.pen.up({40, 0});
    EXPECT_EQ(p.pen.commits, 2);
    EXPECT_EQ(p.fixture.strokes().size(), 2u);
  }
}

TEST(Pencil, ALowSlowLiftLeavesNoTail) {
  Pencil p;
  p.pen.along(way({0, 0}, {20, 0}));
  // The hand continues to move, just above the surface.
  for (const Point q : way({20, 0}, {20, 10}, 0.2)) p.pen.at({q.x, q.y, 0.2});
  EXPECT_EQ(p.pen.commits, 1);
  EXPECT_NEAR(tip_point(p.stroke(), StrokeTip::kEnd).y, 0.0, 0.2);
}

TEST(Pencil, CancelLeavesNothingAndWaitsForALift) {
  Pencil p;
  p.pen.along(way({0, 0}, {50, 0}));
  EXPECT_FALSE(p.overlay().ink.empty());
  p.tool.cancel();
  EXPECT_TRUE(p.overlay().ink.empty());
  p.pen.along(way({50, 0}, {90, 0}));
  p.pen.up({90, 0});
  EXPECT_EQ(p.fixture.document, Document());
  p.pen.line(way({0, 0}, {50, 0}));
  EXPECT_EQ(p.fixture.strokes().size(), 1u);
  // If the pen only hovers, the line does not wait.
  p.tool.cancel();
  p.pen.line(way({0, 30}, {50, 30}));
  EXPECT_EQ(p.fixture.strokes().size(), 2u);
}

TEST(Pencil, FinishKeepsTheInk) {
  Pencil p;
  p.pen.along(way({0, 0}, {50, 0}));
  const ToolResult result = p.tool.finish(p.fixture.scene());
  ASSERT_TRUE(result.commit);
  p.fixture.apply(*result.commit);
  EXPECT_NEAR(tip_point(p.stroke(), StrokeTip::kEnd).x, 50, 0.15);
  EXPECT_FALSE(p.tool.finish(p.fixture.scene()).commit);
  // The same contact continues: it does not begin another line.
  p.pen.along(way({50, 0}, {90, 0}));
  p.pen.up({90, 0});
  EXPECT_EQ(p.fixture.strokes().size(), 1u);
}

TEST(Pencil, ADotIsADot) {
  Pencil p;
  p.pen.up({10, 10});
  p.pen.down({10, 10});
  p.pen.up({10, 10});
  EXPECT_LE(norm(tip_point(p.stroke(), StrokeTip::kEnd) - Point{10, 10}), 0.1);
}

TEST(Pencil, R51_TheDocumentDoesNotDependOnForces) {
  const auto draw = [](int ask_every, double strength) {
    Pencil p;
    p.set("strength", strength);
    ForceMemory memory;
    int count = 0;
    p.pen.up({20, 20});
    for (const Point q : arc({50, 50}, 30, 0, 355) + way({80, 47}, {80, 50})) {
      p.pen.down(q);
      if (ask_every > 0 && ++count % ask_every == 0) {
        const ForceModel model = p.tool.force(p.fixture.scene());
        PenSample s;
        s.position = {q.x, q.y, -1};
        (void)model(s, memory);
        (void)p.overlay();
      }
    }
    p.pen.up({80, 50});
    return p.fixture.document;
  };
  const Document ignored = draw(0, 1.0);
  EXPECT_EQ(ignored.stroke_count(), 1u);
  EXPECT_EQ(draw(1, 1.0), ignored);
  EXPECT_EQ(draw(7, 1.0), ignored);
  EXPECT_EQ(draw(1, 0.0), ignored);
}

TEST(Pencil, R43_ARingDrawnToItsStartIsClosed) {
  const auto ring = arc({50, 50}, 30, 0, 357);  // ends 1.6 mm from its start
  for (const char* mode : {"snap", "both"}) {
    Pencil p;
    p.choose("snap", mode);
    p.pen.line(ring);
    EXPECT_TRUE(p.stroke().closed()) << mode;
    EXPECT_EQ(p.stroke().joint(0), JointKind::kSmooth);
    EXPECT_LE(distance(p.stroke().position(0), {80, 50}), 0.15);
  }
  for (const char* mode : {"off", "force"}) {
    Pencil p;
    p.choose("snap", mode);
    p.pen.line(ring);
    EXPECT_FALSE(p.stroke().closed()) << mode;
    EXPECT_LE(distance(tip_point(p.stroke(), StrokeTip::kEnd), ring.back()), 0.15);
  }
  // If the gap is larger than the snap radius, the user feels the attraction, but the line is not
  // closed.
  Pencil p;
  p.pen.line(arc({50, 50}, 30, 0, 350));
  EXPECT_FALSE(p.stroke().closed());
}

TEST(Pencil, R43_ForceOnlyNeverMovesGeometry) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    testing::RandomStroke random(seed);
    Pencil off, force;
    off.choose("snap", "off");
    force.choose("snap", "force");
    Point at{50, 50};
    for (int line = 0; line < 5; ++line) {
      std::vector<Point> points{at};
      for (int k = random.pick(1, 5); k > 0; --k) {
        const Point to{random.uniform(40, 60), random.uniform(40, 60)};
        points = points + way(points.back(), to, 0.2);
      }
      off.pen.line(points);
      force.pen.line(points);
      at = random.chance(0.5) ? points.back() : points.front() + Vec{1, 0};
    }
    EXPECT_EQ(off.fixture.document, force.fixture.document) << seed;
    EXPECT_EQ(off.fixture.strokes().size(), 5u);
  }
}

TEST(Pencil, R43_TheForceIsZeroAtTheTargetAndOutOfReach) {
  // Returns the pull towards the end on a pen in the air that has come slowly, d mm before the end.
  const auto pull = [](double d, const char* mode) {
    Pencil p;
    p.choose("snap", mode);
    p.fixture.add(testing::straight_stroke({50, 50}, {50, 150}, 1, 1));
    for (const double x : {40.0, 44.0}) p.pen.at({x, 50, 1.0});
    p.pen.step_ns = 10'000'000;
    for (double x = 44; x < 50 - d; x += 0.1) p.pen.at({x, 50, 1.0});
    p.pen.at({50 - d, 50, 1.0});
    ForceMemory memory;
    PenSample s;
    s.position = {50 - d, 50, 1.0};
    return p.tool.force(p.fixture.scene())(s, memory).x;
  };
  EXPECT_EQ(pull(3.0, "both"), 0.0);
  EXPECT_EQ(pull(1.5, "both"), 0.0);
  EXPECT_NEAR(pull(1.3, "both"), 0.1, 1e-12);
  EXPECT_NEAR(pull(0.5, "both"), 0.1 * 0.5 / 0.75, 1e-12);
  EXPECT_EQ(pull(0.0, "both"), 0.0);
  EXPECT_EQ(pull(1.3, "snap"), 0.0);
  EXPECT_NEAR(pull(1.3, "force"), 0.1, 1e-12);
}

TEST(Pencil, R70_ATargetDrawsAPenThatRestsBesideItBeyondTheFrictionOfTheDevice) {
  Pencil p;
  p.fixture.device.friction_n = 0.26;
  p.fixture.add(testing::straight_stroke({50, 50}, {50, 150}, 1, 1));
  p.pen.step_ns = 2'500'000;
  for (double x = 20.0; x < 48.5; x += 0.1) p.pen.down({x, 50});
  const auto pull_n = [&] {
    ForceMemory memory;
    memory.begin_tick(1e-3);
    PenSample sample;
    sample.position = {48.5, 50, 1.0};  // above the surface, without friction
    static_cast<void>(p.tool.force(p.fixture.scene())(sample, memory));
    for (const ForceTerms::Term& term : memory.terms) {
      if (std::string_view(term.name) == "snap") return term.force.x;
    }
    return 0.0;
  };
  for (int i = 0; i < 20; ++i) p.pen.down({48.5, 50});
  EXPECT_NEAR(pull_n(), 0.1, 1e-9) << "it may only pass";
  for (int i = 0; i < 80; ++i) p.pen.down({48.5, 50});
  EXPECT_GE(pull_n(), 0.44);
}

TEST(Pencil, R44_AShortScribbleInsideReachNeverCloses) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    testing::RandomStroke random(seed);
    Pencil p;
    std::vector<Point> points{{50, 50}};
    for (int k = 0; k < 30; ++k) {
      const double a = random.uniform(0, 6.28), r = random.uniform(0, 7.9);
      points = points + way(points.back(), {50 + r * std::cos(a), 50 + r * std::sin(a)}, 0.2);
    }
    points = points + way(points.back(), {50, 50}, 0.2);
    p.pen.line(points);
    EXPECT_FALSE(p.stroke().closed()) << seed;
  }
}

TEST(Pencil, R45_LinesDrawnFromEndToEndBecomeOne) {
  for (const double deg : {10.0, 29.0, 31.0, 90.0}) {
    Pencil p;
    p.set("keep_separate", false);
    p.fixture.add(testing::straight_stroke({10, 50}, {50, 50}, 3, 3));
    const double a = deg * std::numbers::pi / 180;
    p.pen.line(way({50, 50}, Point{50, 50} + 40 * Vec{std::cos(a), std::sin(a)}));
    const Stroke& one = p.stroke();
    EXPECT_EQ(one.joint(1), deg < 30 ? JointKind::kSmooth : JointKind::kCorner) << deg;
    EXPECT_EQ(one.position(0), (Point{10, 50}));
  }
}

TEST(Pencil, KeptSeparateTheyShareThePoint) {
  Pencil p;
  p.set("keep_separate", true);
  p.fixture.add(testing::straight_stroke({10, 50}, {50, 50}, 3, 3));
  p.pen.line(way({50.5, 50.5}, {90, 80}));
  ASSERT_EQ(p.fixture.strokes().size(), 2u);
  EXPECT_EQ(tip_point(*p.fixture.strokes()[1], StrokeTip::kStart), (Point{50, 50}));
}

TEST(Pencil, AStrokeThatGoesWhileItAttractsIsForgotten) {
  Pencil p;
  p.fixture.add(testing::straight_stroke({10, 50}, {50, 50}, 3, 3));
  p.pen.along(way({51, 51}, {90, 80}));
  p.fixture.undo();
  p.pen.along(way({90, 80}, {51, 50}));
  p.pen.up({51, 50});
  EXPECT_EQ(p.fixture.strokes().size(), 1u);
}

TEST(Pencil, WetInkIsTheStrokeThatComes) {
  Pencil p;
  p.set("refine", false);
  p.choose("snap", "off");
  p.set("gamma", 1.2);  // gives the line its own tone
  p.pen.up({0, 0});
  std::size_t shown = 0;
  for (const Point q : arc({60, 60}, 40, 0, 340)) {
    p.pen.depth = 0.4 + 0.012 * std::fabs(q.x);
    p.pen.down(q);
    const Overlay o = p.overlay();
    ASSERT_FALSE(o.ink.empty());
    shown = o.ink.size();
    EXPECT_LE(distance(o.ink.back().curve.p[3], q), 0.15);
    for (std::size_t i = 1; i < o.ink.size(); ++i) {
      ASSERT_LE(distance(o.ink[i - 1].curve.p[3], o.ink[i].curve.p[0]), 1e-9);
      ASSERT_NEAR(o.ink[i - 1].end_width_mm, o.ink[i].start_width_mm, 1e-9);
      ASSERT_NEAR(o.ink[i - 1].end_tone, o.ink[i].start_tone, 1e-9);
    }
  }
  EXPECT_GT(shown, 20u);
  const Overlay wet = p.overlay();
  p.pen.up({60, 60});
  // Compares width and position of the wet ink, piece by piece, with the dry stroke.
  for (const auto& piece : wet.ink) {
    double best = 1e9, width = 0.0, tone = 0.0;
    for (int k = 0; k <= 4000; ++k) {
      const double u = p.stroke().segment_count() * k / 4000.0;
      const double d = distance(p.stroke().position(u), piece.curve.p[0]);
      if (d < best) {
        best = d;
        width = p.stroke().width_mm(u);
        tone = p.stroke().tone(u);
      }
    }
    EXPECT_LE(best, 0.2);
    EXPECT_NEAR(piece.start_width_mm, width, 0.3);
    EXPECT_NEAR(piece.start_tone, tone, 0.15);
  }
}

/// The tone reflects the pressure even if the range of widths is not the default.
TEST(Pencil, TheToneIsThatOfThePressureWhateverTheWidths) {
  Pencil p;
  p.choose("snap", "off");
  p.set("max_width_mm", 2.0);
  p.pen.pressure = 0.8;
  p.pen.line(way({20, 20}, {80, 40}));
  for (const WidthKnot& knot : p.stroke().widths()) {
    EXPECT_NEAR(knot.width_mm, 0.3 + 1.7 * 0.8, 1e-9);
    EXPECT_NEAR(knot.tone, 0.8, 1e-9);
  }
}

TEST(Pencil, R43_RingsShowWhatAttractsAndWhatWouldSnap) {
  Pencil p;
  p.fixture.add(testing::straight_stroke({50, 50}, {50, 150}, 1, 1));
  p.pen.step_ns = 10'000'000;
  p.pen.along(way({30, 50}, {48, 50}));
  Overlay o = p.overlay();
  ASSERT_EQ(o.rings.size(), 1u);
  EXPECT_EQ(o.rings[0].role, Overlay::Role::kReach);
  EXPECT_EQ(o.rings[0].radius_mm, 3.0);
  p.pen.along(way({48, 50}, {49, 50}));
  o = p.overlay();
  ASSERT_EQ(o.rings.size(), 2u);
  EXPECT_EQ(o.rings[1].role, Overlay::Role::kSnap);
  EXPECT_EQ(o.rings[1].radius_mm, 1.5);
  EXPECT_EQ(o.rings[1].center, (Point{50, 50}));
  p.pen.up({49, 50});
  EXPECT_EQ(tip_point(*p.fixture.strokes()[1], StrokeTip::kEnd), (Point{50, 50}));
  // The ends of the line that was just drawn do not attract the pen.
  for (double x = 50; x > 45; x -= 0.1) {
    p.pen.at({x, 50, 2});
    for (const auto& ring : p.overlay().rings) EXPECT_EQ(ring.center, (Point{50, 50}));
  }
  Pencil alone;
  alone.pen.along(way({30, 50}, {48, 50}));
  for (double x = 48; x > 25; x -= 0.1) {
    alone.pen.at({x, 50, 2});
    EXPECT_TRUE(alone.overlay().rings.empty());
  }
}

TEST(Pencil, TheFeelHasANewIdExactlyWhenItChanges) {
  Pencil p;
  p.fixture.add(testing::straight_stroke({50, 50}, {50, 150}, 1, 1));
  const auto id = [&] { return p.tool.force(p.fixture.scene()).fade_id(); };
  p.pen.at({20, 50, 2});
  const auto free = id();
  p.pen.at({21, 50, 2});
  EXPECT_EQ(id(), free);
  p.pen.down({22, 50});
  EXPECT_EQ(id(), free);  // the parts of the model detect whether the pen is down
  p.pen.step_ns = 10'000'000;
  p.pen.along(way({22, 50}, {48.5, 50}));
  const auto attracted = id();
  EXPECT_NE(attracted, free);
  p.pen.down({48.7, 50});
  EXPECT_EQ(id(), attracted);
  p.pen.up({20, 20});
  EXPECT_EQ(id(), free);
  for (const auto& [option, value] :
       std::vector<std::pair<const char*, OptionValue>>{{"medium", std::string("chalk")},
                                                        {"strength", 0.25},
                                                        {"stabiliser", std::string("inertia")},
                                                        {"stabiliser_mass_g", 70.0},
                                                        {"stabiliser", std::string("towed")},
                                                        {"stabiliser_length_mm", 9.0}}) {
    const auto before = id();
    p.set(option, value);
    EXPECT_NE(id(), before) << option;
  }
  p.fixture.surface = *find_surface("glass");
  EXPECT_NE(id(), free);
}

TEST(Pencil, R43_TheLineJustDrawnDoesNotAttractInTheAir) {
  Pencil p;
  p.pen.along(way({20, 50}, {50, 50}));
  p.pen.at({50, 50, 1});
  EXPECT_EQ(p.pen.commits, 1);
  const auto pull = [&](double x) {
    p.pen.at({x, 50, 1.0});
    ForceMemory memory;
    PenSample s;
    s.position = {x, 50, 1.0};
    return norm(p.tool.force(p.fixture.scene())(s, memory));
  };
  p.pen.step_ns = 10'000'000;
  for (double x = 50; x < 60; x += 0.1) EXPECT_EQ(pull(x), 0.0);
  for (double x = 60; x > 50; x -= 0.1) EXPECT_EQ(pull(x), 0.0);
  // After another line was drawn, the end attracts the pen.
  p.pen.line(way({20, 80}, {50, 80}));
  p.pen.at({60, 50, 1});
  double largest = 0.0;
  for (double x = 60; x > 50; x -= 0.1) largest = std::max(largest, pull(x));
  EXPECT_GT(largest, 0.075);
}

/// A hatching as drawn in the window, with lines 0.7 to 3 mm apart and default options.
TEST(Pencil, R43_AHatchingComesOutLineByLine) {
  for (const double spacing : {0.7, 1.0, 1.5, 1.8, 2.0, 3.0}) {
    Pencil p, off;
    off.choose("snap", "off");
    for (int i = 0; i < 25; ++i) {
      const double y = 20 + spacing * i;
      const Point a{20.0 + 0.3 * (i % 3), y}, b{40.0 - 0.4 * (i % 4), y + 3};
      for (Pencil* each : {&p, &off}) {
        each->pen.step_ns = 2'000'000;
        each->pen.line(i % 2 == 0 ? way(a, b) : way(b, a));
      }
    }
    EXPECT_EQ(p.fixture.strokes().size(), 25u);
    EXPECT_EQ(p.fixture.document, off.fixture.document) << spacing;
  }
}

/// A pen that bounces at landing makes a dot. The dot does not attract the pen.
TEST(Pencil, R43_ADotDoesNotHoldThePen) {
  Pencil p;
  p.pen.step_ns = 5'000'000;
  p.pen.up({50, 50});
  p.pen.down({50, 50});
  for (int k = 0; k < 10; ++k) p.pen.at({50, 50, 0.8});
  p.pen.down({50.1, 50});
  for (const Point q : way({50.1, 50}, {70, 55})) {
    p.pen.down(q);
    ASSERT_TRUE(p.overlay().rings.empty());
  }
  p.pen.up({70, 55});
  EXPECT_EQ(p.pen.commits, 2);
  EXPECT_EQ(p.fixture.strokes().size(), 2u);
}

TEST(Pencil, R43_ALineMeetsTheMiddleOfAnotherWithoutChangingIt) {
  Pencil p;
  p.fixture.add(testing::straight_stroke({50, 20}, {50, 90}, 1, 1));
  const StrokePtr other = p.fixture.strokes()[0];
  p.pen.step_ns = 10'000'000;
  p.pen.line(way({20, 50}, {49.6, 50.2}));
  ASSERT_EQ(p.fixture.strokes().size(), 2u);
  EXPECT_EQ(p.fixture.strokes()[0], other);
  EXPECT_NEAR(tip_point(*p.fixture.strokes()[1], StrokeTip::kEnd).x, 50.0, 1e-9);
}

TEST(Pencil, R44_SmallCirclesClose) {
  for (const double diameter : {3.0, 4.0, 6.0, 8.0, 10.0}) {
    for (const double gap_deg : {0.0, 10.0, 25.0}) {
      Pencil p;
      p.pen.step_ns = 1'000'000;
      p.pen.line(arc({50, 50}, 0.5 * diameter, 0, 360 - gap_deg));
      EXPECT_TRUE(p.stroke().closed()) << diameter << " " << gap_deg;
    }
  }
}

/// A tilt that the pen reports overrides the option (WidthMap).
TEST(Pencil, AMousesPenTiltsAsTheOptionSays) {
  OptionValues values(kPencilOptions);
  EXPECT_EQ(pencil_settings(values).ink.width_map.absent_tilt_deg, 0.0);
  ASSERT_TRUE(values.set("tilt_deg", 70.0));
  EXPECT_EQ(pencil_settings(values).ink.width_map.absent_tilt_deg, 70.0);
  EXPECT_FALSE(values.set("tilt_deg", 81.0));
  EXPECT_FALSE(values.set("tilt_deg", -1.0));
  ASSERT_TRUE(values.set("lean_deg", 30.0)) << "the id in older recordings and settings";
  EXPECT_EQ(pencil_settings(values).ink.width_map.absent_tilt_deg, 30.0);
}

TEST(Pencil, EveryOptionDoesSomething) {
  // Makes a drawing with an end nearby, tremor and changing pressure. Returns a fingerprint of all
  // ink and forces.
  const auto fingerprint = [](const std::vector<std::pair<const char*, OptionValue>>& options,
                              bool mouse) {
    Pencil p;
    if (mouse) p.fixture.device.sensed_axes = 2;
    for (const auto& [id, value] : options) p.set(id, value);
    p.fixture.add(testing::straight_stroke({84.3, 55.8}, {120, 50}, 1, 1));
    testing::RandomStroke random(1);
    Fnv1a hash;
    const auto feel = [&](const Point q, double z) {
      ForceMemory memory;
      PenSample s;
      s.position = {q.x, q.y, z};
      const ForceModel model = p.tool.force(p.fixture.scene());
      for (int k = 0; k < 4; ++k) {
        s.position.x += 1.5;
        s.velocity = {1500, 0, 0};
        memory.begin_tick(0.001);
        const Force f = model(s, memory);
        hash.add_value(f.x);
        hash.add_value(f.y);
      }
    };
    p.pen.up({20, 50});
    for (const Point q : arc({50, 50}, 30, 180, 30) + arc({102, 80}, 30, 210, 232)) {
      p.pen.depth = 1.0 + 0.02 * q.x;
      p.pen.down(q + Vec{random.uniform(-.05, .05), random.uniform(-.05, .05)});
      feel(q, -1.0);
    }
    p.pen.up({83.5, 56.4});
    for (const StrokePtr& s : p.fixture.strokes()) {
      for (const Point c : s->data().points) hash.add_value(c);
      for (const WidthKnot& k : s->widths()) hash.add_value(k);
      for (const char c : s->medium()) hash.add_value(c);
    }
    return hash.value();
  };
  const auto plain = fingerprint({}, false);
  EXPECT_EQ(fingerprint({}, false), plain);
  using Options = std::vector<std::pair<const char*, OptionValue>>;
  const std::vector<Options> changes = {{{"medium", std::string("chalk")}},
                                        {{"min_width_mm", 0.5}},
                                        {{"max_width_mm", 3.0}},
                                        {{"gamma", 2.0}},
                                        {{"tolerance_mm", 1.0}},
                                        {{"snap", std::string("off")}},
                                        {{"snap", std::string("force")}},
                                        {{"snap", std::string("snap")}},
                                        {{"reach_mm", 12.0}},
                                        {{"snap_radius_mm", 0.5}},
                                        {{"attraction_n", 0.5}},
                                        {{"keep_separate", false}},
                                        {{"stabiliser", std::string("inertia")}},
                                        {{"stabiliser", std::string("towed")}},
                                        {{"strength", 0.25}}};
  for (const Options& o : changes) EXPECT_NE(fingerprint(o, false), plain) << o[0].first;
  const OptionValue inertia = std::string("inertia"), towed = std::string("towed");
  EXPECT_NE(fingerprint({{"stabiliser", inertia}}, false),
            fingerprint({{"stabiliser", inertia}, {"stabiliser_mass_g", 90.0}}, false));
  EXPECT_NE(fingerprint({{"stabiliser", towed}}, false),
            fingerprint({{"stabiliser", towed}, {"stabiliser_length_mm", 8.0}}, false));
  EXPECT_NE(fingerprint({{"mouse_pressure", 0.1}}, true), fingerprint({}, true));
}

TEST(Pencil, RefiningSavesSegments) {
  const auto segments = [](bool refine) {
    int count = 0;
    for (int k = 1; k <= 8; ++k) {
      Pencil p;
      p.choose("snap", "off");
      p.set("refine", refine);
      std::vector<Point> points;
      for (int i = 0; i <= 2000; ++i) {
        const double t = 0.003 * i;
        points.push_back({20 * t, 60 + 12 * std::sin(k * t) + 5 * std::sin(2.7 * k * t)});
      }
      p.pen.line(points);
      EXPECT_LE(largest_gap(p.stroke(), points), 0.15 + 0.3);
      count += p.stroke().segment_count();
    }
    return count;
  };
  EXPECT_LT(segments(true), segments(false));
}

TEST(Pencil, OptionsTakeEffectWithTheNextLine) {
  Pencil p;
  p.pen.along(way({0, 0}, {25, 0}));
  p.set("max_width_mm", 0.5);
  p.set("snap", std::string("off"));
  p.pen.along(way({25, 0}, {50, 0}));
  p.pen.up({50, 0});
  EXPECT_GT(p.stroke().width_mm(p.stroke().segment_count()), 1.0);
  p.pen.line(way({0, 20}, {50, 20}));
  EXPECT_LE(p.fixture.strokes()[1]->width_mm(0), 0.5);
}

TEST(Pencil, TheStabilisedLineReachesThePen) {
  for (const char* kind : {"inertia", "towed"}) {
    Pencil p;
    p.choose("stabiliser", kind);
    p.pen.along(way({0, 0}, {50, 0}) + way({50, 0}, {80, 30}));
    ASSERT_EQ(p.overlay().lines.size(), 1u);
    EXPECT_EQ(p.overlay().lines[0].role, Overlay::Role::kTether);
    p.pen.up({80, 30});
    EXPECT_LE(distance(tip_point(p.stroke(), StrokeTip::kEnd), {80, 30}), 0.15) << kind;
    EXPECT_TRUE(check_invariants(p.stroke().data()));
  }
}

TEST(Pencil, AMillionSamplesAreNoBurden) {
  Pencil p;
  p.choose("snap", "off");
  p.pen.up({0, 0});
  for (int k = 0; k < 1'000'000; ++k) {
    const double t = 0.001 * k;
    p.pen.down({100 + 80 * std::sin(1.3 * t), 100 + 80 * std::cos(1.7 * t)});
  }
  p.pen.up({0, 0});
  EXPECT_EQ(p.pen.commits, 1);
  EXPECT_GT(p.stroke().segment_count(), 1000);
}

// Tests robustness with any sequence of samples, options, cancels and undos.

class Hostile {
 public:
  explicit Hostile(std::uint64_t seed) : random_(seed) {}

  void run(int steps) {
    for (int k = 0; k < steps; ++k) step();
    finish();
  }
  [[nodiscard]] const Document& document() const { return p_.fixture.document; }
  Pencil& pencil() { return p_; }
  [[nodiscard]] int gestures() const { return gestures_; }

 private:
  void step() {
    const double what = random_.uniform(0, 1);
    if (what < 0.004) {
      p_.tool.cancel();
    } else if (what < 0.008) {
      finish();
    } else if (what < 0.012 && p_.fixture.history.can_undo()) {
      p_.fixture.undo();
    } else if (what < 0.016) {
      set_any_option();
    } else {
      move();
    }
  }

  void finish() {
    const ToolResult result = p_.tool.finish(p_.fixture.scene());
    if (result.commit) commit(*result.commit);
  }

  void commit(const Edit& edit) {
    ++gestures_;
    p_.fixture.apply(edit);
    for (const StrokeChange& c : edit.changes) {
      if (c.after) {
        ASSERT_TRUE(check_invariants(c.after->data()));
      }
    }
  }

  void move() {
    if (random_.chance(0.01)) down_ = !down_;
    if (random_.chance(0.02)) velocity_ = {random_.uniform(-1, 1), random_.uniform(-1, 1)};
    at_ += velocity_;
    at_ = {std::clamp(at_.x, 0.0, 60.0), std::clamp(at_.y, 0.0, 60.0)};
    PenSample s;
    s.time_ns = time_ += random_.chance(0.01) ? -5'000'000 : random_.pick(0, 4'000'000);
    s.position = {at_.x, at_.y, down_ ? random_.uniform(-3, 0.05) : random_.uniform(-0.01, 9)};
    if (random_.chance(0.2)) s.pressure = random_.uniform(-0.5, 1.5);
    if (random_.chance(0.01)) spoil(s);
    if (!is_pen_position(s.position)) return;
    const ToolResult result = p_.tool.sample(s, contact_.update(s), p_.fixture.scene());
    EXPECT_FALSE(result.preview);
    if (result.commit) commit(*result.commit);
    if (!random_.chance(0.02)) return;
    overlay_.clear();
    p_.tool.draw(overlay_);
    ASSERT_EQ(overlay_.ink, p_.overlay().ink) << "a reused overlay shows what a new one shows";
    for (const auto& ink : overlay_.ink) {
      ASSERT_TRUE(is_finite(ink.curve));
      ASSERT_GE(ink.start_width_mm, kMinWidthMm);
      ASSERT_GE(ink.end_width_mm, kMinWidthMm);
    }
    ForceMemory memory;
    ASSERT_TRUE(is_finite(p_.tool.force(p_.fixture.scene())(s, memory)) || !is_finite(s.position));
  }

  void spoil(PenSample& s) {
    switch (random_.pick(0, 5)) {
      case 0:
        s.position.x = kNan;
        break;
      case 1:
        s.position.z = -std::numeric_limits<double>::infinity();
        break;
      case 2:
        s.pressure = kNan;
        break;
      case 3:
        s.time_ns = std::numeric_limits<std::int64_t>::max();
        break;
      case 4:
        s.position.y = 1e300;
        break;
      default:
        s.time_ns = std::numeric_limits<std::int64_t>::min();
    }
  }

  void set_any_option() {
    const auto options = p_.tool.info().options;
    const OptionSpec& spec =
        options[static_cast<std::size_t>(random_.pick(0, static_cast<int>(options.size()) - 1))];
    OptionValue value = random_.uniform(spec.min, spec.max);
    if (spec.kind == OptionKind::kSwitch) value = random_.chance(0.5);
    if (spec.kind == OptionKind::kChoice) {
      value = std::string(spec.choices[static_cast<std::size_t>(
          random_.pick(0, static_cast<int>(spec.choices.size()) - 1))]);
    }
    EXPECT_TRUE(p_.tool.set_option(spec.id, value));
  }

  testing::RandomStroke random_;
  Pencil p_;
  Contact contact_;
  Overlay overlay_;
  Point at_{30, 30};
  Vec velocity_;
  bool down_ = false;
  std::int64_t time_ = 0;
  int gestures_ = 0;
};

TEST(PencilFuzz, R52_AnySamplesKeepTheInvariantsAndUndoRestoresAll) {
  int gestures = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Hostile hostile(seed);
    hostile.run(6000);
    gestures += hostile.gestures();
    Fixture& fixture = hostile.pencil().fixture;
    const Document full = fixture.document;
    const std::size_t steps = fixture.history.undo_count();
    while (fixture.history.can_undo()) fixture.undo();
    EXPECT_EQ(fixture.document, Document());
    EXPECT_EQ(fixture.index.tip_count(), 0u);
    for (std::size_t k = 0; k < steps; ++k) {
      ASSERT_TRUE(fixture.history.redo(fixture.document));
    }
    EXPECT_EQ(fixture.document, full);
  }
  EXPECT_GT(gestures, 1000);
}

TEST(PencilFuzz, TheSameSamplesMakeTheSameDocument) {
  for (std::uint64_t seed = 100; seed < 105; ++seed) {
    Hostile a(seed), b(seed);
    a.run(4000);
    b.run(4000);
    EXPECT_EQ(a.document(), b.document());
    EXPECT_GT(a.document().stroke_count(), 0u);
  }
}

}  // namespace
}  // namespace felt::pencil_test
