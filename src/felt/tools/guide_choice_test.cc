#include "felt/tools/guide_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/guide.h"

namespace felt::guide_choice_test {
namespace {

using Kind = DrawingGuideKind;

DrawingGuidePtr made(DrawingGuide guide) {
  return std::make_shared<const DrawingGuide>(std::move(guide));
}

TEST(GuideChoice, PrefersANearShapeThenWhatActsEverywhereThenTheNearestShape) {
  const Document document;
  const std::vector<DrawingGuidePtr> guides{
      made({.kind = Kind::kLine, .origin = {0.0, 10.0}}),
      made({.kind = Kind::kLine, .origin = {0.0, 14.0}}),
      made({.kind = Kind::kParallels}),
      made({.kind = Kind::kSymmetry, .origin = {0.0, 100.0}}),
  };
  EXPECT_EQ(choose_guide(guides, document, {50.0, 11.0}), 0U);
  EXPECT_EQ(choose_guide(guides, document, {50.0, 13.0}), 1U);
  EXPECT_EQ(choose_guide(guides, document, {50.0, 40.0}), 2U);
  const std::vector<DrawingGuidePtr> lines(guides.begin(), guides.begin() + 2);
  EXPECT_EQ(choose_guide(lines, document, {50.0, 40.0}), 1U);
  EXPECT_EQ(choose_guide({}, document, {}), std::nullopt);
  EXPECT_EQ(choose_guide(std::span(guides).last(1), document, {0.0, 100.0}), std::nullopt);
}

TEST(GuideChoice, TakesTheNearestLegOfASetSquare) {
  const DrawingGuide square{.kind = Kind::kSetSquare, .size_mm = 80.0, .second_mm = 50.0};
  EXPECT_EQ(std::get<GuideStraight>(*guide_shape(square, {40.0, 2.0})).along, (Vec{1.0, 0.0}));
  const auto second = std::get<GuideStraight>(*guide_shape(square, {2.0, 40.0}));
  EXPECT_NEAR(second.along.y, 1.0, 1e-12);
  EXPECT_EQ(second.to_mm, 50.0);
}

TEST(GuideChoice, ShapesThroughTheTouch) {
  const Point touch{33.0, 21.0};
  for (const DrawingGuide& guide :
       {DrawingGuide{.kind = Kind::kParallels, .angle_rad = 0.4},
        DrawingGuide{.kind = Kind::kCompass, .origin = {3.0, -8.0}},
        DrawingGuide{.kind = Kind::kEllipses, .origin = {3.0, -8.0}, .angle_rad = 0.7}}) {
    const auto shape = guide_shape(guide, touch);
    ASSERT_TRUE(shape);
    EXPECT_NEAR(nearest_on(*shape, touch).distance_mm, 0.0, 1e-9);
  }
  EXPECT_FALSE(guide_shape({.kind = Kind::kCompass, .origin = {33.0, 21.5}}, touch)) << "too small";
  EXPECT_FALSE(guide_shape({.kind = Kind::kLine, .angle_rad = kNan}, touch));
  const auto ellipses =
      guide_shape({.kind = Kind::kEllipses, .size_mm = 30, .second_mm = 10}, touch);
  const auto& ellipse = std::get<GuideEllipse>(*ellipses);
  EXPECT_NEAR(ellipse.a_mm / ellipse.b_mm, 3.0, 1e-12);
}

TEST(GuideChoice, PerspectiveChoosesByTheDirectionOfTheMovement) {
  DrawingGuide guide{.kind = Kind::kPerspective, .points = {{500.0, 50.0}}};
  const Point touch{50.0, 50.0};
  const auto along = [&](Vec movement) {
    const auto lines = perspective_lines(guide, touch);
    return line_along(lines, movement)->along;
  };
  EXPECT_EQ(perspective_lines(guide, touch).size(), 3U);
  EXPECT_EQ(along({-3.0, 0.5}), (Vec{1.0, 0.0}));
  EXPECT_EQ(along({0.5, 3.0}), (Vec{0.0, 1.0}));
  guide.points = {{500.0, 300.0}, {-500.0, 300.0}};
  EXPECT_EQ(perspective_lines(guide, touch).size(), 3U) << "two points and the vertical";
  EXPECT_NEAR(along({3.0, 1.4}).x, normalized(guide.points[0] - touch).x, 1e-12);
  EXPECT_NEAR(along({3.0, -1.4}).x, normalized(guide.points[1] - touch).x, 1e-12);
  EXPECT_EQ(along({0.2, 3.0}), (Vec{0.0, 1.0}));
  guide.points.push_back({50.0, 2000.0});
  EXPECT_EQ(perspective_lines(guide, touch).size(), 3U);
  guide.points = {touch};
  EXPECT_EQ(perspective_lines(guide, touch).size(), 2U) << "on the vanishing point";
  EXPECT_EQ(line_along({}, {1.0, 0.0}), std::nullopt);
}

TEST(GuideChoice, NodesAreTheNearestOnes) {
  for (const Kind kind : {Kind::kGrid, Kind::kIsometricGrid}) {
    const DrawingGuide grid{.kind = kind, .origin = {1.0, 2.0}, .angle_rad = 0.3, .size_mm = 7.0};
    const double corner = kind == Kind::kGrid ? kTau / 4.0 : kTau / 6.0;
    const Vec u{std::cos(0.3), std::sin(0.3)}, v{std::cos(0.3 + corner), std::sin(0.3 + corner)};
    for (int k = 0; k < 400; ++k) {
      const Point pen{0.37 * (k % 20) - 3.0, 0.41 * (k / 20) - 3.0};
      double nearest = kInf;
      for (int i = -9; i <= 9; ++i) {
        for (int j = -9; j <= 9; ++j) {
          nearest = std::min(nearest, distance(pen, grid.origin + 7.0 * i * u + 7.0 * j * v));
        }
      }
      const GuideNode node = nearest_node(grid, pen);
      ASSERT_NEAR(distance(pen, node.at), nearest, 1e-9);
      ASSERT_EQ(node.radius_mm, GuideLaw::kTickMm);
    }
  }
  EXPECT_NEAR(nearest_node({.kind = Kind::kGrid, .size_mm = 2.0}, {}).radius_mm, 0.9, 1e-12)
      << "neighbours do not overlap";
}

TEST(GuideChoice, RaysAreAtMultiplesOfTheStep) {
  const DrawingGuide guide{.kind = Kind::kProtractor, .size_mm = 60.0};
  EXPECT_EQ(nearest_ray(guide, {40.0, 1.0}).number, 0);
  const GuideRay ray = nearest_ray(guide, {40.0 * std::cos(0.5), 40.0 * std::sin(0.5)});
  EXPECT_EQ(ray.number, 2);
  EXPECT_NEAR(ray.line.along.y, 0.5, 1e-12) << "30 degrees";
  EXPECT_EQ(ray.radius_mm, 2.0);
  EXPECT_EQ(nearest_ray(guide, {-40.0, -1.0}).number, -12);
  EXPECT_LT(nearest_ray(guide, {4.0, 0.0}).radius_mm, 0.5) << "the rays are close to each other";
  EXPECT_EQ(nearest_ray(guide, guide.origin).radius_mm, 0.0);
}

TEST(GuideChoice, APathOfAMissingStrokeIsEmpty) {
  EXPECT_TRUE(guide_path({.kind = Kind::kTrace, .stroke = {7}}, Document()).empty());
  EXPECT_TRUE(guide_path({.kind = Kind::kTeacher, .points = {{kNan, 0.0}}}, Document()).empty());
}

}  // namespace
}  // namespace felt::guide_choice_test
