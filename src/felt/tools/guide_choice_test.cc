#include "felt/tools/guide_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "felt/base/constants.h"
#include "felt/document/edit_builder.h"
#include "felt/geometry/polyline.h"
#include "felt/haptics/bricks/guide.h"

namespace felt::guide_choice_test {
namespace {

using Kind = DrawingGuideKind;

DrawingGuidePtr made(DrawingGuide guide) {
  return std::make_shared<const DrawingGuide>(std::move(guide));
}

TEST(GuideChoice, PrefersANearShapeThenWhatActsEverywhereThenTheNearestShape) {
  const Document document;
  GuideBounds bounds;
  const std::vector<DrawingGuidePtr> guides{
      made({.kind = Kind::kLine, .origin = {0.0, 10.0}}),
      made({.kind = Kind::kLine, .origin = {0.0, 14.0}}),
      made({.kind = Kind::kParallels}),
      made({.kind = Kind::kSymmetry, .origin = {0.0, 100.0}}),
  };
  EXPECT_EQ(choose_guide(guides, document, {50.0, 11.0}, bounds), 0U);
  EXPECT_EQ(choose_guide(guides, document, {50.0, 13.0}, bounds), 1U);
  EXPECT_EQ(choose_guide(guides, document, {50.0, 40.0}, bounds), 2U);
  const std::vector<DrawingGuidePtr> lines(guides.begin(), guides.begin() + 2);
  EXPECT_EQ(choose_guide(lines, document, {50.0, 40.0}, bounds), 1U);
  EXPECT_EQ(choose_guide({}, document, {}, bounds), std::nullopt);
  EXPECT_EQ(choose_guide(std::span(guides).last(1), document, {0.0, 100.0}, bounds), std::nullopt);
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
  EXPECT_EQ(nearest_ray(guide, {40.0, -1.0}).number, 0);
  EXPECT_LT(nearest_ray(guide, {4.0, 0.0}).radius_mm, 0.5) << "the rays are close to each other";
  EXPECT_EQ(nearest_ray(guide, guide.origin).radius_mm, 0.0);
}

TEST(GuideChoice, EachRayHasOneNumber) {
  const DrawingGuide guide{.kind = Kind::kProtractor, .size_mm = 60.0};
  EXPECT_EQ(nearest_ray(guide, {-40.0, -0.01}).number, 12) << "180 degrees";
  EXPECT_EQ(nearest_ray(guide, {-40.0, 0.01}).number, 12);
  for (const double step_deg : {15.0, 100.0, 7.0, 50.0, 180.0, 0.7}) {
    const DrawingGuide odd{.kind = Kind::kProtractor,
                           .angle_rad = 0.4,
                           .size_mm = 60.0,
                           .step_rad = step_deg / kDegPerRad};
    std::set<int> numbers;
    const double whole = std::floor(360.0 / step_deg + 1e-9);
    EXPECT_EQ(ray_count(odd), static_cast<int>(whole)) << step_deg;
    for (int i = 0; i < 3600; ++i) {
      const double turn = kTau * (i + 0.3) / 3600.0;
      const GuideRay ray = nearest_ray(odd, Point{} + 30.0 * direction_of(turn));
      double nearest = kInf;  // of the rays that are drawn
      for (int k = 0; k < ray_count(odd); ++k) {
        nearest = std::min(nearest,
                           std::fabs(std::remainder(0.4 + k * step_deg / kDegPerRad - turn, kTau)));
      }
      const double found = 0.4 + ray.number * step_deg / kDegPerRad - turn;
      ASSERT_NEAR(std::fabs(std::remainder(found, kTau)), nearest, 1e-9) << step_deg << ' ' << i;
      numbers.insert(ray.number);
    }
    EXPECT_EQ(numbers.size(), static_cast<std::size_t>(ray_count(odd)));
    EXPECT_EQ(*numbers.rbegin(), ray_count(odd) - 1);
  }
}

/// Returns a long wave from (x, y) on, 4 mm for each turn.
StrokeData wave(Point from, int turns) {
  StrokeData data{.points = {from}, .joints = {}, .widths = {}};
  for (int i = 0; i < turns; ++i) {
    const Point at = data.points.back();
    const double side = i % 2 == 0 ? 2.0 : -2.0;
    for (const Vec step : {Vec{1.0, side}, Vec{3.0, side}, Vec{4.0, 0.0}}) {
      data.points.push_back(at + step);
    }
  }
  data.joints.assign(static_cast<std::size_t>(turns) - 1, JointKind::kCorner);
  data.widths = {{0.0, 1.0}, {double(turns), 1.0}};
  return data;
}

/// A document with traces of long waves and with paths of teachers, as many as it can have.
struct ManyPaths {
  explicit ManyPaths(int turns) {
    EditBuilder edit(document);
    for (std::size_t i = 0; i < kMaxDrawingGuides; ++i) {
      StrokeData data = wave({0.0, 12.0 * static_cast<double>(i)}, turns);
      if (i % 2 == 0) {
        const StrokeId id = edit.add(document.layers().front().id,
                                     std::make_shared<const Stroke>(*Stroke::create(data)));
        guides.push_back(made({.kind = Kind::kTrace, .stroke = id}));
      } else {
        DrawingGuide teacher{.kind = Kind::kTeacher, .points = data.points};
        for (std::size_t k = 0; k < data.points.size(); ++k)
          teacher.times_ms.push_back(10.0 * double(k));
        guides.push_back(made(std::move(teacher)));
      }
    }
    EXPECT_TRUE(document.apply(std::move(edit).build("Draw")));
  }
  Document document;
  std::vector<DrawingGuidePtr> guides;
};

TEST(GuideChoice, ChoosesTheNearestOfManyPaths) {
  const ManyPaths many(20);
  GuideBounds bounds;
  for (int i = 0; i < 300; ++i) {
    const Point touch{0.37 * i - 5.0, 10.7 * i - 40.0};
    std::size_t best = 0;
    double nearest = kInf;
    for (std::size_t k = 0; k < many.guides.size(); ++k) {
      const std::vector<Point> path = guide_path(*many.guides[k], many.document);
      const double away = nearest_on_polyline(path, touch).distance_squared;
      if (away < nearest) best = k;
      nearest = std::min(nearest, away);
    }
    ASSERT_EQ(choose_guide(many.guides, many.document, touch, bounds), best) << i;
  }
}

TEST(GuideChoice, ATouchSearchesOnlyPathsNearThePen) {
  const ManyPaths many(20);
  GuideBounds bounds;
  for (int i = 0; i < 100; ++i) {
    const Point touch{100.0 * i, 30.0 * i};
    EXPECT_TRUE(choose_guide(many.guides, many.document, touch, bounds));
  }
  EXPECT_LT(bounds.searches(), 400U) << "of 256 paths at each of 100 touches";
}

TEST(GuideChoice, APathOfAMissingStrokeIsEmpty) {
  EXPECT_TRUE(guide_path({.kind = Kind::kTrace, .stroke = {7}}, Document()).empty());
  EXPECT_TRUE(guide_path({.kind = Kind::kTeacher, .points = {{kNan, 0.0}}}, Document()).empty());
}

}  // namespace
}  // namespace felt::guide_choice_test
