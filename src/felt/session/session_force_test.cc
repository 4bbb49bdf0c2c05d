// Tests of edges that are felt as soft ridges and of rings, with the real tools.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "felt/haptics/force_memory.h"
#include "felt/session/session.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/tools/choice_ring.h"

namespace felt::session_force_test {
namespace {

constexpr Rect kPage{0.0, 0.0, 210.0, 297.0};
constexpr Point kAtEdge{2.5, 100.0};

/// A session with a line from (100, 100) to (140, 130), and a pen that feels the forces.
struct EdgeFixture {
  EdgeFixture() {
    Capabilities device;
    device.max_force_n = device.continuous_force_n = 3.0;
    device.actuated_axes = device.sensed_axes = 3;
    device.max_stiffness_n_per_m = 2000.0;
    const StrokePtr line = std::make_shared<const Stroke>(
        felt::testing::straight_stroke({100, 100}, {140, 130}, 1, 1));
    session = std::make_unique<Session>(
        make_tools(), SessionOptions{.device = device, .document = document_of({&line, 1})});
  }
  template <class Command>
  void must(Command what) {
    const Result<void> done = session->apply({now_ns += 1'000'000, std::move(what)});
    ASSERT_TRUE(done) << done.error().message;
  }
  /// Returns the force of the edge after the pen has rested at a point.
  double edge_n(Point p, double z = -0.3) {
    ForceMemory memory;
    double felt_n = 0.0;
    for (int i = 0; i < 300; ++i) {
      PenSample sample;
      sample.time_ns = now_ns += 1'000'000;
      sample.position = {p.x, p.y, z};
      EXPECT_TRUE(session->sample(sample));
      memory.begin_tick(0.001);
      static_cast<void>(session->force()(sample, memory));
      felt_n = 0.0;
      for (const ForceTerms::Term& term : memory.terms) {
        if (std::string_view(term.name) == "guide") felt_n += norm(term.force);
      }
    }
    for (int i = 0; i < 100; ++i) must(PenEvent{{p.x, p.y, 5.0}, {}, 0});
    return felt_n;
  }

