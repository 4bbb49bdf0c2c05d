#include "felt/tools/pencil/wet_ink.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "felt/stroke/drawn_profile.h"
#include "felt/tools/pencil/pencil_tool.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::wet_ink_test {
namespace {

constexpr double kMark = -1.0;  // no ink has this tone

/// Returns how many segments were written since the last call, and marks them all.
std::size_t count_written(Overlay& overlay) {
  std::size_t written = 0;
  for (Overlay::InkSegment& segment : overlay.ink) {
    if (segment.start_tone != kMark) ++written;
    segment.start_tone = kMark;
  }
  return written;
}

/// Returns a point of a scribble at about 200 mm/s. The test draws for a minute at 1 kHz.
Point scribble(int ms) {
  const double t = 0.001 * ms;
  return {150.0 + 20.0 * std::sin(9.0 * t) + t, 100.0 + 30.0 * std::sin(7.3 * t)};
}

/// Cost of a refresh, in segments.
struct Refresh {
  std::size_t copied = 0;    ///< into the overlay
  std::size_t compared = 0;  ///< at most, by a view that has shown the previous refresh
};

Refresh most_of(const std::vector<Refresh>& refreshes, std::size_t from, std::size_t to) {
  Refresh largest;
  for (std::size_t i = from; i < to; ++i) {
    largest.copied = std::max(largest.copied, refreshes[i].copied);
    largest.compared = std::max(largest.compared, refreshes[i].compared);
  }
  return largest;
}

TEST(WetInk, ARefreshCostsTheSameWhateverTheLengthOfTheStroke) {
  testing::Fixture fixture;
  PencilTool tool;
  testing::Pen pen{tool, fixture};
  Overlay overlay;
  std::vector<Refresh> refreshes;
  std::size_t last_stable = 0;
  pen.up(scribble(0));
  for (int ms = 0; ms < 60'000; ++ms) {
    pen.down(scribble(ms));
    if (ms % 16 != 0) continue;
    overlay.clear();
    tool.draw(overlay);
    refreshes.push_back({count_written(overlay), overlay.ink.size() - last_stable});
    last_stable = overlay.ink_stable;
  }
  const std::size_t tenth = refreshes.size() / 10;
  const Refresh early = most_of(refreshes, 0, tenth);
  const Refresh late = most_of(refreshes, refreshes.size() - tenth, refreshes.size());
  EXPECT_GT(overlay.ink.size(), 5'000U);
  EXPECT_LT(10 * early.copied, overlay.ink.size());
  EXPECT_LT(late.copied, 2 * early.copied);
  EXPECT_LT(late.compared, 2 * early.compared);
}

/// The stable pieces have the widths that the finished stroke is drawn with, also between its
/// breakpoints.
TEST(WetInk, StablePiecesHaveTheDrawnWidthsOfTheStroke) {
  testing::Fixture fixture;
  PencilTool tool;
  ASSERT_TRUE(tool.set_option("refine", false));
  ASSERT_TRUE(tool.set_option("snap", std::string("off")));
  testing::Pen pen{tool, fixture};
  Overlay overlay;
  pen.up(scribble(0));
  for (int ms = 0; ms < 2'000; ++ms) {
    pen.pressure = 0.5 + 0.4 * std::sin(0.011 * ms);
    pen.down(scribble(ms));
    if (ms % 16 != 0) continue;
    overlay.clear();
    tool.draw(overlay);
  }
  pen.up(scribble(2'000));
  ASSERT_EQ(fixture.strokes().size(), 1U);
  const Stroke& stroke = *fixture.strokes()[0];
  ASSERT_GT(overlay.ink_stable, 100U);
  double bend = 0.0, u = 0.0;
  for (std::size_t i = 0; i < overlay.ink_stable; ++i) {
    const Overlay::InkSegment& piece = overlay.ink[i];
    // The pieces are in order, so the search goes on from the last one.
    const auto off = [&](double at) { return distance(stroke.position(at), piece.curve.p[0]); };
    double nearest = u;
    for (double at = u; at < u + 1.0; at += 1e-4) nearest = off(at) < off(nearest) ? at : nearest;
    u = nearest;
    ASSERT_LE(off(u), 0.02);
    ASSERT_NEAR(piece.start_width_mm, drawn_width_mm(stroke, u), 0.02) << u;
    bend = std::max(bend, std::fabs(piece.start_width_mm - stroke.width_mm(u)));
  }
  EXPECT_GT(bend, 0.05) << "otherwise the test compares nothing that is drawn smooth";
}

}  // namespace
}  // namespace felt::wet_ink_test
