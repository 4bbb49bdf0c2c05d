#include "felt/stroke/fit/width_map.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "felt/base/constants.h"
#include "felt/stroke/stroke.h"

namespace felt::width_map_test {
namespace {

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
    EXPECT_DOUBLE_EQ(map.push({.position = {1.0 * i, 0.0}, .pressure = {}, .time_ns = {}}).width_mm,
                     0.3 + 5.7 * 0.5);
  }
}

TEST(WidthMap, R18ATabletMapsLikeTheFormula) {
  WidthMap map(WidthMapOptions{.time_constant_ms = 0.0});
  for (const double p : {0.0, 0.25, 0.6, 1.0}) {
    EXPECT_DOUBLE_EQ(map.push(at_ms(0.0, p)).width_mm, 0.3 + 5.7 * p);
  }
}

TEST(WidthMap, FirstSampleSetsTheFilter) {
  WidthMap map(WidthMapOptions{.min_mm = 1.0, .max_mm = 2.0});
  EXPECT_DOUBLE_EQ(map.push(at_ms(0.0, 0.25)).width_mm, 1.25);
  map.begin();
  EXPECT_DOUBLE_EQ(map.push(at_ms(0.0, 0.75)).width_mm, 1.75);
}

// A step reaches 1 - 1/e after one time constant, at any rate, even if the times are uneven.
TEST(WidthMap, LowPassFollowsTheTimesOfTheSamples) {
  for (const double uneven : {0.0, 0.9}) {
    WidthMap map(WidthMapOptions{.min_mm = 1.0, .max_mm = 2.0});
    map.push(at_ms(0.0, 0.0));
    double width = 0.0;
    for (int i = 1; i <= 100; ++i) {
      width = map.push(at_ms(0.2 * i + (i % 2 == 1 ? 0.1 * uneven : 0.0), 1.0)).width_mm;
    }
    EXPECT_NEAR(width, 2.0 - std::exp(-1.0), 0.005);
  }
}

