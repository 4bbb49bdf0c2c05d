#include "felt/tools/eraser/guard_ridge.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "felt/base/constants.h"
#include "felt/geometry/polyline.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/testing/feel_rig.h"
#include "felt/tools/eraser/eraser_force.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::guard_ridge_test {
namespace {

using testing::polyline_stroke;
using testing::straight_stroke;

constexpr double kForceN = 0.25, kRadiusMm = 2.0;

/// A page on which an eraser moves, with the haptic loop's force at each sample.
class Page {
 public:
  Page() { fixture.device.max_damping_n_s_per_m = 10.0; }

  void move(Point to, double speed_mm_per_s = 50.0) {
    const int steps =
        std::max(1, static_cast<int>(std::ceil(distance(at_, to) / (0.001 * speed_mm_per_s))));
    const Point from = at_;
    for (int i = 1; i <= steps; ++i) sample(lerp(from, to, double(i) / steps));
  }
  void touch(Point at) {
    guard.end();
    at_ = at;
    max_n = work_mj = 0.0;
    sample(at);
  }
  [[nodiscard]] Point at() const noexcept { return at_; }
  void rest(int ms) {
    for (int i = 0; i < ms; ++i) sample(at_);
  }

  testing::Fixture fixture;
  EraserSettings settings{.radius_mm = kRadiusMm, .guard_n = kForceN};
  EraserMode mode = EraserMode::kTouched;
  GuardRidge guard;
  Force force;
  double max_n = 0.0, max_step_n = 0.0;  ///< size of the force, and its change in a millisecond
  double work_mj = 0.0, hold_mj = 0.0, max_hold_mj = 0.0;  ///< on the hand

 private:
  void sample(Point to) {
    const Vec moved = to - at_;
    at_ = to;
    PenSample pen;
    pen.time_ns = time_ns_ += kMs;
    pen.position = {to.x, to.y, -0.5};
    pen.velocity = {1000.0 * moved.x, 1000.0 * moved.y, 0.0};
    guard.update(pen, mode, settings, fixture.scene());
    memory_.begin_tick(0.001);
    const Force before = force;
    force = guard.force() ? (*guard.force())(pen, memory_) : Force{};
    max_step_n = std::max(max_step_n, norm(force - before));
    max_n = std::max(max_n, norm(force));
    const double work = force.x * moved.x + force.y * moved.y;
    work_mj += work;
    hold_mj = guard.line() && guard.number() == hold_ ? hold_mj + work : work;
    hold_ = guard.number();
    max_hold_mj = std::max(max_hold_mj, hold_mj);
  }

