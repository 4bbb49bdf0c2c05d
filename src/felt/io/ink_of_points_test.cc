#include "felt/io/ink_of_points.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "felt/stroke/fit/width_map.h"
#include "felt/stroke/outline/outline.h"

namespace felt::ink_of_points_test {
namespace {

Stroke line_of(const std::vector<WidePoint>& points) {
  InkOfPoints ink(InkFitOptions{});
  return Stroke::create(ink.of_line(points).value()).value();
}

double distance_to_line(Point p, const std::vector<WidePoint>& line) {
  double smallest = distance(p, line.front().position);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point a = line[i - 1].position, b = line[i].position;
    const Vec ab = b - a;
    const double t =
        norm_squared(ab) > 0.0 ? std::clamp(dot(p - a, ab) / norm_squared(ab), 0.0, 1.0) : 0.0;
    smallest = std::min(smallest, distance(p, lerp(a, b, t)));
  }
  return smallest;
}

/// Returns the largest distance of the stroke's centre line from the drawn line, or of a point of
/// the drawn line from the centre line.
double largest_distance(const Stroke& stroke, const std::vector<WidePoint>& line) {
  std::vector<Dab> dabs;
  flatten(stroke, 0.001, dabs);
  double largest = 0.0;
  for (const Dab& dab : dabs) largest = std::max(largest, distance_to_line(dab.center, line));
  std::vector<WidePoint> curve;
  for (const Dab& dab : dabs) curve.push_back({dab.center, 0.0});
  for (const WidePoint& p : line) largest = std::max(largest, distance_to_line(p.position, curve));
  return largest;
}

TEST(InkOfPoints, ASquareIsFourStraightSegmentsAndClosed) {
  const Stroke s = line_of({{{0, 0}, 1}, {{50, 0}, 1}, {{50, 50}, 1}, {{0, 50}, 1}, {{0, 0}, 1}});
  EXPECT_EQ(s.segment_count(), 4);
  EXPECT_TRUE(s.closed());
  EXPECT_EQ(s.position(1.0), (Point{50, 0}));
  EXPECT_EQ(s.position(2.0), (Point{50, 50}));
  EXPECT_DOUBLE_EQ(s.width_mm(2.5), 1.0);
}

TEST(InkOfPoints, ASmallSquareKeepsItsCorners) {
  const std::vector<WidePoint> square = {
      {{0, 0}, .4}, {{5, 0}, .4}, {{5, 5}, .4}, {{0, 5}, .4}, {{0, 0}, .4}};
  const Stroke s = line_of(square);
  EXPECT_TRUE(s.closed());
  EXPECT_LE(largest_distance(s, square), 2.0 * kDrawnLineToleranceMm);
}

TEST(InkOfPoints, CurvesStayWithTheLineAndWidthsWithTheWidths) {
  for (int seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    std::uniform_real_distribution<double> turn(-0.5, 0.5), step(0.05, seed % 4 == 0 ? 40.0 : 1.5),
        grow(-0.03, 0.03);
    std::vector<WidePoint> line = {{{10, 10}, 0.8}};
    double angle = 0.0;
    for (int i = 0; i < 200; ++i) {
      angle += turn(random);
      const double length = step(random);
      line.push_back({line.back().position + length * Vec{std::cos(angle), std::sin(angle)},
                      std::max(0.06, line.back().width_mm + grow(random))});
    }
    const Stroke s = line_of(line);
    EXPECT_LE(largest_distance(s, line), 2.0 * kDrawnLineToleranceMm);
    EXPECT_NEAR(s.width_mm(0.0), line.front().width_mm, kDrawnWidthToleranceMm + 1e-9);
    EXPECT_NEAR(s.width_mm(s.segment_count()), line.back().width_mm, kDrawnWidthToleranceMm + 1e-9);
    double narrowest = 1e9, widest = 0.0;
    for (const WidePoint& p : line) {
      narrowest = std::min(narrowest, p.width_mm);
      widest = std::max(widest, p.width_mm);
    }
    for (const WidthKnot& knot : s.widths()) {
      EXPECT_GE(knot.width_mm, narrowest - kDrawnWidthToleranceMm - 1e-9);
      EXPECT_LE(knot.width_mm, widest + 1e-9);
    }
  }
}

TEST(InkOfPoints, OnePlaceIsADabOfItsWidth) {
  for (const std::vector<WidePoint>& dot :
       {std::vector<WidePoint>{{{3, 4}, 0.8}}, {{{3, 4}, 0.8}, {{3, 4}, 0.8}, {{3, 4}, 0.8}}}) {
    const Stroke s = line_of(dot);
    EXPECT_EQ(s.segment_count(), 1);
    EXPECT_FALSE(s.closed());
    EXPECT_NEAR(distance(s.position(0.0), {3, 4}), 0.0, 1e-9);
    EXPECT_LE(distance(s.position(1.0), {3, 4}), 0.06);
    EXPECT_DOUBLE_EQ(s.width_mm(0.5), 0.8);
  }
  InkOfPoints ink(InkFitOptions{});
  const std::vector<InkSample> one = {{{3, 4}, 0.5, {}}};
  const Stroke s = Stroke::create(ink.of_samples(one).value()).value();
  EXPECT_NEAR(distance(s.position(0.0), {3, 4}), 0.0, 1e-9);
  EXPECT_NEAR(s.width_mm(0.5), width_of_pressure(kPenWidths, 0.5), 1e-12);
}

TEST(InkOfPoints, SamplesBecomeWhatThePencilMakes) {
  std::vector<InkSample> samples;
  for (int i = 0; i < 300; ++i) {
    samples.push_back({{0.1 * i, 5.0 * std::sin(0.05 * i)},
                       0.5 + 0.4 * std::sin(0.02 * i),
                       std::int64_t{1'000'000} * i});
  }
  InkFitter pencil{InkFitOptions{}};
  for (const InkSample& s : samples) pencil.push(s);
  pencil.end();
  pencil.refine();
  InkOfPoints ink(InkFitOptions{});
  EXPECT_EQ(ink.of_samples(samples).value(), pencil.stroke().value().data());
  EXPECT_EQ(ink.of_samples(samples).value(), pencil.stroke().value().data()) << "used again";
}

TEST(InkOfPoints, UnusablePointsAreLeftOut) {
  InkOfPoints ink(InkFitOptions{});
  EXPECT_FALSE(ink.of_line({}));
  EXPECT_FALSE(ink.of_samples({}));
  const std::vector<WidePoint> far = {
      {{std::nan(""), 0}, 1}, {{2e9, 0}, 1}, {{0, 0}, std::nan("")}};
  EXPECT_FALSE(ink.of_line(far));
  const std::vector<WidePoint> some = {{{std::nan(""), 0}, 1}, {{1, 0}, 1}, {{2, 0}, -5}};
  const StrokeData data = ink.of_line(some).value();
  EXPECT_TRUE(check_invariants(data));
  EXPECT_NEAR(data.widths.back().width_mm, kMinWidthMm, 1e-12);
}

TEST(InkOfPoints, WorkIsBoundedWhateverTheLengths) {
  InkOfPoints ink(InkFitOptions{});
  std::vector<WidePoint> line;
  for (int i = 0; i < 200'000; ++i) line.push_back({{i % 2 == 0 ? 0.0 : 1e9, 1.0 * i}, 1.0});
  const StrokeData data = ink.of_line(line).value();
  EXPECT_EQ(data.points.size(), 3u * 199'999u + 1u);
}

}  // namespace
}  // namespace felt::ink_of_points_test
