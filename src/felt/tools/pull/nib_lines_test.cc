#include "felt/tools/pull/nib_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "felt/tools/junctions.h"
#include "felt/tools/pull/pull_tool.h"
#include "felt/tools/testing/joined_drawing.h"

namespace felt::nib_lines_test {
namespace {

using testing::distance_to;
using testing::Fixture;
using testing::JoinedDrawing;
using testing::Pen;
using testing::way;

constexpr double kNibMm = 3.0;
constexpr double kClearMm = 1e-6;
/// Strokes may be this much farther from each other than before the push.
constexpr double kGapMm = 0.03;

/// A drawing whose strokes share points, and a pen that pushes through it.
struct Drawing : JoinedDrawing {
  using JoinedDrawing::JoinedDrawing;

  PullTool tool;

  /// The largest growth of a gap and the deepest place of a stroke under the nib.
  struct Worst {
    double gap_mm = 0.0, under_mm = 0.0;
  };
  void note(Point pen, const Edit& preview, Worst& worst) const {
    worst.gap_mm = std::max(worst.gap_mm, worst_gap_mm(preview));
    for (const StrokeId id : ids) {
      worst.under_mm = std::max(worst.under_mm, kNibMm - distance_to(shown(id, preview), pen));
    }
  }
  /// Pushes along a random path near the origin. Returns the worst of the previews and of the
  /// result.
  std::pair<Worst, Worst> push(double step_mm) {
    const Vec d = direction(random.uniform(0, 360)) - Point{};
    const Point beside = Point{} + random.uniform(-4, 4) * perp(d);
    const Point turn = beside + random.uniform(-2, 12) * d;
    const Vec e = random.uniform(0, 1) < 0.7 ? d : direction(random.uniform(0, 360)) - Point{};
    std::vector<Point> path = way(beside - 20 * d, turn, step_mm);
    for (const Point p : way(turn, turn + 6 * e, step_mm)) path.push_back(p);
    Pen pen{tool, fixture};
    pen.up(path.front());
    Edit last;
    Worst during, after;
    for (const Point p : path) {
      ToolResult result = pen.at({p.x, p.y, -1.0});
      if (result.preview) last = *result.preview;
      note(p, last, during);
    }
    pen.up(path.back());
    note(path.back(), {}, after);
    return {during, after};
  }
};

TEST(NibLines, R33_JunctionsUnderTheNibHold) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Drawing d(seed);
    ASSERT_TRUE(d.tool.set_option("mode", std::string("push")));
    d.draw(seed);
    d.note_gaps();
    const double step = seed % 5 == 0 ? 2.5 : seed % 3 == 0 ? 0.9 : 0.3;
    const auto [during, after] = d.push(step);
    EXPECT_LE(during.gap_mm, kGapMm);
    EXPECT_LE(after.gap_mm, kGapMm);
    EXPECT_LE(during.under_mm, kClearMm);
    EXPECT_LE(after.under_mm, kClearMm);
  }
}

TEST(NibLines, R33_JunctionsHoldThroughManyPushes) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Drawing d(seed);
    ASSERT_TRUE(d.tool.set_option("mode", std::string("push")));
    d.draw(seed);
    d.note_gaps();
    for (int k = 0; k < 6; ++k) {
      const auto [during, after] = d.push(0.5);
      EXPECT_LE(during.gap_mm, kGapMm) << k;
      EXPECT_LE(after.gap_mm, kGapMm) << k;
      EXPECT_LE(after.under_mm, kClearMm) << k;
    }
  }
}

/// A nib that leaps from far away through all lines goes in kMaxSteps steps in all.
TEST(NibLines, R33_JunctionsHoldWhenTheNibLeapsThroughThem) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Drawing d(seed);
    ASSERT_TRUE(d.tool.set_option("mode", std::string("push")));
    d.draw(seed);
    d.note_gaps();
    Pen pen{d.tool, d.fixture};
    const Vec far = 1e8 * (d.direction(d.random.uniform(0, 360)) - Point{});
    pen.up(Point{} - far);
    Drawing::Worst worst;
    for (const double part : {-1.0, -0.2, 0.3, -0.1, 1e-7}) {
      const Point p = Point{} + part * far;
      const ToolResult result = pen.at({p.x, p.y, -1.0});
      d.note(p, result.preview.value_or(Edit{}), worst);
    }
    pen.up(Point{} + 1e-7 * far);
    EXPECT_LE(worst.gap_mm, kGapMm);
  }
}

TEST(NibLines, R33_PointsThatNearlyTouchKeepTheirDistance) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Drawing d(seed);
    ASSERT_TRUE(d.tool.set_option("mode", std::string("push")));
    const Vec off = 0.018 * (d.direction(d.random.uniform(0, 360)) - Point{});
    const StrokeId a = d.line({-30, 0}, {0, 0}), b = d.line(Point{} + off, {5, 30});
    d.shared.push_back({a, true, b, 0.018});
    const auto [during, after] = d.push(0.4);
    EXPECT_LE(during.gap_mm, kGapMm);
    EXPECT_LE(after.gap_mm, kGapMm);
    EXPECT_LE(after.under_mm, kClearMm);
  }
}

/// The lines are joined to the middle of a locked line, or the locked line ends on their middle.
/// The nib may also reach the locked point, which it cannot clear.
TEST(NibLines, R33_LinesStayJoinedToLockedOnes) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Drawing d(seed);
    ASSERT_TRUE(d.tool.set_option("mode", std::string("push")));
    Fixture& f = d.fixture;
    const double x = seed % 2 == 0 ? 25.0 : d.random.uniform(0, 12);
    const StrokeId base = d.line({x - 20, -40}, {x + 20, -20});
    const Stroke on = *f.document.find(base);
    d.begin_locked();
    const StrokeId locked =
        d.line(on.position(d.random.uniform(0.1, 0.9) * on.segment_count()), {x, 30});
    d.end_locked();
    const Stroke before = *f.document.find(locked);
    const Point foot = before.position(d.random.uniform(0.1, 0.9) * before.segment_count());
    const StrokeId a = d.line({-30, 0}, foot), b = d.line({0, 40}, foot);
    for (const StrokeId id : {a, b}) d.shared.push_back({id, true, locked});
    d.shared.push_back({a, true, b});
    d.shared.push_back({locked, false, base});
    d.ids = {base, a, b};
    d.note_gaps();
    const auto [during, after] = d.push(0.4);
    EXPECT_EQ(*f.document.find(locked), before);
    EXPECT_LE(during.gap_mm, kGapMm);
    EXPECT_LE(after.gap_mm, kGapMm);
  }
}

}  // namespace
}  // namespace felt::nib_lines_test
