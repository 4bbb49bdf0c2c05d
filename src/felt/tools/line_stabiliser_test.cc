#include "felt/tools/line_stabiliser.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace felt::line_stabiliser_test {
namespace {

constexpr StabiliserOptions kInertia{.kind = StabiliserKind::kInertia};
constexpr StabiliserOptions kTowed{.kind = StabiliserKind::kTowed};

/// Returns the nib positions of a wave that is drawn at 100 mm/s and sampled at the given rate,
/// with tremor of the given size.
std::vector<Point> nibs(const StabiliserOptions& options, double rate_hz, double tremor_mm) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0.0, tremor_mm);
  Stabiliser stabiliser(options);
  stabiliser.begin({0, 0}, 0);
  std::vector<Point> result;
  for (double t = 0.0; t <= 2.0; t += 1 / rate_hz) {
    const double nx = noise(random), ny = noise(random);
    const Point pen{100 * t + nx, 15 * std::sin(4 * t) + ny};
    result.push_back(stabiliser.update(pen, static_cast<std::int64_t>(t * 1e9)));
  }
  return result;
}

double roughness(const std::vector<Point>& line) {
  double sum = 0.0;
  for (std::size_t i = 2; i < line.size(); ++i) {
    sum += norm_squared((line[i] - line[i - 1]) - (line[i - 1] - line[i - 2]));
  }
  return std::sqrt(sum / static_cast<double>(line.size()));
}

TEST(Stabiliser, OffIsThePenItself) {
  Stabiliser s;
  s.begin({1, 2}, 0);
  EXPECT_EQ(s.update({5, 6}, 1), (Point{5, 6}));
  std::vector<Stabiliser::Step> rest;
  s.finish(rest);
  EXPECT_TRUE(rest.empty());
}

TEST(Stabiliser, SteadiesATremblingHand) {
  const double raw = roughness(nibs({}, 1000, 0.1));
  EXPECT_LT(roughness(nibs(kInertia, 1000, 0.1)), 0.05 * raw);
  EXPECT_LT(roughness(nibs(kTowed, 1000, 0.1)), 0.2 * raw);
}

TEST(Stabiliser, HeavierAndLongerAreSteadier) {
  double last = 1e9;
  for (const double mass : {5.0, 50.0, 500.0}) {
    const double r = roughness(nibs({.kind = StabiliserKind::kInertia, .mass_g = mass}, 1000, .1));
    EXPECT_LT(r, last);
    last = r;
  }
  last = 1e9;
  for (const double length : {0.5, 4.0, 40.0}) {
    const double r =
        roughness(nibs({.kind = StabiliserKind::kTowed, .length_mm = length}, 1000, .1));
    EXPECT_LT(r, last);
    last = r;
  }
}

TEST(Stabiliser, DrawsNearlyTheSameLineAtEveryRate) {
  for (const auto& options : {kInertia, kTowed}) {
    const auto fast = nibs(options, 1000, 0), tablet = nibs(options, 125, 0);
    for (std::size_t i = 0; i < tablet.size(); ++i) {
      ASSERT_LE(distance(tablet[i], fast[8 * i]), 0.15) << i;
    }
  }
}

TEST(Stabiliser, TheMassDoesNotOvershoot) {
  for (const double mass : {5.0, 50.0, 500.0}) {
    Stabiliser s({.kind = StabiliserKind::kInertia, .mass_g = mass});
    s.begin({0, 0}, 0);
    double last = 0.0;
    // A pen that jumps and rests.
    for (int k = 1; k <= 5000; ++k) {
      const double x = s.update({k < 20 ? 0.1 * k : 2.0, 0}, k * 1'000'000LL).x;
      EXPECT_GE(x, last - 1e-9);
      EXPECT_LE(x, 2.0 + 0.02) << mass << " g, tick " << k;
      last = x;
    }
    EXPECT_NEAR(last, 2.0, 0.01);
  }
}

TEST(Stabiliser, ARopeIsSlackUntilItIsTaut) {
  Stabiliser s(kTowed);
  s.begin({0, 0}, 0);
  for (int k = 1; k < 40; ++k) {
    EXPECT_EQ(s.update({0.1 * k, 0}, k * 1'000'000), (Point{0, 0}));
  }
  EXPECT_GT(s.update({8, 0}, 50'000'000).x, 0.0);
}

TEST(Stabiliser, TheLineIsDrawnOnToThePen) {
  for (const auto& options : {kInertia, kTowed}) {
    Stabiliser s(options);
    s.begin({0, 0}, 0);
    for (int k = 1; k <= 300; ++k) s.update({0.2 * k, std::sin(0.02 * k)}, k * 1'000'000);
    const Point nib = s.nib(), pen{60, std::sin(6.0)};
    EXPECT_GT(distance(nib, pen), 1.0);
    std::vector<Stabiliser::Step> rest;
    s.finish(rest);
    ASSERT_FALSE(rest.empty());
    EXPECT_EQ(rest.back().nib, pen);
    Point last = nib;
    std::int64_t time = 300'000'000;
    for (const auto& step : rest) {
      EXPECT_LE(distance(step.nib, last), 1.0);
      EXPECT_GE(step.time_ns, time);
      last = step.nib;
      time = step.time_ns;
    }
  }
}

TEST(Stabiliser, StaysFiniteWhateverTheClockSays) {
  constexpr auto kMax = std::numeric_limits<std::int64_t>::max();
  constexpr auto kMin = std::numeric_limits<std::int64_t>::min();
  for (const auto& options : {kInertia, kTowed, StabiliserOptions{}}) {
    Stabiliser s(options);
    s.begin({0, 0}, 0);
    int k = 0;
    for (const std::int64_t t : {kMax, kMin, std::int64_t{0}, std::int64_t{0}, kMax, kMax}) {
      EXPECT_TRUE(is_finite(s.update({1e9 * (++k % 2), -1e9 * (k % 3)}, t)));
    }
    std::vector<Stabiliser::Step> rest;
    s.finish(rest);
    EXPECT_LE(rest.size(), 2000u);
  }
}

}  // namespace
}  // namespace felt::line_stabiliser_test