TEST(WidthMap, TimesThatStandStillOrRunBackwardsDoNotFreezeIt) {
  for (const double step_ms : {0.0, -3.0, -1e12}) {
    WidthMap map(WidthMapOptions{.min_mm = 1.0, .max_mm = 2.0});
    double width = map.push(at_ms(0.0, 0.0)).width_mm;
    for (int i = 1; i < 1000; ++i) {
      const double next = map.push(at_ms(step_ms * (i % 7), 1.0)).width_mm;
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
    const InkWidth ink = map.push(sample);
    EXPECT_GE(ink.width_mm, 0.05);
    EXPECT_LE(ink.width_mm, 6.0);
    EXPECT_TRUE(ink.tone >= 0.0 && ink.tone <= 1.0) << ink.tone;
  }
}

TEST(WidthMap, ALostPressureHoldsTheLastOne) {
  WidthMap map;
  const InkWidth before = map.push(at_ms(0.0, 0.8));
  EXPECT_EQ(map.push({{}, {}, 7'500'000}), before);
}

InkSample leaning(double time_ms, double pressure, std::optional<double> tilt_deg) {
  InkSample sample = at_ms(time_ms, pressure);
  sample.tilt_deg = tilt_deg;
  return sample;
}

const WidthMapOptions kCharcoal{
    .min_mm = 1.0, .max_mm = 3.0, .tilt_width = 3.0, .tone = ToneMapOptions{0.2, 0.8, 2.0, 0.5}};

TEST(WidthMap, InkWithoutAToneOfItsOwnHasThatOfItsWidth) {
  WidthMap map(WidthMapOptions{.gamma = 1.7, .tilt_width = 1.5});
  for (int i = 0; i < 40; ++i) {
    const InkWidth ink = map.push(leaning(7.5 * i, 0.025 * i, 2.0 * i));
    EXPECT_EQ(ink.tone, tone_of_width(ink.width_mm));
  }
}

TEST(WidthMap, ToneAndWidthFollowTheirFormulas) {
  EXPECT_DOUBLE_EQ(tone_of(kCharcoal, 0.0, 0.0), 0.2);
  EXPECT_DOUBLE_EQ(tone_of(kCharcoal, 1.0, 0.0), 0.8);
  EXPECT_DOUBLE_EQ(tone_of(kCharcoal, 0.5, 0.0), 0.2 + 0.6 * 0.25);
  EXPECT_DOUBLE_EQ(tone_of(kCharcoal, 0.5, 0.5), (0.2 + 0.6 * 0.25) * 0.75);
  EXPECT_DOUBLE_EQ(tone_of(kCharcoal, kNan, kNan), 0.2 + 0.6 * 0.25);
  EXPECT_DOUBLE_EQ(width_of(kCharcoal, 0.5, 0.0), 2.0);
  EXPECT_DOUBLE_EQ(width_of(kCharcoal, 0.5, 0.5), 4.0);
  EXPECT_DOUBLE_EQ(width_of(kCharcoal, 0.5, 7.0), 6.0);
}

TEST(WidthMap, OnlyWhatLiesBeyondAHandsHabitIsTilt) {
  for (const double tilt_deg : {0.0, 20.0, 40.0, -30.0}) {
    WidthMap map(kCharcoal), upright(kCharcoal);
    EXPECT_EQ(map.push(leaning(0.0, 0.5, tilt_deg)), upright.push(at_ms(0.0, 0.5))) << tilt_deg;
  }
  WidthMap flat(kCharcoal);
  EXPECT_EQ(flat.push(leaning(0.0, 0.5, 65.0)),
            (InkWidth{width_of(kCharcoal, 0.5, 1.0), tone_of(kCharcoal, 0.5, 1.0)}));
}

TEST(WidthMap, TiltPassesTheLowPassAndHoldsWhereItIsLost) {
  WidthMap map(kCharcoal);
  double width = map.push(leaning(0.0, 0.5, 0.0)).width_mm;
  EXPECT_DOUBLE_EQ(width, 2.0);
  for (int i = 1; i <= 100; ++i) width = map.push(leaning(0.2 * i, 0.5, 90.0)).width_mm;
  EXPECT_NEAR(width, 2.0 * (1.0 + 2.0 * (1.0 - std::exp(-1.0))), 0.02);
  for (int i = 0; i < 1000; ++i) width = map.push(leaning(20.0 + i, 0.5, {})).width_mm;
  EXPECT_NEAR(width, 6.0, 1e-6);
}

TEST(WidthMap, ASourceWithoutTiltTiltsAsTheOptionsSay) {
  WidthMapOptions options = kCharcoal;
  options.absent_tilt_deg = 65.0;
  WidthMap map(options);
  EXPECT_DOUBLE_EQ(map.push(at_ms(0.0, 0.5)).width_mm, 6.0);
  map.begin();
  EXPECT_DOUBLE_EQ(map.push(leaning(0.0, 0.5, 10.0)).width_mm, 2.0);
}

RC_GTEST_PROP(WidthMap, ToneIsMonotonicAndInRange, ()) {
  const auto share = [] { return *rc::gen::inRange(0, 1001) / 1000.0; };
  WidthMapOptions options = kCharcoal;
  options.tone = ToneMapOptions{share(), share(), *rc::gen::element(0.3, 1.0, 2.2), share()};
  const double p = share(), more = std::min(p + share(), 1.0), l = share();
  const double light = tone_of(options, p, l), heavy = tone_of(options, more, l);
  RC_ASSERT(light >= 0.0 && light <= 1.0);
  const double sign = options.tone->light <= options.tone->heavy ? 1.0 : -1.0;
  RC_ASSERT(sign * (heavy - light) >= -1e-15);
  RC_ASSERT(tone_of(options, p, std::min(l + share(), 1.0)) <= light + 1e-15);
}

TEST(WidthMap, HostileMediaGiveTonesAllTheSame) {
  const WidthMapOptions options{
      .tilt_width = kNan,
      .absent_tilt_deg = kNan,
      .tone = ToneMapOptions{kNan, -7.0, -1.0, std::numeric_limits<double>::infinity()}};
  WidthMap map(options);
  for (const double tilt_deg : {kNan, 1e300, -1e300}) {
    const InkWidth ink = map.push(leaning(0.0, 0.7, tilt_deg));
    EXPECT_TRUE(ink.tone >= 0.0 && ink.tone <= 1.0) << ink.tone;
    EXPECT_TRUE(ink.width_mm >= 0.3 && ink.width_mm <= 6.0) << ink.width_mm;
  }
}

}  // namespace
}  // namespace felt::width_map_test
