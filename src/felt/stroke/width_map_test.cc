#include "felt/stroke/width_map.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace felt {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

InkSample at_ms(double time_ms, double pressure) {
  return {.position = {}, .pressure = pressure, .time_ns = std::llround(time_ms * 1e6)};
}

RC_GTEST_PROP(WidthMap, R14HarderIsNeverThinner, ()) {
  const WidthMapOptions options{.gamma = *rc::gen::element(0.4, 1.0, 2.2)};
  const double p = *rc::gen::inRange(-100, 1101) / 1000.0;
  const double more = p + *rc::gen::inRange(0, 300) / 1e4;
  const double w = width_of_pressure(options, p);
  RC_ASSERT(w >= options.min_mm && w <= options.max_mm);
  RC_ASSERT(width_of_pressure(options, more) >= w);
}

TEST(WidthMap, R14ClampsExactly) {
  const WidthMapOptions options{.min_mm = 0.3, .max_mm = 6.0, .gamma = 1.7};
  EXPECT_EQ(width_of_pressure(options, 0.0), 0.3);
  EXPECT_EQ(width_of_pressure(options, -1.0), 0.3);
  EXPECT_EQ(width_of_pressure(options, 1.0), 6.0);
  EXPECT_EQ(width_of_pressure(options, 7.0), 6.0);
}

TEST(WidthMap, R18AMouseDrawsAConstantWidth) {
  WidthMap map;
  for (int i = 0; i < 5; ++i) {
    EXPECT_DOUBLE_EQ(map.push({.position = {1.0 * i, 0.0}, .pressure = {}, .time_ns = {}}),
                     0.3 + 5.7 * 0.5);
  }
}

TEST(WidthMap, R18ATabletMapsLikeTheFormula) {
  WidthMap map(WidthMapOptions{.time_constant_ms = 0.0});
  for (const double p : {0.0, 0.25, 0.6, 1.0}) {
    EXPECT_DOUBLE_EQ(map.push(at_ms(0.0, p)), 0.3 + 5.7 * p);
  }
}

TEST(WidthMap, FirstSampleSetsTheFilter) {
  WidthMap map(WidthMapOptions{.min_mm = 1.0, .max_mm = 2.0});
  EXPECT_DOUBLE_EQ(map.push(at_ms(0.0, 0.25)), 1.25);
  map.begin();
  EXPECT_DOUBLE_EQ(map.push(at_ms(0.0, 0.75)), 1.75);
}

// A step reaches 1 - 1/e after one time constant, at any rate and with uneven times alike.
TEST(WidthMap, LowPassFollowsTheTimesOfTheSamples) {
  for (const double uneven : {0.0, 0.9}) {
    WidthMap map(WidthMapOptions{.min_mm = 1.0, .max_mm = 2.0});
    map.push(at_ms(0.0, 0.0));
    double width = 0.0;
    for (int i = 1; i <= 100; ++i) {
      width = map.push(at_ms(0.2 * i + (i % 2 == 1 ? 0.1 * uneven : 0.0), 1.0));
    }
    EXPECT_NEAR(width, 2.0 - std::exp(-1.0), 0.005);
  }
}

TEST(WidthMap, TimesThatStandStillOrRunBackwardsDoNotFreezeIt) {
  for (const double step_ms : {0.0, -3.0, -1e12}) {
    WidthMap map(WidthMapOptions{.min_mm = 1.0, .max_mm = 2.0});
    double width = map.push(at_ms(0.0, 0.0));
    for (int i = 1; i < 1000; ++i) {
      const double next = map.push(at_ms(step_ms * (i % 7), 1.0));
      EXPECT_GE(next, width);
      width = next;
    }
    EXPECT_NEAR(width, 2.0, 1e-3);
  }
}

TEST(WidthMap, HostileValuesStayInsideTheLimits) {
  WidthMap map(WidthMapOptions{.min_mm = -1.0, .max_mm = kNan, .gamma = -2.0});
  constexpr auto kFirst = std::numeric_limits<std::int64_t>::min();
  constexpr auto kLast = std::numeric_limits<std::int64_t>::max();
  const InkSample hostile[] = {{{}, kNan, kLast},
                               {{}, 1e300, kFirst},
                               {{}, {}, kLast},
                               {{}, -1e300, {}},
                               {{}, kNan, kFirst}};
  for (const InkSample& sample : hostile) {
    const double width = map.push(sample);
    EXPECT_GE(width, 0.05);
    EXPECT_LE(width, 6.0);
  }
}

TEST(WidthMap, ALostPressureHoldsTheLastOne) {
  WidthMap map;
  const double before = map.push(at_ms(0.0, 0.8));
  EXPECT_DOUBLE_EQ(map.push({{}, {}, 7'500'000}), before);
}

}  // namespace
}  // namespace felt
