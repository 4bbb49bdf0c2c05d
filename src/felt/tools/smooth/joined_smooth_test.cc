#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "felt/tools/smooth/smooth_tool.h"
#include "felt/tools/smooth/testing/jitter_ink.h"
#include "felt/tools/testing/joined_drawing.h"

namespace felt::joined_smooth_test {
namespace {

using testing::JoinedDrawing;
using testing::Pen;

/// Strokes may be this much farther from each other after smoothing than before it.
constexpr double kApartMm = 0.03;

/// A line with jitter, on which other lines stand, and a pen that rubs along it.
struct Smoothed : JoinedDrawing {
  explicit Smoothed(std::uint64_t seed) : JoinedDrawing(seed) {
    const Jitter jitter{random.uniform(0.1, 0.4), random.chance(0.5) ? 3.0 : 0.0};
    const double bend = random.uniform(-12, 12);
    path = [bend](double t) { return Point{80 * t, bend * t * (1 - t) * 4}; };
    base = fixture.add(testing::jittery(path, jitter, seed));
    ids.push_back(base);
  }
  using Jitter = testing::Jitter;

  void add_posts() {
    const StrokePtr on = fixture.document.find(base);
    for (int k = random.pick(1, 5); k > 0; --k) {
      const double u = random.uniform(0.05, 0.95) * on->segment_count();
      post(base, u,
           on->position(u) + random.uniform(5, 30) * (direction(random.uniform(0, 360)) - Point{}));
    }
    // A line that begins at the end of the jittery one, and a bridge.
    shared.push_back({line(on->position(on->segment_count()), {90, 40}), false, base});
    const double n = on->segment_count();
    const StrokeId bridge = line(on->position(0.3 * n), on->position(0.6 * n));
    shared.push_back({bridge, false, base});
    shared.push_back({bridge, true, base});
    note_gaps();
  }
  std::pair<double, double> rub() {
    SmoothTool tool;
    Pen pen{tool, fixture};
    pen.pressure = 0.8;
    Edit last;
    double during = 0.0;
    pen.up(path(0));
    for (int k = 0; k <= 1500; ++k) {
      const double t = 0.5 - 0.5 * std::cos(0.01 * k);
      ToolResult result = pen.at({path(t).x, path(t).y, -1.0});
      if (result.preview) last = *result.preview;
      if (result.preview) during = std::max(during, worst_gap_mm(last));
    }
    pen.up(path(1));
    commits = pen.commits;
    return {during, worst_gap_mm({})};
  }

  testing::Way path;
  StrokeId base;
  int commits = 0;
};

TEST(JoinedSmooth, R33_LinesThatStandOnASmoothedLineFollowIt) {
  int commits = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    Smoothed d(seed);
    d.add_posts();
    const Document before = d.fixture.document;
    const auto [during, after] = d.rub();
    EXPECT_LE(during, kApartMm);
    EXPECT_LE(after, kApartMm);
    commits += d.commits;
    if (d.commits == 0) continue;
    d.fixture.undo();
    EXPECT_EQ(d.fixture.document, before) << "one step";
  }
  EXPECT_GT(commits, 27);
}

TEST(JoinedSmooth, R33_APointOnALockedLineStays) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    Smoothed d(seed);
    const StrokePtr on = d.fixture.document.find(d.base);
    const Point foot = on->position(0.4 * on->segment_count());
    d.begin_locked();
    const StrokeId locked = d.line(foot, foot + Vec{0, 30});
    d.end_locked();
    const StrokePtr held = d.fixture.document.find(locked);
    d.shared = {{locked, false, d.base}};
    d.note_gaps();
    const auto [during, after] = d.rub();
    EXPECT_EQ(d.fixture.document.find(locked), held);
    EXPECT_LE(std::max(during, after), kApartMm);
  }
}

}  // namespace
}  // namespace felt::joined_smooth_test
