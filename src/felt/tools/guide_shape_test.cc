#include "felt/tools/guide_shape.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "felt/base/constants.h"

namespace felt::guide_shape_test {
namespace {

double from_tenths(int low, int high) {
  return 0.1 * *rc::gen::inRange(low, high);
}

GuideEllipse any_ellipse() {
  return {{from_tenths(-500, 500), from_tenths(-500, 500)},
          from_tenths(-60, 60),
          from_tenths(20, 600),
          from_tenths(20, 600)};
}

RC_GTEST_PROP(GuideShape, TheNearestPointOfAnEllipseIsNearest, ()) {
  const GuideEllipse ellipse = any_ellipse();
  const Point p = ellipse.centre + Vec{from_tenths(-900, 900), from_tenths(-900, 900)};
  const ShapeNearest near = nearest_on(ellipse, p);
  RC_ASSERT(std::fabs(std::fabs(near.distance_mm) - distance(p, near.point)) < 1e-9);
  for (int i = 0; i < 2000; ++i) {
    RC_ASSERT(distance(p, point_at(ellipse, kTau * i / 2000)) >= distance(p, near.point) - 1e-6);
  }
  // The line to the nearest point is perpendicular to the ellipse.
  RC_ASSERT(std::fabs(dot(p - near.point, near.along)) <
            1e-5 * (1.0 + distance(p, ellipse.centre)));
}

RC_GTEST_PROP(GuideShape, APointOfAShapeIsItsOwnNearestPoint, ()) {
  const GuideEllipse ellipse = any_ellipse();
  const double t = from_tenths(-31, 31);
  const ShapeNearest near = nearest_on(ellipse, point_at(ellipse, t));
  RC_ASSERT(std::fabs(near.distance_mm) < 1e-6);
  RC_ASSERT(distance(near.point, point_at(ellipse, t)) < 1e-6);
  RC_ASSERT(std::fabs(norm(near.along) - 1.0) < 1e-12);
}

TEST(GuideShape, TheSideOfALineHasASign) {
  const GuideStraight line{{10.0, 0.0}, {1.0, 0.0}, 0.0, 50.0};
  EXPECT_DOUBLE_EQ(nearest_on(line, {20.0, 3.0}).distance_mm, 3.0);
  EXPECT_DOUBLE_EQ(nearest_on(line, {20.0, -3.0}).distance_mm, -3.0);
  EXPECT_DOUBLE_EQ(nearest_on(line, {-20.0, 0.0}).at, -30.0) << "beyond the end";
}

TEST(GuideShape, PointsAreOnTheShape) {
  const GuideStraight line{{10.0, 0.0}, {1.0, 0.0}, 0.0, 50.0};
  EXPECT_EQ(guide_points(line, {20.0, 3.0}), (std::vector<Point>{{10.0, 0.0}, {60.0, 0.0}}));
  const auto endless = guide_points(GuideStraight{{0.0, 0.0}, {1.0, 0.0}}, {300.0, 3.0});
  EXPECT_EQ(endless[1].x, 1500.0);
  const GuideEllipse circle{{5.0, 5.0}, 0.3, 40.0, 40.0};
  const auto points = guide_points(circle, {});
  EXPECT_GT(points.size(), 600U);
  for (const Point& p : points) EXPECT_NEAR(distance(p, circle.centre), 40.0, 1e-9);
  EXPECT_NEAR(ellipse_mm(circle), kTau * 40.0, 1e-9);
}

TEST(GuideShape, TheCentreOfACircleHasANearestPoint) {
  const GuideEllipse circle{{5.0, 5.0}, 0.0, 40.0, 40.0};
  EXPECT_NEAR(std::fabs(nearest_on(circle, {5.0, 5.0}).distance_mm), 40.0, 1e-9);
}

}  // namespace
}  // namespace felt::guide_shape_test
