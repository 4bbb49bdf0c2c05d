#include "felt/tools/retrace.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "felt/base/constants.h"
#include "felt/geometry/polyline.h"
#include "felt/haptics/force_memory.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::retrace_test {
namespace {

constexpr double kForceN = 0.1;

/// A page on which a pen draws, with the haptic loop's force at each sample.
class Page {
 public:
  Page() { fixture.device.max_damping_n_s_per_m = 10.0; }

  void move(Point to, double speed_mm_per_s) {
    const double step_mm = 0.001 * speed_mm_per_s;
    const int steps = std::max(1, static_cast<int>(std::ceil(distance(at_, to) / step_mm)));
    const Point from = at_;
    for (int i = 1; i <= steps; ++i) sample(lerp(from, to, double(i) / steps));
  }
  void touch(Point at) {
    PenSample hover;
    hover.time_ns = time_ns_ += step_ns;
    hover.position = {at.x, at.y, 5.0};
    retrace.update(hover, false, fixture.scene(), kForceN);
    at_ = at;
    sample(at);
  }
  /// Draws a path and returns how often a line began to hold the pen.
  int draw(const std::vector<Point>& path, double speed_mm_per_s = 40.0) {
    holds = 0;
    touch(path.front());
    for (std::size_t i = 1; i < path.size(); ++i) move(path[i], speed_mm_per_s);
    return holds;
  }

  std::int64_t step_ns = kMs;
  testing::Fixture fixture;
  Retrace retrace;
  int holds = 0;  ///< since draw() began
  double max_n = 0.0, hold_mj = 0.0, max_mj = 0.0;

 private:
  void sample(Point to) {
    const Vec moved = to - at_;
    at_ = to;
    PenSample pen;
    pen.time_ns = time_ns_ += step_ns;
    pen.position = {to.x, to.y, -0.5};
    pen.velocity = {1000.0 * moved.x, 1000.0 * moved.y, 0.0};
    const bool was_held = retrace.line().has_value();
    retrace.update(pen, true, fixture.scene(), kForceN);
    memory_.begin_tick(0.001);
    const Force force = retrace.force() ? (*retrace.force())(pen, memory_) : Force{};
    if (!was_held) hold_mj = 0.0;
    holds += !was_held && retrace.line() ? 1 : 0;
    hold_mj += force.x * moved.x + force.y * moved.y;
    max_mj = std::max(max_mj, hold_mj);
    max_n = std::max(max_n, norm(force));
  }

