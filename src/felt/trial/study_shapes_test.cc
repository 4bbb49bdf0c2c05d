#include "felt/trial/study_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace felt::study_shapes_test {
namespace {

class Shapes : public ::testing::TestWithParam<std::size_t> {};

TEST_P(Shapes, HaveTheirSizeAroundTheOrigin) {
  for (const double size_mm : {1.0, kDefaultShapeMm, 1000.0}) {
    const std::vector<Point> path = shape_path(static_cast<StudyShapeKind>(GetParam()), size_mm);
    ASSERT_GE(path.size(), 2u);
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const Point& p : path) {
      ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
      left = std::min(left, p.x), right = std::max(right, p.x);
      top = std::min(top, p.y), bottom = std::max(bottom, p.y);
    }
    EXPECT_NEAR(std::max(right - left, bottom - top), size_mm, 1e-9 * size_mm);
    EXPECT_NEAR(left + right, 0.0, 1e-9 * size_mm);
    EXPECT_NEAR(top + bottom, 0.0, 1e-9 * size_mm);
  }
}

TEST_P(Shapes, HaveNoPointTwiceInARow) {
  const std::vector<Point> path = shape_path(static_cast<StudyShapeKind>(GetParam()), 50.0);
  for (std::size_t i = 1; i < path.size(); ++i) EXPECT_GT(distance(path[i - 1], path[i]), 0.0);
}

INSTANTIATE_TEST_SUITE_P(All, Shapes, ::testing::Range(std::size_t{0}, kStudyShapeNames.size()),
                         [](const auto& tested) {
                           return std::string(kStudyShapeNames[tested.param]);
                         });

TEST(ShapePath, IsARoundClosedCircle) {
  const std::vector<Point> path = shape_path(StudyShapeKind::kCircle, 60.0);
  EXPECT_NEAR(distance(path.front(), path.back()), 0.0, 1e-9);
  EXPECT_NEAR(path.front().y, -30.0, 1e-9);
  EXPECT_GT(path[1].x, 0.0) << "clockwise";
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point middle{0.5 * (path[i - 1].x + path[i].x), 0.5 * (path[i - 1].y + path[i].y)};
    EXPECT_NEAR(std::hypot(middle.x, middle.y), 30.0, 60e-4);
  }
}

TEST(ShapePath, HasTenCornersInAStar) {
  EXPECT_EQ(shape_path(StudyShapeKind::kStar, 50.0).size(), 11u);
}

}  // namespace
}  // namespace felt::study_shapes_test
