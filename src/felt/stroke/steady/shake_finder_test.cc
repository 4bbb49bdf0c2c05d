#include "felt/stroke/steady/shake_finder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "felt/base/random.h"

namespace felt::shake_finder_test {
namespace {

/// Returns a spiral of six turns in 10 s, by a hand that shakes; 0 mm is a steady hand.
std::vector<InkSample> spiral(double hz, double mm, double deg, double step_s = 0.0075,
                              double seconds = 10.0, std::uint64_t seed = 1) {
  Random random(seed);
  std::vector<InkSample> samples;
  const double a = deg * std::numbers::pi / 180.0;
  for (double s = 0.0; s < seconds; s += step_s * random.between(0.8, 1.2)) {
    const double turn = kTau * 0.6 * s;
    Point p{4.5 * s * std::cos(turn), 4.5 * s * std::sin(turn)};
    p += mm * std::sin(kTau * hz * s) * Vec{std::cos(a), std::sin(a)};
    p += 0.02 * Vec{random.normal(), random.normal()};
    samples.push_back({p, 0.5, std::llround(1e9 * s)});
  }
  return samples;
}

std::string why_not(const std::vector<InkSample>& samples) {
  const Result<Shake> shake = find_shake(samples);
  return shake ? "found " + shake_to_text(*shake) : shake.error().message;
}

RC_GTEST_PROP(ShakeFinder, FindsFrequencyAmplitudeAndAxis, (std::uint64_t seed)) {
  Random random(seed);
  const double hz = random.between(3.6, 11.5), mm = random.between(0.3, 3.0);
  const double deg = random.between(0.0, 180.0);
  const Result<Shake> shake =
      find_shake(spiral(hz, mm, deg, random.between(0.002, 0.015), random.between(6, 15), seed));
  RC_ASSERT(shake.has_value());
  RC_ASSERT(std::fabs(shake->hz - hz) < 0.35);
  // At the lowest frequencies, the turns of the spiral add up to 0.03 mm (10^5 spirals).
  const double turns_mm = hz < 4.5 ? 0.05 : 0.0;
  RC_ASSERT(std::fabs(shake->amplitude_mm - mm) < 0.2 * mm + turns_mm);
  const double off = std::fmod(std::fabs(shake->axis_deg - deg), 180.0);
  RC_ASSERT(std::min(off, 180.0 - off) < 12.0);
}

TEST(ShakeFinder, AJerkDoesNotChangeIt) {
  auto samples = spiral(5.0, 1.0, 40.0);
  for (std::size_t i = 600; i < 612; ++i) samples[i].position += Vec{15, -20};
  const Result<Shake> shake = find_shake(samples);
  ASSERT_TRUE(shake) << shake.error().message;
  EXPECT_NEAR(shake->hz, 5.0, 0.4);
}

TEST(ShakeFinder, RefusesTimesThatAreNotMilliseconds) {
  const auto with_times = [](auto time_of) {
    std::vector<InkSample> samples = spiral(5.0, 1.0, 40.0);
    for (InkSample& sample : samples) sample.time_ns = time_of(*sample.time_ns);
    return why_not(samples);
  };
  const auto refused = ::testing::StartsWith("the times are not milliseconds");
  EXPECT_THAT(with_times([](std::int64_t ns) { return ns / 1000; }), refused);  // seconds
  EXPECT_THAT(with_times([](std::int64_t) { return 0; }), refused);
  EXPECT_THAT(with_times([](std::int64_t ns) { return 20'000'000'000 - ns; }), refused);
  EXPECT_THAT(with_times([](std::int64_t ns) { return ns; }), ::testing::StartsWith("found"));
}

TEST(ShakeFinder, SaysWhyItFindsNothing) {
  EXPECT_EQ(why_not(spiral(5.0, 0.0, 0.0)).substr(0, 20), "no shaking was found");
  EXPECT_EQ(why_not(spiral(5.0, 1.0, 0.0, 0.0075, 3.0)).substr(0, 9), "too short");
  EXPECT_EQ(why_not(spiral(5.0, 1.0, 0.0, 0.045)).substr(0, 15), "too few samples");
  EXPECT_EQ(why_not({}).substr(0, 9), "too short");
  auto timeless = spiral(5.0, 1.0, 0.0);
  for (InkSample& sample : timeless) sample.time_ns.reset();
  EXPECT_EQ(why_not(timeless), "the samples have no times, so no frequency can be measured");
}

TEST(ShakeFinder, SurvivesAnything) {
  Random random(8);
  for (int run = 0; run < 50; ++run) {
    auto samples = spiral(5.0, 1.0, 0.0, 0.0075, 6.0, random.bits());
    for (InkSample& sample : samples) {
      const double dice = random.between(0, 1);
      if (dice < 0.02) sample.position.x = std::numeric_limits<double>::quiet_NaN();
      if (dice > 0.98) sample.time_ns = static_cast<std::int64_t>(random.bits());
      if (dice > 0.96 && dice < 0.97) sample.position.y = 1e9;
    }
    const Result<Shake> shake = find_shake(samples);
    if (!shake) continue;
    EXPECT_GE(shake->hz, Shake::kMinHz);
    EXPECT_LE(shake->hz, Shake::kMaxHz);
    EXPECT_LE(shake->amplitude_mm, Shake::kMaxAmplitudeMm);
    EXPECT_TRUE(shake->axis_deg >= 0.0 && shake->axis_deg <= 180.0);
  }
}

TEST(Shake, TextAndFileHaveTheSameValues) {
  const Shake shake{5.25, 1.5, 30.0};
  EXPECT_EQ(shake_to_text(shake), "5.25,1.50,30.00");
  EXPECT_EQ(shake_from_text("5.25,1.50,30"), shake);
  EXPECT_EQ(read_shake(write_shake(shake)), shake);
  EXPECT_EQ(read_shake("axis_deg=30\r\n\n hz = 5.25\namplitude_mm = 1.5"), shake);
}

TEST(Shake, BadTextsAreRefusedWithAReason) {
  const auto error = [](const Result<Shake>& shake) { return shake ? "" : shake.error().message; };
  EXPECT_EQ(error(shake_from_text("5,1")),
            "expected HZ,MM,DEG: frequency, amplitude and axis, for example 5.2,1,30");
  EXPECT_EQ(error(shake_from_text("20,1,0")), "hz: \"20\" is not a number from 3.00 to 12.00");
  EXPECT_EQ(error(shake_from_text("5,nan,0")),
            "amplitude_mm: \"nan\" is not a number from 0.10 to 10.00");
  EXPECT_FALSE(error(shake_from_text("5,1,0,7")).empty());
  EXPECT_FALSE(error(shake_from_text("")).empty());
  EXPECT_EQ(error(read_shake("hz = 5\n")), "the value \"amplitude_mm\" is missing");
  EXPECT_EQ(error(read_shake("hz = 5\nspeed = 3")).substr(0, 7), "line 2:");
  EXPECT_EQ(error(read_shake("hz = five")).substr(0, 7), "line 1:");
}

}  // namespace
}  // namespace felt::shake_finder_test
