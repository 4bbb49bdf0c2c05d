// The speed of the pen affects the number of samples of a line, but not the number of its segments.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/testing/fit_oracle.h"
#include "felt/stroke/testing/test_ink.h"

namespace felt::speed_test {
namespace {

using testing::TestInk;

constexpr double kDefaultToleranceMm = CurveFitOptions{}.tolerance_mm;
constexpr double kRateHz = 1000.0;
constexpr double kFastMmPerS = 250.0;

enum class Line { kStraight, kSpiral, kWave, kWriting };
enum class Sensor { kExact, kGrid, kNoisy };

// Returns the point of a line at its parameter a.
Point point_of(Line line, double a) {
  switch (line) {
    case Line::kStraight:
      return {10.0 + 0.8 * a, 20.0 + 0.6 * a};
    case Line::kSpiral:
      return Point{60.0, 60.0} + (4.0 + 1.3 * a) * Vec{std::cos(a), std::sin(a)};
    case Line::kWave:
      return {10.0 + a, 60.0 + 12.0 * std::sin(a / 14.0) + 3.0 * std::sin(a / 5.3)};
    case Line::kWriting:
      return {10.0 + 1.1 * a + 1.6 * std::sin(2.0 * a + 0.5),
              40.0 + 2.8 * std::cos(2.0 * a) + 1.3 * std::cos(0.9 * a + 1.0)};
  }
  return {};
}

// Returns the position that a sensor with 0.03 mm resolution reports.
Point seen(Sensor sensor, Point p, TestInk& random) {
  constexpr double kStep = CurveFitter::kResolutionMm;
  switch (sensor) {
    case Sensor::kExact:
      return p;
    case Sensor::kGrid:
      return {kStep * std::round(p.x / kStep), kStep * std::round(p.y / kStep)};
    case Sensor::kNoisy:
      return p + Vec{random.uniform(-kStep, kStep), random.uniform(-kStep, kStep)};
  }
  return p;
}

// Returns the samples of a pen that draws `length_mm` of the line at constant speed.
std::vector<Point> drawn(Line line, Sensor sensor, double length_mm, double mm_per_s,
                         std::uint64_t seed) {
  constexpr double kStep = 1e-3;
  TestInk random(seed);
  std::vector<Point> ink;
  double a = 0.0, path = 0.0;
  for (double wanted = 0.0; wanted <= length_mm; wanted += mm_per_s / kRateHz) {
    while (path < wanted) {
      path += distance(point_of(line, a), point_of(line, a + kStep));
      a += kStep;
    }
    ink.push_back(seen(sensor, point_of(line, a), random));
  }
  return ink;
}

struct Counts {
  int online = 0;
  int refined = 0;
};

// Fits the ink, and expects every sample to be within the tolerance.
Counts fitted(const std::vector<Point>& ink) {
  InkFitter fitter({});
  for (const Point p : ink) fitter.push({.position = p, .pressure = 0.5, .time_ns = 0});
  fitter.end();
  Counts counts{fitter.segment_count(), 0};
  for (int step = 0; step < 2; ++step) {
    EXPECT_TRUE(testing::has_all_places(fitter.curve(), ink.size()));
    EXPECT_LE(testing::worst_error(fitter.curve(), ink), kDefaultToleranceMm);
    EXPECT_LE(testing::worst_smooth_turn_deg(fitter.curve()), kSmoothJointMaxDeg);
    if (step == 0) fitter.refine();
  }
  counts.refined = fitter.segment_count();
  return counts;
}

struct Case {
  Line line;
  Sensor sensor;
  double length_mm;
  double slowest_mm_per_s;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  constexpr const char* kLines[] = {"straight", "spiral", "wave", "writing"};
  constexpr const char* kSensors[] = {"Exact", "Grid", "Noisy"};
  return out << kLines[static_cast<int>(c.line)] << kSensors[static_cast<int>(c.sensor)];
}

class AtAnySpeed : public ::testing::TestWithParam<Case> {};

// An earlier fit needed 61 segments for 300 mm at 10 mm/s, and 9 at 250 mm/s.
TEST_P(AtAnySpeed, R3_SlowLinesTakeAtMostHalfAsManySegmentsMore) {
  const Case& c = GetParam();
  const Counts fast = fitted(drawn(c.line, c.sensor, c.length_mm, kFastMmPerS, 1));
  for (const double speed : {5.0, 10.0, 30.0, 100.0, 500.0}) {
    if (speed < c.slowest_mm_per_s) continue;
    SCOPED_TRACE(speed);
    const Counts slow = fitted(drawn(c.line, c.sensor, c.length_mm, speed, 2));
    EXPECT_LE(slow.online, 1.5 * fast.online);
    EXPECT_LE(slow.refined, 1.5 * fast.refined);
  }
}

INSTANTIATE_TEST_SUITE_P(Lines, AtAnySpeed,
                         ::testing::Values(Case{Line::kStraight, Sensor::kExact, 300.0, 5.0},
                                           Case{Line::kStraight, Sensor::kGrid, 300.0, 5.0},
                                           Case{Line::kStraight, Sensor::kNoisy, 300.0, 5.0},
                                           Case{Line::kSpiral, Sensor::kExact, 300.0, 5.0},
                                           Case{Line::kSpiral, Sensor::kGrid, 300.0, 5.0},
                                           Case{Line::kSpiral, Sensor::kNoisy, 300.0, 10.0},
                                           Case{Line::kWave, Sensor::kExact, 200.0, 5.0},
                                           Case{Line::kWave, Sensor::kGrid, 200.0, 5.0},
                                           Case{Line::kWave, Sensor::kNoisy, 200.0, 10.0},
                                           Case{Line::kWriting, Sensor::kExact, 120.0, 5.0},
                                           Case{Line::kWriting, Sensor::kGrid, 120.0, 5.0},
                                           Case{Line::kWriting, Sensor::kNoisy, 120.0, 10.0}),
                         ::testing::PrintToStringParamName());

// Tests which samples of much denser ink the fit keeps. CurveFitter::places() shows the kept
// samples.
TEST(CurveFitter, R3_ADataPointIsKeptOnlyAfterTheThreshold) {
  for (const double tolerance : {0.05, 0.15, 0.5, 3.0}) {
    SCOPED_TRACE(tolerance);
    const std::vector<Point> ink = drawn(Line::kSpiral, Sensor::kExact, 20.0, 1.0, 1);
    CurveFitter fitter({.tolerance_mm = tolerance});
    fitter.begin();
    for (const Point p : ink) fitter.push(p);
    fitter.end();
    // A kept sample represents neighbours on both sides.
    const double threshold = CurveFitter::spacing_mm(tolerance);
    std::size_t next = 0, kept = 0;
    for (const SamplePlace& place : fitter.places()) {
      EXPECT_LE(distance(ink[next], ink[next + place.count - 1]), 2.0 * threshold);
      next += place.count;
      ++kept;
    }
    double path = 0.0;
    for (std::size_t i = 1; i < ink.size(); ++i) path += distance(ink[i - 1], ink[i]);
    EXPECT_LE(static_cast<double>(kept), 1.0 + path / threshold);
    EXPECT_GE(static_cast<double>(kept), 0.7 * path / threshold);
    EXPECT_EQ(next, ink.size());
    EXPECT_GT(kept, 10u);
  }
}

TEST(CurveFitter, R3_TheThresholdIsThatOfTheDeviceOrTheSpecification) {
  // The threshold is 0.03 mm for the PHANToM, and 0.25 mm in docs/design/errata.md#e18.
  EXPECT_EQ(CurveFitter::spacing_mm(kDefaultToleranceMm), 0.03);
  EXPECT_EQ(CurveFitter::spacing_mm(0.2), 0.03);
  EXPECT_EQ(CurveFitter::spacing_mm(2.0), 0.25);
  EXPECT_EQ(CurveFitter::spacing_mm(3.0), 0.25);
  // Between these two values the threshold grows with the tolerance. At most a fifth of the
  // tolerance is subtracted for merged samples.
  for (double tolerance = kMinSegmentMm; tolerance < 3.0; tolerance *= 1.1) {
    EXPECT_LE(CurveFitter::spacing_mm(tolerance), 0.2 * tolerance + 1e-15);
    EXPECT_LE(CurveFitter::spacing_mm(tolerance), CurveFitter::spacing_mm(1.1 * tolerance));
  }
}

// Upper bound of the work of a push: the sum of samples x rounds of exact fits, and of samples
// placed. It takes about 0.1 ms.
constexpr long kMaxWork = 10'300;

// Returns the largest work of one push.
long largest_work(const std::vector<Point>& ink, double tolerance_mm) {
  CurveFitter fitter({.tolerance_mm = tolerance_mm});
  fitter.begin();
  long largest = 0;
  for (const Point p : ink) {
    const long before = fitter.work();
    fitter.push(p);
    largest = std::max(largest, fitter.work() - before);
  }
  return largest;
}

TEST(CurveFitter, R9_WorkOfAPushIsBoundedWhateverCameBefore) {
  EXPECT_LE(CurveFitter::kMaxWorkPerPush, kMaxWork);
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    const double tolerance = random.tolerance();
    EXPECT_LE(largest_work(random.draw_any(4000), tolerance), kMaxWork);
  }
  // Tests runs of tens of thousands of samples, with and without noise.
  for (const Sensor sensor : {Sensor::kExact, Sensor::kGrid, Sensor::kNoisy}) {
    for (const Line line : {Line::kStraight, Line::kWave}) {
      EXPECT_LE(largest_work(drawn(line, sensor, 150.0, 5.0, 3), kDefaultToleranceMm), kMaxWork);
    }
  }
}

// A run that grows by a sample at a time must not be fitted again for each of them.
TEST(CurveFitter, R9_WorkOfAStrokeIsInProportionToItsSamples) {
  constexpr double kMaxPerSample = 60.0;
  for (const Sensor sensor : {Sensor::kExact, Sensor::kGrid, Sensor::kNoisy}) {
    for (const double speed : {5.0, 10.0, 50.0, 250.0}) {
      const std::vector<Point> ink = drawn(Line::kWave, sensor, 150.0, speed, 4);
      CurveFitter fitter({.tolerance_mm = kDefaultToleranceMm});
      fitter.begin();
      for (const Point p : ink) fitter.push(p);
      fitter.end();
      EXPECT_LE(static_cast<double>(fitter.work()), kMaxPerSample * static_cast<double>(ink.size()))
          << speed;
    }
  }
}

TEST(CurveFitter, R7_LongRunsDoNotDependOnWhatWasFittedBefore) {
  const std::vector<Point> slow = drawn(Line::kSpiral, Sensor::kNoisy, 60.0, 5.0, 5);
  const std::vector<Point> other = drawn(Line::kWave, Sensor::kGrid, 60.0, 5.0, 6);
  CurveFitter reused({.tolerance_mm = kDefaultToleranceMm});
  for (const auto* ink : {&other, &slow}) {
    reused.begin();
    for (const Point p : *ink) reused.push(p);
    reused.end();
  }
  EXPECT_EQ(reused.curve(), testing::fit_online(slow, kDefaultToleranceMm));
}

}  // namespace
}  // namespace felt::speed_test
