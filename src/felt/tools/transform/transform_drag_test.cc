#include "felt/tools/transform/transform_drag.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "felt/haptics/bricks/tether.h"

namespace felt::transform_drag_test {
namespace {

constexpr double kDeg = std::numbers::pi / 180.0;

double distance_to(const Affine& map, Point from, Point to) {
  return distance(apply(map, from), to);
}

TEST(TransformDrag, IsNothingWhereItBegan) {
  for (int kind = 0; kind < 6; ++kind) {
    TransformDrag drag(static_cast<TransformKind>(kind), {10, 20}, {37, 4});
    EXPECT_TRUE(drag.is_identity());
    drag.update({50, 50}, false);
    EXPECT_FALSE(drag.is_identity());
    drag.update({37, 4}, false);
    EXPECT_TRUE(drag.is_identity()) << drag.label();
    drag.update({50, 50}, true);
    drag.update({37, 4}, true);
    EXPECT_TRUE(drag.is_identity()) << drag.label();
  }
}

TEST(TransformDrag, MovesWithThePen) {
  TransformDrag drag(TransformKind::kMove, {0, 0}, {5, 5});
  drag.update({8, 1}, false);
  EXPECT_EQ(drag.map(), translation({3, -4}));
  EXPECT_EQ(drag.text(), "3.0, -4.0 mm");
  EXPECT_EQ(drag.label(), "Move");
  drag.update({8, 1}, true);
  EXPECT_EQ(drag.map(), translation({0, -4}));
}

TEST(TransformDrag, TheGrabbedPointStaysUnderThePen) {
  TransformDrag turn(TransformKind::kRotate, {10, 10}, {30, 10});
  turn.update({10, 30}, false);
  EXPECT_LE(distance_to(turn.map(), {30, 10}, {10, 30}), 1e-12);
  EXPECT_LE(distance_to(turn.map(), {10, 10}, {10, 10}), 1e-12);
  EXPECT_EQ(turn.text(), "90.0 deg");
  TransformDrag scale(TransformKind::kScale, {10, 10}, {30, 10});
  scale.update({60, 10}, false);
  EXPECT_LE(distance_to(scale.map(), {30, 10}, {60, 10}), 1e-12);
  EXPECT_EQ(scale.text(), "x 2.50");
  TransformDrag stretch(TransformKind::kStretch, {10, 10}, {30, 20});
  stretch.update({15, 30}, false);
  EXPECT_LE(distance_to(stretch.map(), {30, 20}, {15, 30}), 1e-12);
  EXPECT_EQ(stretch.text(), "x 0.25, 2.00");
}

TEST(TransformDrag, R36_TurnsAddUpToTwoFullOnesEitherWay) {
  for (const double way : {1.0, -1.0}) {
    TransformDrag drag(TransformKind::kRotate, {0, 0}, {20, 0});
    for (double a = 0.0; a <= 725.0; a += 2.5) {
      drag.update({20 * std::cos(way * a * kDeg), 20 * std::sin(way * a * kDeg)}, false);
    }
    EXPECT_EQ(drag.text(), way > 0 ? "725.0 deg" : "-725.0 deg");
  }
}

TEST(TransformDrag, TurnsInStepsWhenConstrained) {
  TransformDrag drag(TransformKind::kRotate, {0, 0}, {20, 0});
  drag.update({20 * std::cos(50 * kDeg), 20 * std::sin(50 * kDeg)}, true);
  EXPECT_EQ(drag.text(), "45.0 deg");
  drag.update({20 * std::cos(5 * kDeg), 20 * std::sin(5 * kDeg)}, true);
  EXPECT_TRUE(drag.is_identity());
}

TEST(TransformDrag, R37_FactorsKeepToTheirRange) {
  TransformDrag drag(TransformKind::kScale, {0, 0}, {10, 0});
  drag.update({1e6, 0}, false);
  EXPECT_EQ(drag.map().a, 20.0);
  drag.update({0, 0}, false);
  EXPECT_EQ(drag.map().a, 0.05);
  // The factor is the same on both sides of the centre, as it is for the force.
  drag.update({-15, 0}, false);
  EXPECT_EQ(drag.map().a, scale_factor({10, 0}, {-15, 0}));

  TransformDrag axes(TransformKind::kStretch, {0, 0}, {10, 10});
  axes.update({-15, 1e6}, false);
  EXPECT_EQ(axes.map().a, 0.05) << "through the centre nothing is mirrored";
  EXPECT_EQ(axes.map().d, 20.0);

  TransformDrag held(TransformKind::kScale, {0, 0}, {10, 0}, 0.4);
  held.update({1, 0}, false);
  EXPECT_EQ(held.map().a, 0.4);
}

TEST(TransformDrag, StretchesTheAxesThatItHasAHoldOn) {
  TransformDrag edge(TransformKind::kStretchX, {0, 0}, {10, 7});
  edge.update({20, 50}, false);
  EXPECT_EQ(edge.map(), scaling(2.0, 1.0));
  TransformDrag above(TransformKind::kStretch, {0, 0}, {0.1, 10});
  above.update({9, 5}, false);
  EXPECT_EQ(above.map(), scaling(1.0, 0.5)) << "no hold on x so near to the centre";
  TransformDrag corner(TransformKind::kScale, {0, 0}, {10, 10});
  corner.update({20, 5}, true);
  EXPECT_EQ(corner.map(), scaling(2.0, 0.5)) << "constrained: both axes freely";
  EXPECT_EQ(corner.kind(), TransformKind::kStretch);
  EXPECT_NEAR(corner.width_factor(), 1.0, 1e-12);
}

}  // namespace
}  // namespace felt::transform_drag_test
