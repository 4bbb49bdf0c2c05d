#include "felt/tools/pull/connected_pull.h"

#include <gtest/gtest.h>

#include "felt/tools/desk.h"
#include "felt/tools/pull/pull_tool.h"

namespace felt {
namespace {

using testing::Desk;
using testing::Pen;
using testing::straight_stroke;
using testing::way;

struct Pull {
  Desk desk;
  PullTool tool;
  Pen pen{tool, desk};

  StrokeId add(Point a, Point b, Rgba color = {}) {
    StrokeData data = straight_stroke(a, b, 1, 1).data();
    data.color = color;
    return desk.add(Stroke::create(std::move(data)).value());
  }
  [[nodiscard]] const Stroke& at(StrokeId id) const { return *desk.document.find(id); }
};

constexpr Rgba kRed{200, 0, 0, 255};

TEST(ConnectedPull, R33_PullingASharedEndTakesTheOtherLineAlong) {
  for (const char* mode : {"brush", "sweep"}) {
    Pull p;
    ASSERT_TRUE(p.tool.set_option("mode", std::string(mode)));
    const StrokeId line = p.add({0, 0}, {80, 0}), red = p.add({80, 0}, {80, 90}, kRed);
    const Document before = p.desk.document;
    p.pen.line(way({80, 0}, {100, -9}));
    EXPECT_EQ(p.pen.commits, 1) << mode;
    const Stroke &a = p.at(line), &b = p.at(red);
    const Point end = a.position(a.segment_count());
    EXPECT_GT(distance(end, {80, 0}), 5.0) << mode;
    EXPECT_LE(distance(b.position(0), end), kSharedPointMm) << mode;
    EXPECT_EQ(b.position(b.segment_count()), (Point{80, 90}));
    p.desk.undo();
    EXPECT_EQ(p.desk.document, before) << "one step";
  }
}

TEST(ConnectedPull, R33_PullingElsewhereLeavesTheSharedEndWhereItIs) {
  Pull p;
  const StrokeId line = p.add({0, 0}, {80, 0}), red = p.add({80, 0}, {80, 90}, kRed);
  const Stroke before = p.at(red);
  p.pen.line(way({40, 0}, {40, 15}));
  EXPECT_EQ(p.at(red), before);
  EXPECT_EQ(p.at(line).position(p.at(line).segment_count()), (Point{80, 0}));
}

TEST(ConnectedPull, R33_AnEndInTheMiddleStaysOnTheLineThatIsPulled) {
  Pull p;
  const StrokeId line = p.add({0, 0}, {80, 0}), post = p.add({40, 70}, {40, 0}, kRed);
  const StrokeId far = p.add({5, 70}, {5, 0}, kRed);
  const Stroke unmoved = p.at(far);
  p.pen.line(way({42, 0}, {42, -15}));
  const Stroke& end = p.at(post);
  const Point tip = end.position(end.segment_count());
  EXPECT_LT(tip.y, -10.0);
  double gap = 1e300;
  for (int i = 0; i < p.at(line).segment_count(); ++i) {
    gap = std::min(gap, nearest(p.at(line).segment(i), tip).distance_squared);
  }
  EXPECT_LE(std::sqrt(gap), 0.15) << "the refit at the lift may move the line a little";
  EXPECT_EQ(p.at(far), unmoved) << "beyond the reach of the brush";
}

TEST(ConnectedPull, R33_TheLineThatAPulledEndStandsOnFollows) {
  Pull p;
  const StrokeId base = p.add({0, 0}, {80, 0}, kRed), post = p.add({40, 70}, {40, 0});
  p.pen.line(way({40, 0.5}, {40, -14.5}));
  const Stroke& moved = p.at(post);
  const Point tip = moved.position(moved.segment_count());
  double gap = 1e300;
  for (int i = 0; i < p.at(base).segment_count(); ++i) {
    gap = std::min(gap, nearest(p.at(base).segment(i), tip).distance_squared);
  }
  EXPECT_LE(std::sqrt(gap), 0.15);
}

TEST(ConnectedPull, R33_AnEndOnALockedLineIsHeld) {
  Pull p;
  p.desk.apply({"Layer", {}, {{{2}, std::nullopt, LayerState{"Other"}, 0, 1}}});
  const StrokeId line = p.add({0, 0}, {80, 0});
  p.desk.layer = LayerId{2};
  const StrokeId red = p.add({80, 0}, {80, 90}, kRed);
  p.desk.apply({"State", {}, {{{2}, LayerState{"Other"}, LayerState{"Other", true, true}, 1, 1}}});
  p.desk.layer = LayerId{1};
  const Stroke before = p.at(red);
  p.pen.line(way({80, 0}, {100, -9}));
  EXPECT_EQ(p.at(red), before);
  EXPECT_LE(distance(p.at(line).position(p.at(line).segment_count()), {80, 0}), 1e-9);
}

TEST(ConnectedPull, ThePreviewShowsTheFollowersToo) {
  Pull p;
  p.add({0, 0}, {80, 0});
  p.add({80, 0}, {80, 90}, kRed);
  p.pen.up({80, 0});
  p.pen.down({80, 0});
  const ToolResult result = p.pen.at({90, 0, -1});
  ASSERT_TRUE(result.preview);
  EXPECT_EQ(result.preview->changes.size(), 2u);
}

}  // namespace
}  // namespace felt
