#include "felt/recognise/shape_guess.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "felt/base/constants.h"
#include "felt/geometry/polyline.h"
#include "felt/recognise/shape_curve.h"
#include "felt/recognise/testing/drawn_shapes.h"

namespace felt::shape_guess_test {
namespace {

using testing::ellipse_part;
using testing::joined;
using testing::placed;
using testing::unsteady;

double any(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0;
}

std::optional<Stroke> stroke_of(const ShapeGuess& guess) {
  StrokeData data = shape_curve(guess);
  data.widths = {{0.0, 1.0}, {static_cast<double>(data.points.size() / 3), 1.0}};
  Result<Stroke> stroke = Stroke::create(std::move(data));
  if (!stroke) return std::nullopt;
  return *std::move(stroke);
}

/// Returns the drawing of a shape by a hand that is not steady, somewhere on the page.
std::vector<Point> drawn(const std::vector<Point>& exact, std::uint64_t seed, double angle_rad,
                         double scale) {
  return placed(unsteady(exact, 0.25, seed), angle_rad, scale, {100.0, -50.0});
}

/// Checks that a guess has the form `wanted`, is a valid stroke, and is near the path. It is not
/// always the first one: see TheFirstGuessIsAlmostAlwaysRight.
void check(const std::vector<Point>& exact, ShapeForm wanted) {
  const double scale = any(0.4, 3.0);
  const auto path =
      drawn(exact, *rc::gen::inRange<std::uint64_t>(1, 1'000'000), any(0.0, kTau), scale);
  const std::vector<ShapeGuess> guesses = guess_shapes(path);
  RC_ASSERT(guesses.size() <= kMaxGuesses);
  for (const ShapeGuess& guess : guesses) RC_ASSERT(guess.misfit <= 1.0);
  const auto found = std::find_if(guesses.begin(), guesses.end(),
                                  [wanted](const ShapeGuess& g) { return g.form == wanted; });
  RC_ASSERT(found != guesses.end());
  const auto stroke = stroke_of(*found);
  RC_ASSERT(stroke.has_value());
  for (double u = 0.0; u <= stroke->segment_count(); u += 0.05) {
    const auto near = nearest_on_polyline(path, stroke->position(u));
    RC_ASSERT(std::sqrt(near.distance_squared) < 4.5 * scale);  // the gap of a round path
  }
}

// The corners of a small rectangle that trembles can be more than four.
TEST(ShapeGuess, TheFirstGuessIsAlmostAlwaysRight) {
  std::mt19937_64 random(20261128);
  const auto any_of = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  constexpr int kDrawings = 2000;
  int right = 0;
  for (int i = 0; i < kDrawings; ++i) {
    const double w = any_of(25, 50), h = any_of(20, 40);
    const auto guesses = guess_shapes(drawn(joined({{0, 0}, {w, 0}, {w, h}, {0, h}, {0.5, 0.5}}),
                                            random(), any_of(0.0, kTau), any_of(0.4, 3.0)));
    right += !guesses.empty() && guesses[0].form == ShapeForm::kRectangle ? 1 : 0;
  }
  EXPECT_GE(right, kDrawings * 99 / 100);
}

RC_GTEST_PROP(ShapeGuess, KnowsALine, ()) {
  check(joined({{0, 0}, {any(20, 60), 0}}), ShapeForm::kLine);
}
// A quick hand goes beyond the ends and comes back.
RC_GTEST_PROP(ShapeGuess, KnowsALineThatGoesBeyondItsEnds, ()) {
  const double size = any(20, 60);
  const double end = any(0.0, 0.12) * size, begin = 0.12 * size - end;
  check(joined({{begin, 0}, {0, 0}, {size + end, 0}, {size, 0}}), ShapeForm::kLine);
}
// A mouse reports whole pixels: 0.26 mm, and twice that at half the usual zoom.
RC_GTEST_PROP(ShapeGuess, KnowsALineOfWholePixelsAtAnyAngle, ()) {
  const double pixel = *rc::gen::element(0.26, 0.52), step = any(10, 40) / 125.0;
  const double length = any(20, 120), angle = any(0.0, kTau);
  const Point start{any(0, 1), any(0, 1)};
  std::vector<Point> path;
  for (double s = 0.0; s <= length; s += step) {
    const Point p = start + s * Vec{std::cos(angle), std::sin(angle)};
    path.push_back({pixel * std::round(p.x / pixel), pixel * std::round(p.y / pixel)});
  }
  const auto guesses = guess_shapes(path);
  RC_ASSERT(!guesses.empty() && guesses[0].form == ShapeForm::kLine);
}
RC_GTEST_PROP(ShapeGuess, APathThatRunsToAndFroIsNoLine, ()) {
  const double size = any(20, 60), back = any(0.35, 1.0) * size;
  for (const ShapeGuess& guess :
       guess_shapes(joined({{0, 0}, {size, 0}, {size - back, 0.01 * size}, {size, 0}}))) {
    RC_ASSERT(guess.form != ShapeForm::kLine);
  }
}
/// Checks that no line is offered for a path of 60 mm, somewhere on the page in any size.
void check_no_line(const std::vector<Point>& exact) {
  const double scale = any(0.4, 3.0);
  for (const ShapeGuess& guess : guess_shapes(placed(exact, any(0.0, kTau), scale, {30, 40}))) {
    RC_ASSERT(guess.form != ShapeForm::kLine);
  }
}

RC_GTEST_PROP(ShapeGuess, APathWithManyShortReturnsIsNoLine, ()) {
  const double back = any(5, 14), forth = back + any(2, 6);
  std::vector<Point> ends{{0, 0}};
  while (ends.back().x < 60.0 - forth) {
    ends.push_back(ends.back() + Vec{forth, 0});
    ends.push_back(ends.back() - Vec{back, 0});
  }
  ends.push_back({60, 0});
  check_no_line(ends);
}

/// Returns x along 60 mm, plus `along` and `across` times sine and cosine of `periods` turns.
std::vector<Point> wavy(double periods, double along, double across) {
  constexpr int kSteps = 3000;
  std::vector<Point> path;
  for (int i = 0; i <= kSteps; ++i) {
    const double u = static_cast<double>(i) / kSteps, t = kTau * periods * u;
    path.push_back({60.0 * u + along * std::cos(t), across * std::sin(t)});
  }
  return path;
}

// Grass or water drawn with a pen that stays at the end.
RC_GTEST_PROP(ShapeGuess, AWaveOfManyPeriodsIsNoLine, ()) {
  check_no_line(wavy(any(7, 80), 0.0, 1.0));
  check_no_line(wavy(any(5, 20), 0.0, 1.5));
  check_no_line(wavy(any(5, 12), 0.0, 2.0));
}
RC_GTEST_PROP(ShapeGuess, AZigzagIsNoLine, ()) {
  const int count = *rc::gen::inRange(12, 40);
  const double half = any(1.5, 2.0);
  std::vector<Point> ends;
  for (int i = 0; i <= count; ++i) ends.push_back({60.0 * i / count, i % 2 == 0 ? -half : half});
  check_no_line(joined(ends));
}
RC_GTEST_PROP(ShapeGuess, ACoilIsNoLine, ()) {
  const double radius = any(1.0, 2.0);
  check_no_line(wavy(any(6, 20), radius, *rc::gen::element(-1.0, 1.0) * radius));
}
RC_GTEST_PROP(ShapeGuess, KnowsAnArc, ()) {
  check(ellipse_part({0, 0}, 25, 25, 0.0, any(0.8, 4.5)), ShapeForm::kArc);
}
RC_GTEST_PROP(ShapeGuess, KnowsACircle, ()) {
  check(ellipse_part({0, 0}, 20, 20, 0.0, any(0.95, 1.05) * kTau), ShapeForm::kCircle);
}
RC_GTEST_PROP(ShapeGuess, KnowsAnEllipse, ()) {
  check(ellipse_part({0, 0}, 30, any(10, 20), 0.0, -any(0.95, 1.05) * kTau), ShapeForm::kEllipse);
}
RC_GTEST_PROP(ShapeGuess, KnowsATriangle, ()) {
  check(joined({{0, 0}, {40, any(-10, 10)}, {any(5, 35), 35}, {0.5, 0.5}}), ShapeForm::kTriangle);
}
RC_GTEST_PROP(ShapeGuess, KnowsARectangle, ()) {
  const double w = any(25, 50), h = any(20, 40);
  check(joined({{0, 0}, {w, 0}, {w, h}, {0, h}, {0.5, 0.5}}), ShapeForm::kRectangle);
}
RC_GTEST_PROP(ShapeGuess, KnowsAPolygon, ()) {
  const int count = *rc::gen::inRange(5, 7);
  std::vector<Point> corners;
  for (int i = 0; i <= count; ++i) {
    const double a = kTau * i / count;
    corners.push_back({30.0 * std::cos(a), 30.0 * std::sin(a)});
  }
  check(joined(corners), ShapeForm::kPolygon);
}

TEST(ShapeGuess, OffersBothOfTwoShapesThatAreNearlyEqual) {
  const auto guesses = guess_shapes(ellipse_part({0, 0}, 20, 16.5, 0.0, kTau));
  ASSERT_EQ(guesses.size(), 2U);
  EXPECT_NE(guesses[0].form, guesses[1].form);
  for (const ShapeGuess& g : guesses) {
    EXPECT_TRUE(g.form == ShapeForm::kCircle || g.form == ShapeForm::kEllipse);
  }
  const auto round = guess_shapes(ellipse_part({0, 0}, 20, 19.8, 0.0, kTau));
  ASSERT_EQ(round.size(), 1U);
  EXPECT_EQ(round[0].form, ShapeForm::kCircle);
}

// The corners of a small triangle that trembles can be more than three, which fit much better.
TEST(ShapeGuess, OffersATriangleBesidesAPolygonThatFitsBetter) {
  constexpr int kDrawings = 1000;
  int triangles = 0, polygons = 0;
  double apart = 0.0;
  for (std::uint64_t seed = 1; seed <= kDrawings; ++seed) {
    const auto guesses =
        guess_shapes(unsteady(joined({{0, 0}, {20, 0}, {10, 17}, {0.5, 0.5}}), 0.6, seed));
    for (const ShapeGuess& g : guesses) {
      if (g.form != ShapeForm::kTriangle) continue;
      ++triangles;
      apart = std::max(apart, g.misfit - guesses[0].misfit);
    }
    polygons += !guesses.empty() && guesses[0].form == ShapeForm::kPolygon ? 1 : 0;
  }
  EXPECT_GE(triangles, kDrawings * 99 / 100);
  EXPECT_GT(polygons, 0);
  EXPECT_GT(apart, 0.4) << "far from equal";
}

TEST(ShapeGuess, ScribblesAndDotsResembleNothing) {
  EXPECT_TRUE(guess_shapes(testing::zigzag(7, 20, 6)).empty());
  EXPECT_TRUE(guess_shapes(ellipse_part({0, 0}, 20, 20, 0.0, 2.0 * kTau)).empty());
  EXPECT_TRUE(guess_shapes(joined({{0, 0}, {20, 20}, {0, 40}, {20, 60}})).empty());
  EXPECT_TRUE(guess_shapes(ellipse_part({0, 0}, 1, 1, 0.0, kTau)).empty()) << "too small";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::vector<Point>& path : {std::vector<Point>{},
                                         {{1, 1}},
                                         {{1, 1}, {1, 1}},
                                         {{nan, 1}, {2, nan}},
                                         {{1e300, 0}, {-1e300, 0}}}) {
    EXPECT_TRUE(guess_shapes(path).empty());
  }
}

// Whatever is guessed can be drawn, or is refused by Stroke::create; nothing crashes.
RC_GTEST_PROP(ShapeGuess, AnyPathGivesUsableShapesOrNone, ()) {
  std::vector<Point> path;
  const double size = std::pow(10.0, any(-3, 8));
  for (int i = *rc::gen::inRange(0, 60); i > 0; --i) path.push_back({any(0, size), any(0, size)});
  double last = 0.0;
  for (const ShapeGuess& guess : guess_shapes(path)) {
    RC_ASSERT(guess.misfit >= last && guess.misfit <= 1.0);
    last = guess.misfit;
    if (const auto stroke = stroke_of(guess)) RC_ASSERT(!stroke->bounds().empty());
  }
}

TEST(ShapeCurve, ACircleIsRoundAndStartsWhereThePenDid) {
  const auto path = ellipse_part({50, 40}, 20, 20, 1.0, -kTau);
  const auto guesses = guess_shapes(path);
  ASSERT_FALSE(guesses.empty());
  const auto stroke = stroke_of(guesses[0]);
  ASSERT_TRUE(stroke);
  EXPECT_TRUE(stroke->closed());
  EXPECT_LT(distance(stroke->position(0.0), path.front()), 0.1);
  EXPECT_LT(distance(stroke->position(0.1), path[2]), 3.0) << "the direction of the pen";
  for (double u = 0.0; u < 4.0; u += 0.01) {
    EXPECT_NEAR(distance(stroke->position(u), {50, 40}), 20.0, 0.05);
  }
}

}  // namespace
}  // namespace felt::shape_guess_test
