#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "felt/tools/pull/pull_tool.h"
#include "felt/tools/testing/joined_drawing.h"

namespace felt::joined_lines_test {
namespace {

using testing::JoinedDrawing;
using testing::Pen;
using testing::way;

/// Strokes may be this much farther from each other after a pull than before it.
constexpr double kApartMm = 0.03;

/// A drawing whose strokes share points, and a pen that pulls one of them.
struct Pulled : JoinedDrawing {
  using JoinedDrawing::JoinedDrawing;

  PullTool tool;

  /// Pulls a random stroke, most often near a shared point, along a random path. Returns the
  /// largest gap of the previews and of the result.
  std::pair<double, double> pull() {
    const StrokeId id =
        ids[static_cast<std::size_t>(random.pick(0, static_cast<int>(ids.size()) - 1))];
    const StrokePtr stroke = fixture.document.find(id);
    const double part = random.chance(0.5) ? random.uniform(0, 1) : random.chance(0.5) ? 0.0 : 1.0;
    const Point start = stroke->position(part * stroke->segment_count()) +
                        random.uniform(0, 2) * (direction(random.uniform(0, 360)) - Point{});
    const Point turn =
        start + random.uniform(1, 25) * (direction(random.uniform(0, 360)) - Point{});
    const Point stop = turn + random.uniform(0, 10) * (direction(random.uniform(0, 360)) - Point{});
    Pen pen{tool, fixture};
    pen.up(start);
    std::vector<Point> path = way(start, turn, 0.8);
    for (const Point p : way(turn, stop, 0.8)) path.push_back(p);
    Edit last;
    double during = 0.0;
    for (const Point p : path) {
      ToolResult result = pen.at({p.x, p.y, -1.0});
      if (result.preview) last = *result.preview;
      during = std::max(during, worst_gap_mm(last));
    }
    pen.up(path.back());
    return {during, worst_gap_mm({})};
  }
};

constexpr const char* kModes[] = {"brush", "grab", "sweep", "bulge", "pinch"};

TEST(JoinedLines, R33_JunctionsHoldWhereverALineIsPulled) {
  for (std::uint64_t k = 0; k < 1000 * std::size(kModes); ++k) {
    const std::uint64_t seed = k / std::size(kModes);
    const char* mode = kModes[k % std::size(kModes)];
    SCOPED_TRACE(mode + (" " + std::to_string(seed)));
    Pulled d(seed);
    ASSERT_TRUE(d.tool.set_option("mode", std::string(mode)));
    d.draw(seed);
    d.note_gaps();
    const auto [during, after] = d.pull();
    EXPECT_LE(during, kApartMm);
    EXPECT_LE(after, kApartMm);
  }
}

TEST(JoinedLines, R33_JunctionsHoldThroughManyPulls) {
  for (std::uint64_t n = 0; n < 60 * std::size(kModes); ++n) {
    const std::uint64_t seed = n / std::size(kModes);
    const char* mode = kModes[n % std::size(kModes)];
    SCOPED_TRACE(mode + (" " + std::to_string(seed)));
    Pulled d(seed);
    ASSERT_TRUE(d.tool.set_option("mode", std::string(mode)));
    d.draw(seed);
    d.note_gaps();
    for (int k = 0; k < 6; ++k) {
      const auto [during, after] = d.pull();
      EXPECT_LE(during, kApartMm) << k;
      EXPECT_LE(after, kApartMm) << k;
    }
  }
}

TEST(JoinedLines, R33_LinesStayJoinedToLockedOnes) {
  for (std::uint64_t k = 0; k < 200 * std::size(kModes); ++k) {
    const std::uint64_t seed = k / std::size(kModes);
    const char* mode = kModes[k % std::size(kModes)];
    SCOPED_TRACE(mode + (" " + std::to_string(seed)));
    Pulled d(seed);
    ASSERT_TRUE(d.tool.set_option("mode", std::string(mode)));
    // The locked line begins on the middle of a line, and two lines end on its middle.
    const StrokeId base = d.line({5, -40}, {45, -20});
    const StrokePtr on = d.fixture.document.find(base);
    d.begin_locked();
    const StrokeId locked =
        d.line(on->position(d.random.uniform(0.1, 0.9) * on->segment_count()), {25, 30});
    d.end_locked();
    const StrokePtr held = d.fixture.document.find(locked);
    const Point foot = held->position(d.random.uniform(0.1, 0.9) * held->segment_count());
    const StrokeId a = d.line({-30, 0}, foot), b = d.line(foot, {0, 40});
    d.shared = {{a, true, locked}, {b, false, locked}, {a, true, b}, {locked, false, base}};
    d.ids = {base, a, b};
    d.note_gaps();
    const auto [during, after] = d.pull();
    EXPECT_EQ(d.fixture.document.find(locked), held);
    EXPECT_LE(during, kApartMm);
    EXPECT_LE(after, kApartMm);
  }
}

}  // namespace
}  // namespace felt::joined_lines_test
