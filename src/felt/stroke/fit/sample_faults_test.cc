#include "felt/stroke/fit/sample_faults.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "felt/stroke/fit/ink_fitter.h"

namespace felt::sample_faults_test {
namespace {

using Ink = std::vector<InkSample>;

// Returns a wave at 125 Hz whose pressure rises and falls.
Ink wave(int count) {
  Ink ink;
  for (int i = 0; i < count; ++i) {
    ink.push_back({{2.0 * i, 30.0 + 8.0 * std::sin(0.3 * i)},
                   0.5 + 0.45 * std::sin(0.15 * i),
                   std::int64_t{8'000'000} * i});
  }
  return ink;
}

struct Drawn {
  Stroke stroke;
  SampleFaults faults;
};

Drawn draw(const Ink& ink, const InkFitOptions& options = {}) {
  InkFitter fitter(options);
  fitter.begin();
  for (const InkSample& sample : ink) fitter.push(sample);
  fitter.end();
  fitter.refine();
  return {fitter.stroke().value(), fitter.faults()};
}

Ink with_times(Ink ink, const std::function<std::int64_t(std::int64_t)>& time) {
  for (InkSample& sample : ink) sample.time_ns = time(*sample.time_ns);
  return ink;
}

Ink without_times(Ink ink) {
  for (InkSample& sample : ink) sample.time_ns.reset();
  return ink;
}

double widest(const Stroke& stroke) {
  double width = 0.0;
  for (const WidthKnot& knot : stroke.widths()) width = std::max(width, knot.width_mm);
  return width;
}

TEST(SampleFaults, GoodSamplesHaveNone) {
  const Drawn good = draw(wave(40));
  EXPECT_TRUE(fault_clauses(good.faults).empty());
  EXPECT_FALSE(good.faults.has_no_clock);
  EXPECT_TRUE(fault_clauses(draw(without_times(wave(40))).faults).empty());
}

TEST(SampleFaults, TimesThatAreNoneCountAsAbsentAndKeepThePressure) {
  const double reference = widest(draw(wave(40)).stroke);
  const Stroke expected = draw(without_times(wave(40))).stroke;
  EXPECT_NEAR(widest(expected), reference, 0.1 * reference);
  const auto same = [](std::int64_t) { return std::int64_t{1'700'000'000}; };
  const auto backwards = [](std::int64_t t) { return 1'000'000'000 - t; };
  const auto seconds = [](std::int64_t t) { return t / 1000; };
  for (const auto& time :
       {std::function<std::int64_t(std::int64_t)>(same), {backwards}, {seconds}}) {
    const Drawn drawn = draw(with_times(wave(40), time));
    EXPECT_EQ(drawn.stroke.data(), expected.data());
    EXPECT_TRUE(drawn.faults.has_no_clock);
    ASSERT_EQ(fault_clauses(drawn.faults).size(), 1u);
    EXPECT_NE(fault_clauses(drawn.faults)[0].find("not milliseconds"), std::string::npos);
  }
}

TEST(SampleFaults, AClockThatIsSetBackOnceIsNamedAndUsed) {
  const Drawn drawn = draw(
      with_times(wave(40), [](std::int64_t t) { return t < 160'000'000 ? t : t - 160'000'000; }));
  EXPECT_EQ(drawn.faults.backward_times, 1u);
  EXPECT_FALSE(drawn.faults.has_no_clock);
  ASSERT_EQ(fault_clauses(drawn.faults).size(), 1u);
  EXPECT_NE(fault_clauses(drawn.faults)[0].find("backwards in places"), std::string::npos);
}

TEST(SampleFaults, SamplesThatArriveTogetherAreNoFault) {
  // A driver that reports four samples at once gives them the same time.
  const Drawn drawn =
      draw(with_times(wave(40), [](std::int64_t t) { return t / 32'000'000 * 32'000'000; }));
  EXPECT_TRUE(fault_clauses(drawn.faults).empty());
}

TEST(SampleFaults, TimesAreNotNamedIfNothingDependsOnThem) {
  Ink ink = with_times(wave(40), [](std::int64_t) { return std::int64_t{0}; });
  ink.resize(3);
  EXPECT_TRUE(fault_clauses(draw(ink).faults).empty());  // a dot within a millisecond
  ink = with_times(wave(40), [](std::int64_t) { return std::int64_t{0}; });
  for (InkSample& sample : ink) sample.pressure = 0.5;
  EXPECT_TRUE(fault_clauses(draw(ink).faults).empty());
  InkFitOptions filtering;
  filtering.filter_artefacts = true;
  EXPECT_FALSE(fault_clauses(draw(ink, filtering).faults).empty());
  for (InkSample& sample : ink) sample.pressure.reset();
  EXPECT_TRUE(fault_clauses(draw(ink).faults).empty());
  for (std::size_t i = 0; i < ink.size(); ++i) ink[i].tilt_deg = static_cast<double>(i);
  EXPECT_FALSE(fault_clauses(draw(ink).faults).empty());
}

TEST(SampleFaults, DriversMaySlightlyExceedTheirRange) {
  Ink ink = wave(4);
  ink[0].pressure = 1.03;
  ink[1].pressure = -0.03;
  ink[2].pressure = std::nan("");
  EXPECT_EQ(draw(ink).faults.bad_pressures, 0u);
  ink[3].pressure = -std::numeric_limits<double>::infinity();
  const SampleFaults faults = draw(ink).faults;
  EXPECT_EQ(faults.bad_pressures, 1u);
  EXPECT_EQ(name_with_faults("stroke 'a'", faults),
            "stroke 'a' (1 of 4 pressures, for example -1000000000000000)");
}

// However large the raw pressures are, the stroke is that of the limited ones, and all are counted.
RC_GTEST_PROP(SampleFaults, RawPressuresAreLimitedAndCounted, ()) {
  const double full = *rc::gen::element(255.0, 1023.0, 4095.0, 65535.0, 1e300);
  Ink raw = wave(*rc::gen::inRange(1, 60)), limited = raw;
  std::size_t outside = 0;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    raw[i].pressure = (*raw[i].pressure - *rc::gen::element(0.0, 0.5)) * full;
    limited[i].pressure = std::clamp(*raw[i].pressure, 0.0, 1.0);
    outside += std::fabs(*raw[i].pressure - *limited[i].pressure) > kPressureSlack ? 1 : 0;
  }
  const Drawn drawn = draw(raw);
  RC_ASSERT(drawn.stroke.data() == draw(limited).stroke.data());
  RC_ASSERT(drawn.faults.bad_pressures == outside);
  RC_ASSERT(fault_clauses(drawn.faults).empty() == (outside == 0));
}

// Whatever the times are, they never make the ink narrower or wider than its pressures.
RC_GTEST_PROP(SampleFaults, AnyTimesGiveAStrokeWithinTheWidthsOfItsPressures, ()) {
  Ink ink = wave(40);
  for (InkSample& sample : ink) sample.time_ns = *rc::gen::arbitrary<std::int64_t>();
  const Drawn drawn = draw(ink);
  for (const WidthKnot& knot : drawn.stroke.widths()) {
    RC_ASSERT(knot.width_mm >= kPenWidths.min_mm - 0.15 &&
              knot.width_mm <= kPenWidths.max_mm + 0.15);
  }
}

}  // namespace
}  // namespace felt::sample_faults_test