  ForceMemory memory_;
  std::int64_t time_ns_ = 0;
  Point at_;
};

TEST(Retrace, R71_APenThatFollowsALineIsHeldAfterFiveMillimetres) {
  Page page;
  const StrokeId line = page.fixture.add(testing::polyline_stroke({{0.0, 0.0}, {80.0, 0.0}}));
  page.touch({10.0, 0.2});
  page.move({14.0, 0.2}, 40.0);
  EXPECT_FALSE(page.retrace.line());
  page.move({16.5, 0.2}, 40.0);
  EXPECT_EQ(page.retrace.line(), line);
  page.move({40.0, 0.2}, 40.0);
  ASSERT_TRUE(page.retrace.force());
  EXPECT_NEAR(page.max_n, kForceN, 1e-9);
  // Backwards along the line, too.
  EXPECT_EQ(page.draw({{70.0, -0.2}, {50.0, -0.2}}), 1);
  EXPECT_LE(page.max_mj, 0.2);
}

TEST(Retrace, R71_LetsGoOfAPenThatLeavesTurnsOrIsFast) {
  const std::vector<Point> leaves = {{10, 0}, {20, 0}, {26, 1.3}, {30, 1.3}};
  const std::vector<Point> turns = {{10, 0}, {20, 0}, {21.2, 0.95}};
  for (const auto& path : {leaves, turns}) {
    Page page;
    page.fixture.add(testing::polyline_stroke({{0.0, 0.0}, {80.0, 0.0}}));
    EXPECT_EQ(page.draw(path), 1);
    EXPECT_FALSE(page.retrace.line());
  }
  Page page;
  page.fixture.add(testing::polyline_stroke({{0.0, 0.0}, {80.0, 0.0}}));
  EXPECT_EQ(page.draw({{10, 0}, {20, 0}}), 1);
  page.move({40, 0}, 130.0);
  EXPECT_FALSE(page.retrace.line());
  EXPECT_EQ(page.draw({{10, 0}, {40, 0}}, 90.0), 0) << "too fast";
  EXPECT_EQ(page.draw({{10, 0}, {40, 0}}, 70.0), 1);
}

TEST(Retrace, R71_DoesNotHoldAPenAgainAtOnce) {
  Page page;
  page.fixture.add(testing::polyline_stroke({{0.0, 0.0}, {200.0, 0.0}}));
  EXPECT_EQ(page.draw({{10, 0}, {20, 0}}), 1);
  page.move({24, 0}, 130.0);
  EXPECT_FALSE(page.retrace.line());
  page.move({30, 0}, 40.0);
  EXPECT_FALSE(page.retrace.line());
  page.move({60.0, 0.0}, 40.0);
  EXPECT_TRUE(page.retrace.line());
}

TEST(Retrace, R71_HatchingsAndZigzagsDoNotHold) {
  Page page;
  for (int i = 0; i < 4; ++i) {
    page.fixture.add(testing::polyline_stroke({{0.0, 1.2 * i}, {40.0, 1.2 * i}}));
  }
  EXPECT_EQ(page.draw({{2.0, 0.1}, {38.0, 0.1}}), 0) << "beside its neighbour";
  EXPECT_EQ(page.draw({{2.0, 1.3}, {38.0, 1.3}}), 0) << "between two";

  Page zigzag;
  std::vector<Point> path;
  for (int i = 0; i < 60; ++i) path.push_back({i % 2 == 0 ? 0.0 : 12.0, 0.5 * i});
  zigzag.fixture.add(testing::polyline_stroke(path));
  EXPECT_EQ(zigzag.draw({{6.0, 1.0}, {6.0, 29.0}}), 0) << "across its legs";
}

TEST(Retrace, R71_APenThatLeapsToAnotherPartOfTheLineIsLetGo) {
  Page page;
  std::vector<Point> path = {{0.0, 0.0}, {15.0, 0.0}};
  for (int i = 1; i < 30; ++i) path.push_back({15.0 + i, i % 2 == 0 ? 0.0 : 12.0});
  page.fixture.add(testing::polyline_stroke(path));
  EXPECT_EQ(page.draw({{1.0, 0.1}, {14.0, 0.1}, {17.0, 3.0}, {42.0, 3.0}}), 1);
  EXPECT_FALSE(page.retrace.line());
}

TEST(Retrace, R71_HoldsAlongAClosedLinePastItsSeam) {
  Page page;
  std::vector<Point> circle;
  for (int i = 0; i <= 90; ++i) {
    const double a = kTau * i / 90.0;
    circle.push_back({15.0 * std::cos(a), 15.0 * std::sin(a)});
  }
  circle.back() = circle.front();
  page.fixture.add(testing::polyline_stroke(circle, true));
  std::vector<Point> path(circle.begin() + 60, circle.end());
  path.insert(path.end(), circle.begin() + 1, circle.begin() + 40);
  EXPECT_EQ(page.draw(path), 1);
  EXPECT_TRUE(page.retrace.line());
}

TEST(Retrace, WithoutTimeNothingHolds) {
  Page page;
  page.fixture.add(testing::polyline_stroke({{0.0, 0.0}, {80.0, 0.0}}));
  page.step_ns = 0;
  EXPECT_EQ(page.draw({{10.0, 0.1}, {40.0, 0.1}}), 0);
}

TEST(Retrace, LinesThatCannotBeSeenDoNotHold) {
  Page page;
  page.fixture.add(testing::polyline_stroke({{0.0, 0.0}, {80.0, 0.0}}));
  LayerState state = page.fixture.document.layers().front().state();
  for (const bool is_locked : {true, false}) {
    const LayerState before = state, after{state.name, is_locked, is_locked};
    page.fixture.apply({"State", {}, {{page.fixture.layer, before, after, 0, 0}}});
    state = after;
    EXPECT_EQ(page.draw({{10.0, 0.1}, {30.0, 0.1}}), is_locked ? 1 : 0);
  }
}

RC_GTEST_PROP(Retrace, HoldsAreBoundedAndGiveAtMostAFifthOfAMillijoule, ()) {
  Page page;
  std::vector<Point> line, path;
  const double bend = 0.1 * *rc::gen::inRange(-100, 101);
  const double off = 0.01 * *rc::gen::inRange(-60, 61);
  const double sway = 0.01 * *rc::gen::inRange(0, 120);
  const double waves = *rc::gen::inRange(1, 12);
  for (int i = 0; i <= 120; ++i) {
    const double x = 0.5 * i, y = bend * std::sin(0.1 * x);
    line.push_back({x, y});
    path.push_back({x, y + off + sway * std::sin(waves * 0.1 * x)});
  }
  page.fixture.add(testing::polyline_stroke(line));
  const double speed = *rc::gen::inRange(5, 80);
  int holds = page.draw(path, speed);
  std::reverse(path.begin(), path.end());
  holds += page.draw(path, speed);
  if (std::fabs(off) < 0.3 && sway < 0.05) RC_ASSERT(holds >= 2);
  RC_ASSERT(page.max_n <= kForceN + 1e-9);
  RC_ASSERT(page.max_mj <= 0.2);
}

}  // namespace
}  // namespace felt::retrace_test
