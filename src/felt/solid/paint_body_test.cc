#include "felt/solid/paint_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/solid/testing/random_bodies.h"
#include "felt/solid/testing/surface.h"

namespace felt::paint_body_test {
namespace {

constexpr Vec3 kFromFront{0.0, 0.0, -1.0};
constexpr Rgba kRed{255, 0, 0, 255};

TEST(PaintBody, PaintsALineOfItsWidthOnTheSideThatTheEyeSees) {
  SolidBody ball = testing::ball(20.0);
  const double volume = volume_mm3(ball);
  const PaintedLine line{
      projected_line(ball, std::vector<Vec3>{{-30, 0, 0}, {30, 0, 0}}, kFromFront, 0.5), 2.0, kRed};
  ASSERT_EQ(line.parts.size(), 1U);
  paint_body(ball, std::vector{line});
  ASSERT_EQ(ball.paint.size(), ball.points.size());
  EXPECT_NEAR(volume_mm3(ball), volume, 1e-9 * volume) << "the surface is the same";
  EXPECT_EQ(testing::examine(testing::surface_of(ball)).fault, "");
  int red = 0;
  for (std::size_t i = 0; i < ball.points.size(); ++i) {
    const Vec3 p = ball.points[i];
    if (ball.paint[i].a == 255) {
      ++red;
      EXPECT_EQ(ball.paint[i], kRed);
      EXPECT_LT(std::fabs(p.y), 1.0);
      EXPECT_GT(p.z, -1.5);
    } else if (ball.paint[i].a == 0) {
      EXPECT_TRUE(std::fabs(p.y) > 0.95 || p.z < 1.5 || std::fabs(p.x) > 19.0) << p.x << ' ' << p.z;
    }
  }
  EXPECT_GT(red, 100);
}

TEST(PaintBody, LaterLinesCoverEarlierOnes) {
  SolidBody ball = testing::ball(20.0);
  const auto parts = projected_line(ball, std::vector<Vec3>{{0, 0, 0}}, kFromFront, 0.5);
  const Rgba half_blue{0, 0, 255, 128};
  paint_body(ball, std::vector{PaintedLine{parts, 6.0, kRed}, PaintedLine{parts, 2.0, half_blue}});
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < ball.points.size(); ++i) {
    const Vec3 top{0, 0, 20};
    if (norm(ball.points[i] - top) < norm(ball.points[nearest] - top)) nearest = i;
  }
  EXPECT_EQ(ball.paint[nearest], (Rgba{127, 0, 128, 255}));
}

TEST(PaintBody, AStrokeBesideTheBodyHasNoParts) {
  const SolidBody ball = testing::ball(20.0);
  EXPECT_TRUE(
      projected_line(ball, std::vector<Vec3>{{30, 0, 0}, {40, 0, 0}}, kFromFront, 0.5).empty());
  EXPECT_TRUE(projected_line(ball, {}, kFromFront, 0.5).empty());
}

}  // namespace
}  // namespace felt::paint_body_test
