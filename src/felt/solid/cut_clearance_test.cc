#include "felt/solid/cut_clearance.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "felt/solid/testing/random_bodies.h"

namespace felt::cut_clearance_test {
namespace {

constexpr double kStepMm = 1e-3;

CutRegion region_of(const SolidBody& body, const ViewFrame& frame,
                    const std::vector<Point>& stroke) {
  const auto region = find_cut_region(body, frame, stroke, 1.0);
  FELT_CHECK(region && *region);
  return **region;
}

TEST(CutClearance, AStrokeAlongAMirrorAxisMovesOffThePointsThere) {
  const SolidBody ball = testing::ball(20.0);
  const ViewFrame frame = view_frame({0, 0, -1});
  CutRegion region = region_of(ball, frame, {{0, -30}, {0, 30}});
  const CutRegion before = region;
  EXPECT_GT(points_on_stroke(ball, frame, region, 0.2 * kStepMm), 10U);
  move_off_points(ball, frame, kStepMm, region);
  EXPECT_EQ(points_on_stroke(ball, frame, region, 0.2 * kStepMm), 0U);
  for (std::size_t i = 0; i < region.ring.size(); ++i) {
    EXPECT_LE(distance(region.ring[i], before.ring[i]), 8.001 * kStepMm);
  }
}

TEST(CutClearance, AStrokeBetweenThePointsStays) {
  const SolidBody ball = testing::ball(20.0);
  const ViewFrame frame = view_frame({0.1, 0.2, -1});
  CutRegion region = region_of(ball, frame, {{3.1234567, -30}, {-1.7654321, 30}});
  const CutRegion before = region;
  move_off_points(ball, frame, 1e-9, region);
  EXPECT_EQ(region.ring, before.ring);
}

TEST(CutClearance, SaysWhatGoes) {
  const SolidBody ball = testing::ball(20.0);
  const ViewFrame frame = view_frame({0, 0, -1});
  const CutRegion half = region_of(ball, frame, {{0.5, -30}, {0.5, 30}});
  EXPECT_EQ(cut_effect(ball, frame, half, kStepMm), CutEffect::kRemovesPart);
  EXPECT_EQ(cut_effect(ball, frame, half, 100.0), CutEffect::kRemovesNothing);
  const CutRegion all{{{21, -30}, {21, 30}, {-30, 30}, {-30, -30}}, 2};
  EXPECT_EQ(cut_effect(ball, frame, all, kStepMm), CutEffect::kRemovesAll);
  const CutRegion beside{{{21, 30}, {21, -30}, {30, -30}, {30, 30}}, 2};
  EXPECT_EQ(cut_effect(ball, frame, beside, kStepMm), CutEffect::kRemovesNothing);
}

// A triangle of the body can be wider than what a stroke cuts off: no corner is in the region then.
TEST(CutClearance, APartWithoutAPointOfTheBodyCounts) {
  SolidBody body;
  body.points = {{-10, 0, 0}, {10, 0, 0}, {0, 0.1, 5}, {0, -8, 5}};
  body.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {1, 0, 3}};
  const ViewFrame frame = view_frame({0, 0, -1});
  const CutRegion between{{{-1, 20}, {-1, -0.05}, {1, -0.05}, {1, 20}}, 4};
  EXPECT_EQ(cut_effect(body, frame, between, kStepMm), CutEffect::kRemovesPart);
}

RC_GTEST_PROP(CutClearance, NoPointIsOnAMovedStroke, ()) {
  Random random(*rc::gen::inRange<std::uint64_t>(1, 100000));
  const SolidBody body = testing::random_body(random, 600);
  const ViewFrame frame = view_frame(testing::random_direction(random));
  // Through two points of the body.
  const auto any = [&] {
    const auto i = static_cast<std::size_t>(random.between(0.0, 0.999) *
                                            static_cast<double>(body.points.size()));
    return frame.to_picture(body.points[i]);
  };
  const Point a = any(), b = any();
  RC_PRE(distance(a, b) > 5.0);
  const Vec far = 200.0 * normalized(b - a);
  const auto region = find_cut_region(body, frame, {a - far, b + far}, 1.0);
  RC_PRE(region && *region);
  CutRegion moved = **region;
  RC_ASSERT(points_on_stroke(body, frame, moved, 1e-9) > 0U);
  move_off_points(body, frame, 1e-4, moved);
  RC_ASSERT(points_on_stroke(body, frame, moved, 0.2e-4) == 0U);
}

}  // namespace
}  // namespace felt::cut_clearance_test
