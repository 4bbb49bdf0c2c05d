#include "felt/tools/exact_ink.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/base/constants.h"

namespace felt::exact_ink_test {
namespace {

/// Returns a stroke along a part of an ellipse, 0.3 mm off, with widths that grow along it.
Stroke drawn_along(const GuideEllipse& ellipse, double from, double to) {
  constexpr int kSegments = 16;
  const GuideEllipse off{ellipse.centre, ellipse.angle_rad, ellipse.a_mm + 0.3, ellipse.b_mm + 0.3};
  StrokeData data;
  data.points = {point_at(off, from)};
  for (int i = 0; i < kSegments; ++i) {
    const Point next = point_at(off, std::lerp(from, to, (i + 1.0) / kSegments));
    const Cubic line = straight(data.points.back(), next);
    data.points.insert(data.points.end(), line.p.begin() + 1, line.p.end());
  }
  data.joints.assign(kSegments - 1, JointKind::kCorner);
  for (int i = 0; i <= kSegments; ++i) data.widths.push_back({1.0 * i, 1.0 + 0.1 * i});
  data.medium = "chalk";
  data.color = {1, 2, 3, 4};
  return *Stroke::create(std::move(data));
}

RC_GTEST_PROP(ExactInk, AnArcIsOnTheEllipseWithTheWidthsOfTheStroke, ()) {
  const auto number = [](int low, int high) { return 0.1 * *rc::gen::inRange(low, high); };
  const GuideEllipse ellipse{
      {number(-500, 500), number(-500, 500)}, number(-31, 31), number(40, 900), number(40, 900)};
  const double from = number(-31, 31);
  const double to = from + (*rc::gen::arbitrary<bool>() ? 1.0 : -1.0) * number(10, 70);
  const Stroke drawn = drawn_along(ellipse, from, to);
  const auto exact = exact_stroke(drawn, {ellipse, from, to});
  RC_ASSERT(exact.has_value());
  const double largest = std::max(ellipse.a_mm, ellipse.b_mm);
  double last_width = 0.0;
  for (int i = 0; i <= 200; ++i) {
    const double u = exact->segment_count() * i / 200.0;
    RC_ASSERT(std::fabs(nearest_on(ellipse, exact->position(u)).distance_mm) < 1e-6 * largest);
    RC_ASSERT(exact->width_mm(u) >= last_width - 1e-9);
    last_width = exact->width_mm(u);
  }
  RC_ASSERT(distance(exact->position(0.0), drawn.position(0.0)) < 0.45);
  const double end = exact->segment_count(), drawn_end = drawn.segment_count();
  RC_ASSERT(distance(exact->position(end), drawn.position(drawn_end)) < 0.45);
  RC_ASSERT(exact->width_mm(0.0) == drawn.width_mm(0.0));
  RC_ASSERT(exact->width_mm(end) == drawn.width_mm(drawn_end));
  RC_ASSERT(exact->medium() == "chalk" && exact->color() == drawn.color());
}

TEST(ExactInk, ALineIsOneStraightSegment) {
  const StrokeData data{.points = {{0.0, 10.3}, {30.0, 10.0}, {60.0, 10.4}, {90.0, 9.8}},
                        .joints = {},
                        .widths = {{0.0, 1.0}, {0.5, 3.0}, {1.0, 2.0}}};
  const Stroke drawn = *Stroke::create(data);
  const auto exact = exact_stroke(drawn, {GuideStraight{{0.0, 10.0}, {1.0, 0.0}}, 0.0, 90.0});
  ASSERT_TRUE(exact);
  EXPECT_EQ(exact->segment_count(), 1);
  EXPECT_EQ(exact->position(0.0), (Point{0.0, 10.0}));
  EXPECT_EQ(exact->position(1.0), (Point{90.0, 10.0}));
  EXPECT_NEAR(exact->width_mm(0.5), 3.0, 0.05);
}

TEST(ExactInk, AClosedStrokeBecomesTheWholeCircle) {
  const GuideEllipse circle{{5.0, 5.0}, 0.0, 20.0, 20.0};
  StrokeData data = drawn_along(circle, 0.0, kTau).data();
  data.points.back() = data.points.front();
  data.joints.push_back(JointKind::kCorner);
  data.closed = true;
  const auto exact = exact_stroke(*Stroke::create(std::move(data)), {circle, 0.0, kTau});
  ASSERT_TRUE(exact);
  EXPECT_TRUE(exact->closed());
  EXPECT_EQ(exact->segment_count(), 12);
}

TEST(ExactInk, TooShortIsNotOffered) {
  const StrokeData data{.points = {{0.0, 0.0}, {0.2, 0.0}, {0.4, 0.0}, {0.6, 0.0}},
                        .joints = {},
                        .widths = {{0.0, 1.0}, {1.0, 2.0}}};
  EXPECT_FALSE(
      exact_stroke(*Stroke::create(data), {GuideStraight{{0.0, 0.0}, {1.0, 0.0}}, 0.0, 0.6}));
}

}  // namespace
}  // namespace felt::exact_ink_test