  ForceMemory memory_;
  std::int64_t time_ns_ = 0;
  std::uint32_t hold_ = 0;
  Point at_;
};

TEST(GuardRidge, R72_TheEraserStopsBesideALineThatItHasNotTouched) {
  Page page;
  page.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
  const StrokeId other = page.fixture.add(straight_stroke({30, -20}, {30, 20}, 1, 1));
  page.touch({10, 0});
  EXPECT_FALSE(page.guard.line()) << "the line at the touch is meant";
  page.move({26.2, 0});
  EXPECT_EQ(page.max_n, 0.0) << "1.3 mm between the eraser and the other line";
  page.move({27.5, 0});
  EXPECT_EQ(page.guard.line(), other);
  page.rest(200);
  EXPECT_NEAR(page.force.x, -kForceN, 0.01) << "they touch";
  EXPECT_NEAR(page.force.y, 0.0, 0.01);
  page.move({10, 0});
  EXPECT_FALSE(page.guard.line());
  EXPECT_LT(page.work_mj, 0.0) << "a hand gains no energy";
}

TEST(GuardRidge, R72_NothingPushesBeforeTheFirstInk) {
  Page page;
  page.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
  page.touch({30, 20});
  page.move({30, 0});
  page.move({50, 0});
  EXPECT_EQ(page.max_n, 0.0);
}

TEST(GuardRidge, R72_AHandThatPushesOnErasesTheLineAndAfterTwoTheWholeArea) {
  Page page;
  page.fixture.add(straight_stroke({0, 0}, {90, 0}, 1, 1));
  for (const double x : {20.0, 40.0, 60.0, 80.0}) {
    page.fixture.add(straight_stroke({x, -20}, {x, 20}, 1, 1));
  }
  page.touch({8, 0});
  page.move({18.6, 0});
  EXPECT_NEAR(page.max_n, kForceN, 0.02);
  page.move({20, 0});
  EXPECT_FALSE(page.guard.line()) << "passed";
  page.max_n = 0.0;
  page.move({8, 0});
  page.move({24, 0});
  EXPECT_EQ(page.max_n, 0.0) << "a line that was passed is meant";
  page.move({40, 0});
  EXPECT_NEAR(page.max_n, kForceN, 0.02);
  page.max_n = 0.0;
  page.move({90, 0});
  EXPECT_EQ(page.max_n, 0.0) << "two lines were passed";
  page.touch({8, 0});
  page.move({18, 0});
  EXPECT_GT(page.max_n, 0.1) << "the next gesture is guarded again";
}

TEST(GuardRidge, R72_ALineEndsWhereItsInkEnds) {
  Page page;
  page.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
  page.fixture.add(straight_stroke({30, 5}, {30, 20}, 1, 1));
  page.touch({10, 0});
  page.move({50, 0});
  EXPECT_EQ(page.max_n, 0.0) << "5 mm below the end";
  page.touch({10, 0});
  page.move({30, 0});
  page.move({30, 2.4});
  page.rest(100);
  EXPECT_LT(page.force.y, -0.2) << "towards the end";
}

TEST(GuardRidge, R72_ShortLinesDotsAndClosedLinesPushFromAllSides) {
  const Stroke square = polyline_stroke({{28, 4}, {32, 4}, {32, 8}, {28, 8}, {28, 4}}, true);
  for (const Stroke& other : {straight_stroke({30, 4}, {30.06, 4}, 1, 1),
                              straight_stroke({29, 4}, {31, 4}, 1, 1), square}) {
    Page page;
    page.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
    page.fixture.add(other);
    page.touch({10, 0});
    page.move({30, 0});
    page.move({30, 1.6});
    page.rest(100);
    EXPECT_LT(page.force.y, -0.2);
    EXPECT_TRUE(std::isfinite(norm(page.force)));
  }
}

TEST(GuardRidge, R72_TheModesGuardWhatTheyErase) {
  Page page;
  page.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
  page.fixture.add(straight_stroke({30, -20}, {30, 20}, 1, 1));
  page.mode = EraserMode::kCrossing;
  page.touch({10, 0});
  page.move({28.6, 0});
  EXPECT_EQ(page.max_n, 0.0) << "the path of the pen erases, not the ring";
  page.move({29.8, 0});
  EXPECT_GT(page.max_n, 0.2);
  page.mode = EraserMode::kStroke;
  page.touch({10, 0});
  page.move({27.5, 0});
  EXPECT_GT(page.max_n, 0.2);
}

TEST(GuardRidge, R72_NothingPushesWithoutTheOptionWithoutForcesOrWithALargeEraser) {
  for (const int which : {0, 1, 2}) {
    Page page;
    page.fixture.add(straight_stroke({0, 0}, {60, 0}, 1, 1));
    page.fixture.add(straight_stroke({30, -20}, {30, 20}, 1, 1));
    if (which == 0) page.settings.guard_n = 0.0;
    if (which == 1) page.fixture.device.max_force_n = 0.0;
    if (which == 2) page.settings.radius_mm = 12.0;
    page.touch({10, 0});
    page.move({28, 0});
    EXPECT_EQ(page.max_n, 0.0) << which;
  }
}

TEST(GuardRidge, R72_TheForceDoesNotLeapBetweenTwoPartsOfALine) {
  for (const double apart : {4.0, 6.0}) {
    Page page;
    page.fixture.add(straight_stroke({-20, 30}, {60, 30}, 1, 1));
    page.fixture.add(polyline_stroke({{0, 0}, {0, -40}, {apart, -40}, {apart, 0}}));
    page.touch({-10, 30});
    page.move({0.5 * apart, 6});
    page.max_step_n = 0.0;
    page.move({0.5 * apart, 4});
    for (int i = 0; i < 8; ++i) {
      page.move({0.5 * apart + (i % 2 == 0 ? 0.4 : -0.4), 3.0 - 0.1 * i}, 10.0);
    }
    EXPECT_LT(page.max_step_n, 0.03) << apart;
  }
}

RC_GTEST_PROP(GuardRidge, R72_TheForceIsBoundedAndPointsAwayFromTheLine, ()) {
  const auto mm = [](int low, int high) { return 0.1 * *rc::gen::inRange(10 * low, 10 * high); };
  Page page;
  page.settings.radius_mm = mm(1, 5);
  page.fixture.add(straight_stroke({-50, 0}, {50, 0}, 1, 1));
  const Point a{mm(-20, 20), -30}, b{mm(-20, 20), 30};
  page.fixture.add(straight_stroke(a, b, 1, 1));
  page.touch({-50, 0});
  for (int i = 0; i < 6; ++i) {
    page.move({mm(-50, 50), mm(-2, 2)}, mm(10, 200));
    RC_ASSERT(page.max_n <= kForceN + 1e-9);
    const Vec away = page.at() - nearest_on_line(a, b, page.at()).point;
    page.rest(1);  // without damping
    RC_ASSERT(dot(Vec{page.force.x, page.force.y}, away) >= -1e-9);
    // The ridge is 0.25 N high, 1.5 mm long and has a rim of 1.2 mm; damping takes energy.
    RC_ASSERT(page.max_hold_mj <= 0.55);
  }
}

RC_GTEST_PROP(GuardRidge, R72_ALineThatThePenCrossesIsPassedAtEverySpeedAndRadius, ()) {
  const auto mm = [](int low, int high) { return 0.01 * *rc::gen::inRange(100 * low, 100 * high); };
  Page page;
  page.settings.radius_mm = *rc::gen::elementOf(std::vector<double>{0.2, 0.5, 1.0, 2.0, 5.0, 10.0});
  page.fixture.add(straight_stroke({-60, 0}, {60, 0}, 0.1, 0.1));
  const double x = mm(-10, 10);
  const StrokeId other = page.fixture.add(straight_stroke({x, -30}, {x, 30}, 0.1, 0.1));
  page.touch({-40, 0});
  page.move({40, 0}, *rc::gen::elementOf(std::vector<double>{50.0, 400.0, 5'000.0, 80'000.0}));
  RC_ASSERT(!page.guard.is_guarded(other));
}

TEST(GuardRidge, R72_IsCalmWithEveryGripAndDelay) {
  for (int delay = 0; delay <= 2; ++delay) {
    rig::for_each_grip(0.001, delay, [&](const rig::Setup& setup) {
      Page page;
      page.fixture.device = setup.capabilities();
      page.fixture.add(straight_stroke({-60, 0}, {60, 0}, 1, 1));
      page.fixture.add(straight_stroke({0, -30}, {0, 30}, 1, 1));
      page.touch({-10, 0});
      page.move({-3, 0});
      EraserSettings settings;
      settings.guard_n = kForceN;
      rig::Bench bench(setup, make_eraser_force(settings, page.fixture.scene(), page.guard),
                       {-4, 0, 1});
      const double aim_z = rig::aim_z_mm(setup.hand, 1.0, 500.0);
      // The hand presses against the ridge with about half of its force.
      const double press_mm = 500.0 * kForceN / setup.hand.stiffness_n_per_m;
      bench.run(1.0, [&](double t) -> Vec3 {
        return {-4.0 + std::min(1.0, t / 0.8) * (1.0 + press_mm), 0.0, aim_z};
      });
      bench.begin_measuring();
      bench.run(1.0, [&](double) -> Vec3 { return {-3.0 + press_mm, 0.0, aim_z}; });
      EXPECT_LT(bench.figures().hf_n, 0.03) << setup.name();
    });
  }
}

}  // namespace
}  // namespace felt::guard_ridge_test
