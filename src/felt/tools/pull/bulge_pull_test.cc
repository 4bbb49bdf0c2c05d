#include "felt/tools/pull/bulge_pull.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "felt/geometry/nearest.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/stroke/testing/stroke_probe.h"
#include "felt/tools/pull/bulge_gesture.h"
#include "felt/tools/pull/pull_tool.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::bulge_pull_test {
namespace {

using testing::distance_to;
using testing::Fixture;
using testing::Pen;
using testing::random_stroke;
using testing::share;
using testing::straight_stroke;

constexpr double kToleranceMm = 0.1;

double random_gain() {
  return 0.01 * *rc::gen::inRange(-80, 121);
}

Point random_point(double from, double to) {
  const auto at = [&] { return from + (to - from) * 1e-4 * *rc::gen::inRange(0, 10'001); };
  const double x = at();
  return {x, at()};
}

/// Calls visit(Point) for points of the ink.
template <class Visit>
void for_each_point(const Stroke& stroke, Visit visit) {
  for (int i = 0; i < 50 * stroke.segment_count(); ++i) visit(stroke.position(0.02 * i));
}

RC_GTEST_PROP(RadialMap, HasItsDerivativeAndNeverFolds, ()) {
  const RadialMap map{.centre = random_point(-5.0, 5.0),
                      .radius_mm = 0.1 * *rc::gen::inRange(5, 300),
                      .gain = random_gain()};
  const Point p = map.centre + 1.2 * map.radius_mm * (random_point(-1.0, 1.0) - Point{});
  const Vec v = random_point(-1.0, 1.0) - Point{};
  const double step = 1e-6 * map.radius_mm;
  const Vec slope = (map(p + step * v) - map(p - step * v)) / (2.0 * step);
  RC_ASSERT(norm(map.derivative(p, v) - slope) <= 1e-4);
  // Along a ray, the order of points stays.
  const Vec ray = p - map.centre;
  RC_ASSERT(norm(map(p) - map.centre) <= norm(map(map.centre + 1.001 * ray) - map.centre));
  if (!map.reaches(p)) RC_ASSERT(map(p) == p);
}

RC_GTEST_PROP(BulgePull, MovesEveryPointOfTheInkAsTheMapDoes, ()) {
  const StrokePtr stroke = share(random_stroke(*rc::gen::arbitrary<std::uint64_t>()));
  RadialMap map{.centre = random_point(0.0, 20.0),
                .radius_mm = 0.1 * *rc::gen::inRange(20, 300),
                .gain = random_gain()};
  const BulgePull pull(stroke, map, kToleranceMm);
  for (const bool is_final : {false, true}) {
    const Result<Stroke> after = is_final ? pull.finished(map.gain) : pull.at(map.gain);
    RC_ASSERT(after.has_value());
    // Cusps and tiny loops take more rounds of halving than there are.
    const double allowed_mm = is_final ? 2.5 * kToleranceMm : kToleranceMm;
    for_each_point(*stroke, [&](Point p) {
      // Outside, only pieces move that cross the circle nearer to a joint than kMinSegmentMm.
      const double error_mm = distance_to(*after, map(p));
      RC_ASSERT(error_mm <= (map.reaches(p) ? allowed_mm : is_final ? 0.13 : 0.03));
    });
    // Nor is there ink where no ink was moved to.
    const Stroke moved = pull.at(map.gain).value();
    for_each_point(*after, [&](Point p) { RC_ASSERT(distance_to(moved, p) <= allowed_mm); });
    RC_ASSERT(after->color() == stroke->color());
    RC_ASSERT(after->closed() == stroke->closed());
  }
  RC_ASSERT(*pull.at(0.0) == *stroke);
}

TEST(BulgePull, LeavesInkOutsideTheCircleAsItIs) {
  const StrokePtr line = share(straight_stroke({0, 0}, {100, 0}, 1.0, 2.0));
  const BulgePull pull(line, {.centre = {50, 5}, .radius_mm = 13.0, .gain = 1.0}, kToleranceMm);
  ASSERT_TRUE(pull.moves());
  const Stroke after = pull.finished(1.0).value();
  // The circle crosses the line at 50 -+ 12.
  EXPECT_LE(distance_to(after, {38, 0}), 1e-9);
  for (const Point p : {Point{10, 0}, {37.9, 0}, {62.1, 0}, {99, 0}}) {
    EXPECT_LE(distance_to(after, p), 1e-12);
  }
  EXPECT_LE(distance_to(after, RadialMap{{50, 5}, 13.0, 1.0}({50, 0})), kToleranceMm);
  EXPECT_LE(after.segment_count(), 8);
  EXPECT_FALSE(
      BulgePull(line, {.centre = {50, 20}, .radius_mm = 13.0, .gain = 1.0}, kToleranceMm).moves());
}

TEST(BulgePull, FindsInkInASmallCircleOnALongSegment) {
  const StrokePtr line = share(straight_stroke({0, 0}, {100, 0}, 1.0, 1.0));
  for (double x = 1.0; x < 99.0; x += 0.37) {
    for (const double radius_mm : {1.0, 3.0}) {
      const RadialMap map{{x, 0.95 * radius_mm}, radius_mm, -0.8};
      const BulgePull pull(line, map, kToleranceMm);
      ASSERT_TRUE(pull.moves()) << x;
      EXPECT_LE(distance_to(*pull.at(-0.8), map({x, 0.0})), kToleranceMm) << x;
    }
  }
}

/// Ink outside is the same bit for bit, so the lift does not refit it either.
TEST(BulgePull, LeavesControlPointsOutsideTheCircleAsTheyAre) {
  int count = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const StrokePtr stroke = share(random_stroke(seed));
    const RadialMap map{{10.0, 10.0}, 7.0, seed % 2 == 0 ? 1.2 : -0.8};
    const Stroke after = BulgePull(stroke, map, kToleranceMm).finished(map.gain).value();
    for (int i = 0; i < stroke->segment_count(); ++i) {
      const Cubic c = stroke->segment(i);
      if (std::sqrt(nearest(c, map.centre).distance_squared) < map.radius_mm) continue;
      ++count;
      int same = 0;
      for (int k = 0; k < after.segment_count(); ++k) same += after.segment(k) == c ? 1 : 0;
      EXPECT_EQ(same, 1) << seed << ' ' << i;
    }
  }
  EXPECT_GT(count, 50);
}

/// A joint that turns by as much as a smooth joint may turn turns by more when it is mapped.
TEST(BulgePull, KeepsJointsSmoothThatTurnALittle) {
  const double turn = 0.9e-6 * std::numbers::pi / 180.0;
  for (const double angle : {0.3, 0.8, 1.2}) {
    const Vec along{std::cos(angle), std::sin(angle)};
    const Point joint{65, 50};
    const Stroke stroke =
        Stroke::create({.points = {joint - 20.0 * along, joint - 14.0 * along, joint - 6.0 * along,
                                   joint, joint + 6.0 * along + 6.0 * turn * perp(along),
                                   joint + 14.0 * along, joint + 20.0 * along},
                        .joints = {JointKind::kSmooth},
                        .widths = {{0.0, 1.0}, {2.0, 1.0}}})
            .value();
    const BulgePull pull(share(stroke), {.centre = {50, 50}, .radius_mm = 20.0, .gain = 1.2},
                         kToleranceMm);
    EXPECT_TRUE(pull.at(1.2)) << angle;
    EXPECT_TRUE(pull.finished(1.2)) << angle;
  }
}

TEST(BulgePull, PinchesInkThatIsAsShortAsAStrokeCanBe) {
  for (const double mm : {0.05, 0.07, 0.2}) {
    const StrokePtr dot = share(straight_stroke({50, 50}, {50 + mm, 50}, 1.0, 1.0));
    const BulgePull pull(dot, {.centre = {51, 50}, .radius_mm = 20.0, .gain = -0.8}, kToleranceMm);
    const Result<Stroke> after = pull.at(-0.8);
    ASSERT_TRUE(after) << after.error().message;
    EXPECT_LE(distance_to(*after, {50.8, 50}), 0.05);
  }
}

/// Lines that meet within the circle, at its centre, and one far away.
struct Star : Fixture {
  Star() {
    for (const Point end : {Point{60, 50}, {50, 62}, {35, 50}, {50, 10}}) {
      rays.push_back(add(straight_stroke({50, 52}, end, 1.0, 1.0)));
    }
    far = add(straight_stroke({0, 90}, {100, 90}, 1.0, 1.0));
  }
  std::vector<StrokeId> rays;
  StrokeId far;
};

PenSample pen_at(Point p) {
  PenSample pen;
  pen.position = {p.x, p.y, -1.0};
  return pen;
}

TEST(BulgeGesture, MovesAllLinesInReachAndBackHomeNothingHasHappened) {
  for (const bool pinches : {false, true}) {
    Star star;
    const BulgeOptions options{.radius_mm = 20.0, .pinches = pinches};
    const auto bulge = make_bulge(pen_at({50, 50}), star.scene(), options);
    EXPECT_EQ(bulge->feel().kind, PullFeel::Kind::kSpring);
    EXPECT_EQ(bulge->feel().origin, (Point{50, 50}));
    EXPECT_FALSE(bulge->move(pen_at({50, 50}), star.scene()));
    const auto moved = bulge->move(pen_at({58, 56}), star.scene());
    ASSERT_TRUE(moved);
    ASSERT_EQ(moved->changes.size(), star.rays.size());
    const RadialMap map{{50, 50}, 20.0, bulge_gain(10.0, options)};
    EXPECT_NEAR(map.gain, 9.5 / 19.5 * (pinches ? -0.8 : 1.2), 1e-12);
    for (const StrokeChange& change : moved->changes) {
      EXPECT_LE(distance(change.after->position(0.0), map({50, 52})), 1e-12);
    }
    Overlay overlay;
    bulge->draw(overlay);
    EXPECT_EQ(overlay.labels.at(0).text, pinches ? "61 %" : "158 %");
    // A hand that is not steady changes nothing at the touch.
    EXPECT_EQ(bulge_gain(0.4, options), 0.0);
    // At the same distance elsewhere, nothing changes.
    EXPECT_FALSE(bulge->move(pen_at({60, 50}), star.scene()));
    const auto home = bulge->move(pen_at({50, 50}), star.scene());
    ASSERT_TRUE(home);
    EXPECT_TRUE(home->changes.empty());
    EXPECT_TRUE(bulge->end(star.scene()).empty());
  }
}

TEST(BulgeGesture, KeepsTheLastShapeIfThePenIsNowhere) {
  Star star;
  const auto bulge = make_bulge(pen_at({50, 50}), star.scene(), {});
  ASSERT_TRUE(bulge->move(pen_at({58, 56}), star.scene()));
  EXPECT_FALSE(bulge->move(pen_at({std::nan(""), 5}), star.scene()));
  EXPECT_FALSE(bulge->move(pen_at({std::numeric_limits<double>::infinity(), 5}), star.scene()));
  EXPECT_EQ(bulge->end(star.scene()).changes.size(), star.rays.size());
}

TEST(BulgeGesture, WithoutALineNothingIsHeld) {
  Star star;
  const auto bulge = make_bulge(pen_at({10, 70}), star.scene(), {.radius_mm = 5.0});
  EXPECT_EQ(bulge->feel().kind, PullFeel::Kind::kNone);
  EXPECT_FALSE(bulge->move(pen_at({20, 70}), star.scene()));
  EXPECT_TRUE(bulge->end(star.scene()).empty());
}

/// A line that ends on another one, inside of its segment, still ends on it after the lift.
TEST(BulgeGesture, KeepsTheEndOfALineOnAnotherLine) {
  for (const bool pinches : {false, true}) {
    Fixture fixture;
    const StrokeId bar = fixture.add(straight_stroke({0, 0}, {80, 7}, 1.0, 1.0));
    const Point foot = fixture.document.find(bar)->position(0.43);
    const StrokeId post = fixture.add(straight_stroke({40, 70}, foot, 1.0, 1.0));
    const auto bulge = make_bulge(pen_at({38, 9}), fixture.scene(), {.pinches = pinches});
    ASSERT_TRUE(bulge->move(pen_at({60, 9}), fixture.scene()));
    const Edit edit = bulge->end(fixture.scene());
    ASSERT_EQ(edit.changes.size(), 2u);
    fixture.apply(edit);
    const StrokePtr after = fixture.document.find(post);
    const Point end = after->position(after->segment_count());
    EXPECT_GT(distance(end, foot), 1.0);
    EXPECT_LE(distance_to(*fixture.document.find(bar), end), 1e-6);
  }
}

/// A point that lines share moves in the same way with each of them.
TEST(PullTool, ABulgeIsOneStepAndKeepsConnectedLinesTogether) {
  Star star;
  const StrokeId outside = star.add(straight_stroke({50, 10}, {90, 10}, 1.0, 1.0));
  PullTool tool;
  ASSERT_TRUE(tool.set_option("mode", OptionValue{std::string("bulge")}));
  ASSERT_TRUE(tool.set_option("radius_mm", OptionValue{20.0}));
  Pen pen(tool, star);
  pen.line(testing::way({50, 15}, {60, 15}));
  EXPECT_EQ(pen.commits, 1);
  const StrokePtr ray = star.document.find(star.rays.back());
  const Point tip = ray->position(ray->segment_count());
  EXPECT_GT(distance(tip, {50, 10}), 1.0);
  EXPECT_LE(distance_to(*star.document.find(outside), tip), 1e-6);
  star.undo();
  EXPECT_EQ(star.document.find(star.rays.back())->position(1.0), (Point{50, 10}));
}

}  // namespace
}  // namespace felt::bulge_pull_test