  std::int64_t now_ns = 0;
  std::unique_ptr<Session> session;
};

/// Returns the force after the pen has drawn a zigzag of 60 ms that ends at a point.
Force force_at(Session& session, Point p, std::int64_t& now_ns) {
  ForceMemory memory;
  Force force;
  for (int i = 0; i < 60; ++i) {
    PenSample sample;
    sample.time_ns = now_ns += 1'000'000;
    sample.position = {p.x + 0.1 * (60 - i), p.y + 0.05 * (i % 7), -0.3};
    EXPECT_TRUE(session.sample(sample));
    sample.velocity = {-100.0, 30.0, 0.0};
    memory.begin_tick(0.001);
    force = session.force()(sample, memory);
  }
  return force;
}

TEST(SessionPlaneOnly, NoToolAddsAForceAlongTheSurface) {
  for (const auto& tool : make_tools()) {
    EdgeFixture all, plane;
    for (EdgeFixture* f : {&all, &plane}) {
      f->must(SelectTool{std::string(tool->info().id)});
      f->must(UseEdges{kPage, false});
    }
    plane.must(SetOption{"surface.plane_only", OptionValue(true)});
    const Force felt = force_at(*plane.session, {101.0, 101.0}, plane.now_ns);
    EXPECT_EQ(std::hypot(felt.x, felt.y), 0.0) << tool->info().id;
    EXPECT_GT(felt.z, 0.1) << tool->info().id;
    const Force usual = force_at(*all.session, {101.0, 101.0}, all.now_ns);
    if (tool->info().kind == ToolKind::kDraws) {
      EXPECT_GT(std::hypot(usual.x, usual.y), 0.0);
    }
    EXPECT_NE(plane.session->force().fade_id(), all.session->force().fade_id());
  }
}

TEST(SessionPlaneOnly, APencilWithoutStrengthIsThePlane) {
  EdgeFixture weak, plane;
  weak.must(SetOption{"pencil.strength", OptionValue(0.0)});
  plane.must(SetOption{"surface.plane_only", OptionValue(true)});
  for (const Point p : {Point{101.0, 101.0}, Point{30.0, 40.0}, kAtEdge}) {
    const Force a = force_at(*weak.session, p, weak.now_ns);
    const Force b = force_at(*plane.session, p, plane.now_ns);
    EXPECT_NEAR(a.x, b.x, 1e-12);
    EXPECT_NEAR(a.y, b.y, 1e-12);
    EXPECT_NEAR(a.z, b.z, 1e-12);
  }
}

/// Returns the term of the force that resists or attracts, of a pen at rest.
double term_n(const Session& session, Point p, const char* name) {
  ForceMemory memory;
  memory.begin_tick(0.001);
  PenSample sample;
  sample.position = {p.x, p.y, -0.3};
  (void)session.force()(sample, memory);
  for (const auto& term : memory.terms) {
    if (std::string_view(term.name) == name) return std::hypot(term.force.x, term.force.y);
  }
  return 0.0;
}

TEST(SessionLaw, OfThePaperChangesTheForcesOfTheTools) {
  EdgeFixture felt, paper;
  ASSERT_TRUE(paper.session->apply({0, SetOption{"surface.law", std::string("paper")}}));
  ASSERT_TRUE(felt.session->apply({0, SetOption{"pull.yield_s", 0.0}}));
  const auto touch = [](EdgeFixture& f, const char* tool, Point p) {
    f.must(SelectTool{tool});
    PenSample sample;
    sample.position = {p.x, p.y, 5.0};
    sample.time_ns = f.now_ns += 1'000'000;
    ASSERT_TRUE(f.session->sample(sample));
    sample.position.z = -0.3;
    sample.time_ns = f.now_ns += 1'000'000;
    ASSERT_TRUE(f.session->sample(sample));
  };
  const Point on_line{120.0, 115.0};
  for (EdgeFixture* f : {&felt, &paper}) {
    f->must(SetOption{"pull.mode", std::string("grab")});
    touch(*f, "pull", on_line);
  }
  const Point near = on_line + Vec{0.1, 0.0}, far = on_line + Vec{0.0, 8.0};
  EXPECT_NEAR(term_n(*felt.session, near, "edit"), 0.03, 1e-9);
  EXPECT_NEAR(term_n(*paper.session, near, "edit"), 0.2 + 0.8 * 0.1 / 10.1, 1e-9);
  EXPECT_NEAR(term_n(*paper.session, far, "edit"), term_n(*felt.session, far, "edit"), 1e-9);
  EXPECT_NE(felt.session->force().fade_id(), paper.session->force().fade_id());
}

TEST(SessionEdges, AreFeltOnlyIfTheyAreOn) {
  EdgeFixture f;
  f.must(SelectStrokes{SelectStrokes::What::kAll});  // before the pen draws other lines
  EXPECT_EQ(f.edge_n(kAtEdge), 0.0);
  f.must(UseEdges{.page = kPage});
  EXPECT_GT(f.edge_n(kAtEdge), 0.1);
  EXPECT_EQ(f.edge_n({50.0, 100.0}), 0.0);
  EXPECT_EQ(f.edge_n({97.5, 115.0}), 0.0) << "only the page is on";
  f.must(UseEdges{.selection = true});
  EXPECT_GT(f.edge_n({97.5, 115.0}), 0.1);
  EXPECT_EQ(f.edge_n(kAtEdge), 0.0);
  f.must(SelectStrokes{SelectStrokes::What::kNone});
  EXPECT_EQ(f.edge_n({97.5, 115.0}), 0.0);
  f.must(UseEdges{});
  EXPECT_EQ(f.edge_n(kAtEdge), 0.0);
  EXPECT_EQ(f.session->edges(), UseEdges{});
}

TEST(SessionEdges, EveryToolFeelsThemUnlessItHasAGuideOfItsOwn) {
  EdgeFixture f;
  f.must(UseEdges{.page = kPage});
  for (const auto& tool : f.session->tools()) {
    f.must(SelectTool{std::string(tool->info().id)});
    for (int i = 0; i < 100; ++i) f.must(PenEvent{{kAtEdge.x, kAtEdge.y, 5.0}, {}, 0});
    EXPECT_GT(f.edge_n(kAtEdge), 0.1) << tool->info().id;
    f.must(CancelEvent{});
  }
  f.must(SelectTool{"pencil"});
  f.must(GuidesEvent{GuidesEvent::Do::kClear});  // that of the tool Guide
  f.must(GuidesEvent{GuidesEvent::Do::kAdd, {}, {DrawingGuideKind::kLine, {3.0, 0.0}, 1.5708}});
  EXPECT_GT(f.edge_n({4.5, 100.0}), 0.25) << "the line holds the pen, with more than 0.2 N";
}

TEST(SessionEdges, AGuideFarAwayDoesNotHideThem) {
  EdgeFixture f;
  f.must(UseEdges{.page = kPage});
  f.must(GuidesEvent{GuidesEvent::Do::kAdd, {}, {DrawingGuideKind::kLine, {90.0, 0.0}, 1.5708}});
  EXPECT_GT(f.edge_n(kAtEdge), 0.1);
}

// Off, nothing changes; on, only forces do.
TEST(SessionEdges, ChangeForcesNearTheEdgeAndNothingElse) {
  EdgeFixture with, without;
  with.must(UseEdges{.page = kPage});
  without.now_ns = with.now_ns;
  for (const Point p : {Point{50.0, 60.0}, Point{80.0, 60.0}, Point{4.0, 60.0}}) {
    with.edge_n(p);
    without.edge_n(p);
    const bool is_far = p.x > 10.0;
    EXPECT_EQ(with.session->force().fade_id() == without.session->force().fade_id(), is_far);
    EXPECT_EQ(with.session->force().slopes().lateral_n_per_m ==
                  without.session->force().slopes().lateral_n_per_m,
              is_far);
  }
  const Document &a = with.session->document(), &b = without.session->document();
  ASSERT_EQ(a.stroke_count(), b.stroke_count());
  ASSERT_GT(a.stroke_count(), 2u);
  for (StrokeId id{1}; id.value <= a.stroke_count(); ++id.value) {
    EXPECT_EQ(a.find(id)->data().points, b.find(id)->data().points);
  }
}

TEST(SessionEdges, RefusesWhatIsNoRectangle) {
  EdgeFixture f;
  const double inf = std::numeric_limits<double>::infinity();
  for (const Rect& page : {Rect{5, 5, 1, 1}, Rect{0, 0, inf, 5}}) {
    EXPECT_FALSE(f.session->apply({0, UseEdges{.page = page}}));
    EXPECT_EQ(f.session->edges(), UseEdges{});
  }
}

constexpr UseRing kRing{true, {60.0, 70.0}, {60.0, 54.0}, {76.0, 70.0}};

TEST(SessionRing, IsFeltAndChoosesButLeavesNoInk) {
  EdgeFixture f;
  const Document before = f.session->document();
  f.must(kRing);
  ASSERT_TRUE(f.session->ring());
  EXPECT_EQ(f.edge_n({61.0, 70.0}), 0.0) << "nothing is chosen in the middle";
  EXPECT_GT(f.edge_n({78.0, 71.5}), 0.2);
  EXPECT_EQ(f.session->ring()->chosen(), 2u);
  f.must(UseRing{});
  EXPECT_FALSE(f.session->ring());
  EXPECT_EQ(f.session->document(), before);
  EXPECT_EQ(f.edge_n({78.0, 71.5}), 0.0);
  EXPECT_GT(f.session->document().stroke_count(), before.stroke_count()) << "it draws again";
}

// The ring closes while the pen is on the surface: this touch is not for the tool.
TEST(SessionRing, ATouchThatBeganInItDoesNotDraw) {
  EdgeFixture f;
  f.must(kRing);
  for (const double x : {60.0, 70.0, 76.0}) f.must(PenEvent{{x, 70.0, -0.5}, {}, 0});
  f.must(UseRing{});
  for (double x = 76.0; x < 100.0; x += 0.5) f.must(PenEvent{{x, 70.0, -0.5}, 0.5, 0});
  for (int i = 0; i < 100; ++i) f.must(PenEvent{{100.0, 70.0, 5.0}, 0.0, 0});
  EXPECT_EQ(f.session->document().stroke_count(), 1u);
  for (double x = 76.0; x < 100.0; x += 0.5) f.must(PenEvent{{x, 70.0, -0.5}, 0.5, 0});
  for (int i = 0; i < 100; ++i) f.must(PenEvent{{100.0, 70.0, 5.0}, 0.0, 0});
  EXPECT_EQ(f.session->document().stroke_count(), 2u);
}

TEST(SessionRing, AToolClosesIt) {
  for (const char* tool : {"pencil", "pull"}) {
    EdgeFixture f;
    f.must(kRing);
    f.must(SelectTool{tool});
    EXPECT_FALSE(f.session->ring()) << tool;
  }
}

TEST(SessionRing, DoesNotInterruptALine) {
  EdgeFixture f;
  for (double x = 60.0; x < 80.0; x += 0.5) f.must(PenEvent{{x, 70.0, -0.5}, 0.5, 0});
  f.must(kRing);
  EXPECT_FALSE(f.session->ring());
  for (double x = 80.0; x < 100.0; x += 0.5) f.must(PenEvent{{x, 70.0, -0.5}, 0.5, 0});
  for (int i = 0; i < 100; ++i) f.must(PenEvent{{100.0, 70.0, 5.0}, 0.0, 0});
  EXPECT_EQ(f.session->document().stroke_count(), 2u);
}

TEST(SessionRing, RefusesWhatIsNoRing) {
  EdgeFixture f;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const UseRing& ring :
       {UseRing{true}, UseRing{true, {0, 0}, {0, 9}, {0, -9}},
        UseRing{true, {nan, 0}, {0, 9}, {9, 0}}, UseRing{true, {0, 0}, {0, 1e300}, {1e300, 0}}}) {
    EXPECT_FALSE(f.session->apply({0, ring}));
    EXPECT_FALSE(f.session->ring());
  }
}

/// Draws along the line of EdgeFixture without lifting the pen, from a share of the line to
/// another.
void retrace_line(EdgeFixture& f, double from, double to) {
  for (int i = 0; i <= 400; ++i) {
    const Point pen = lerp(Point{100, 100}, Point{140, 130}, from + (to - from) * i / 400.0);
    f.must(PenEvent{{pen.x, pen.y, -0.3}, {}, 0});
  }
}

TEST(SessionForce, R71_ARetracedLineHoldsUntilTheStrokeEnds) {
  EdgeFixture f;
  f.must(SelectTool{"pencil"});
  retrace_line(f, 0.1, 0.5);
  EXPECT_EQ(f.session->retraced(), StrokeId{1});
  f.must(CancelEvent{});
  EXPECT_FALSE(f.session->retraced());
  retrace_line(f, 0.5, 0.9);
  EXPECT_FALSE(f.session->retraced()) << "not before the next touch";
  f.must(PenEvent{{140, 130, 9.0}, {}, 0});
  retrace_line(f, 0.9, 0.5);
  EXPECT_EQ(f.session->retraced(), StrokeId{1}) << "backwards";
  f.must(UndoEvent{});
  EXPECT_FALSE(f.session->retraced());
}

TEST(SessionForce, R71_OnlyAPencilOnADeviceWithForcesIsHeld) {
  EdgeFixture f;
  f.must(SelectTool{"eraser"});
  retrace_line(f, 0.1, 0.5);
  EXPECT_FALSE(f.session->retraced());
  EdgeFixture guided;
  guided.must(SelectTool{"pencil"});
  guided.must(UseGuide{{GuideKind::kGroove, {{0, 0}, {50, 0}}}});
  retrace_line(guided, 0.1, 0.5);
  EXPECT_FALSE(guided.session->retraced()) << "the guide of a study has priority";
  EdgeFixture off;
  off.must(SelectTool{"pencil"});
  off.must(SetOption{"pencil.retrace_n", 0.0});
  retrace_line(off, 0.1, 0.5);
  EXPECT_FALSE(off.session->retraced());
  EdgeFixture tablet;
  tablet.must(UseDevice{});
  tablet.must(SelectTool{"pencil"});
  retrace_line(tablet, 0.1, 0.5);
  EXPECT_FALSE(tablet.session->retraced());
}

/// Draws slowly along y = 60 from x = 20, 0.3 mm beside the line, and returns the force of a guide
/// at the end.
Force drawn_beside(EdgeFixture& f, double beside_mm = 0.3, double to_x = 40.0) {
  ForceMemory memory;
  Force guide;
  for (int i = 0; i <= 20.0 * (to_x - 20.0); ++i) {
    PenSample sample;
    sample.time_ns = f.now_ns += 1'000'000;
    sample.position = {20.0 + 0.05 * i, 60.0 + beside_mm, -0.3};
    EXPECT_TRUE(f.session->sample(sample));
    memory.begin_tick(0.001);
    static_cast<void>(f.session->force()(sample, memory));
    guide = {};
    for (const ForceTerms::Term& term : memory.terms) {
      if (std::string_view(term.name) == "guide") guide = term.force;
    }
  }
  for (int i = 0; i < 100; ++i) f.must(PenEvent{{40.0, 60.0, 5.0}, {}, 0});
  return guide;
}

/// The same, without the ink afterwards.
Force held_beside(EdgeFixture& f, double beside_mm = 0.3) {
  const Force force = drawn_beside(f, beside_mm);
  f.must(UndoEvent{});
  return force;
}

UseEdges contour_at(double y) {
  return {.contours = {{{10, y}, {50, y}}}};
}

TEST(SessionForce, R74_AContourOfAPictureHoldsThePenThatFollowsIt) {
  EdgeFixture f;
  f.must(SelectTool{"pencil"});
  EXPECT_EQ(norm(held_beside(f)), 0.0) << "nothing is there";
  f.must(contour_at(60.0));
  const Force towards = held_beside(f);
  EXPECT_LT(towards.y, -0.05) << "to the contour";
  EXPECT_LE(norm(towards), 0.15 + 1e-9);
  EXPECT_EQ(norm(held_beside(f, 1.5)), 0.0) << "too far away";
  f.must(SetOption{"pencil.retrace_n", 0.0});
  EXPECT_EQ(norm(held_beside(f)), 0.0);
  f.must(SetOption{"pencil.retrace_n", 0.1});
  f.must(contour_at(70.0));
  EXPECT_EQ(norm(held_beside(f)), 0.0) << "it is elsewhere now";
  f.must(contour_at(60.0));
  f.must(SelectTool{"eraser"});
  EXPECT_EQ(norm(held_beside(f)), 0.0) << "only a pencil";
}

TEST(SessionForce, R74_InkIsFeltBeforeTheContourBelowIt) {
  EdgeFixture f;
  f.must(contour_at(60.6));
  f.must(SelectTool{"pencil"});
  f.must(SetOption{"pencil.snap", std::string("off")});
  EXPECT_GT(drawn_beside(f, 0.3).y, 0.05) << "to the contour below";
  // The ink of that line is at 60.3, above the contour.
  EXPECT_LT(drawn_beside(f, 0.45).y, 0.0) << "to the ink";
}

TEST(SessionForce, R74_AContourHoldsAgainAfterInkHasHeldInTheSameTouch) {
  EdgeFixture f;
  const StrokePtr ink =
      std::make_shared<const Stroke>(felt::testing::straight_stroke({20, 60.2}, {40, 60.2}, 1, 1));
  f.session = std::make_unique<Session>(
      make_tools(),
      SessionOptions{.device = f.session->device(), .document = document_of({&ink, 1})});
  f.must(SelectTool{"pencil"});
  f.must(UseEdges{.contours = {{{10, 60}, {90, 60}}}});
  EXPECT_LT(drawn_beside(f, 0.3, 80.0).y, -0.05) << "the ink ends at 40";
}

TEST(SessionForce, R74_ContoursThatCannotBeAreRefusedAndChangeNothing) {
  EdgeFixture f;
  f.must(contour_at(60.0));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Point> many(UseEdges::kMaxContourPoints + 1);
  for (const std::vector<std::vector<Point>>& bad :
       {std::vector<std::vector<Point>>{{{nan, 0.0}, {1.0, 1.0}}},
        std::vector<std::vector<Point>>{many},
        std::vector<std::vector<Point>>(UseEdges::kMaxContours + 1)}) {
    EXPECT_FALSE(f.session->apply({0, UseEdges{.contours = bad}}));
    EXPECT_EQ(f.session->edges(), contour_at(60.0));
  }
  f.must(UseEdges{.contours = {{}, {{5, 5}}, {{5, 5}, {5, 5}, {5, 5}}, {{0, 0}, {0.5, 0}}}});
  f.must(UseEdges{.contours = {{{5, 5}, {5.06, 5}, {5, 5.06}, {5, 5}}}});
  f.must(SelectTool{"pencil"});
  EXPECT_EQ(norm(drawn_beside(f)), 0.0);
}

}  // namespace
}  // namespace felt::session_force_test
