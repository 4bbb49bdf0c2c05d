#include "felt/stroke/steady/steady_line.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "felt/base/random.h"

namespace felt::steady_line_test {
namespace {

using Ink = std::vector<InkSample>;

/// Returns a path sampled at random steps around a mean, with pressure and tilt.
template <class Path>
Ink sampled(double seconds, double mean_step_s, Random& random, Path path) {
  Ink ink;
  for (double s = 0.0; s < seconds; s += mean_step_s * random.between(0.3, 1.7)) {
    ink.push_back({path(s), 0.3 + 0.1 * std::sin(s), std::llround(1e9 * s), 20.0});
  }
  return ink;
}

Vec swing(const Shake& shake, double s) {
  const double a = shake.axis_deg * std::numbers::pi / 180.0;
  return shake.amplitude_mm * std::sin(kTau * shake.hz * s) * Vec{std::cos(a), std::sin(a)};
}

/// Returns the rms distance of two lines of samples, from a time on.
double rms(const Ink& a, const Ink& b, double from_s = 0.0) {
  double sum = 0.0;
  int n = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (1e-9 * static_cast<double>(*a[i].time_ns) < from_s) continue;
    sum += std::pow(distance(a[i].position, b[i].position), 2.0);
    ++n;
  }
  return std::sqrt(sum / n);
}

struct Drawn {
  Ink live, settled, whole;
};

Drawn drawn(SteadyLine& line, const Ink& ink) {
  Drawn result;
  line.begin();
  for (const InkSample& sample : ink) {
    const auto ready = line.push(sample);
    result.settled.insert(result.settled.end(), ready.begin(), ready.end());
    result.live.push_back(sample);
    result.live.back().position = line.tip();
  }
  const auto rest = line.held();
  result.settled.insert(result.settled.end(), rest.begin(), rest.end());
  result.whole = line.smoothed();
  return result;
}

Shake random_shake(Random& random) {
  return {random.between(3.5, 11.0), random.between(0.4, 4.0), random.between(0.0, 180.0)};
}

RC_GTEST_PROP(SteadyLine, ASteadyDriftStaysAsItIs, (std::uint64_t seed)) {
  Random random(seed);
  const Vec speed{random.between(-150, 150), random.between(-150, 150)};
  const Ink ink = sampled(2.0, random.between(0.002, 0.015), random, [&](double s) {
    return Point{10, 20} + s * speed;
  });
  SteadyLine line(random_shake(random));
  const Drawn out = drawn(line, ink);
  for (std::size_t i = 0; i < ink.size(); ++i) RC_ASSERT(out.whole[i] == ink[i]);
  RC_ASSERT(rms(out.live, ink, 1.0) < 0.01);
}

RC_GTEST_PROP(SteadyLine, AnOscillationIsRemovedAtAnyRate, (std::uint64_t seed)) {
  Random random(seed);
  const Shake shake = random_shake(random);
  const Vec speed{random.between(-40, 40), random.between(-40, 40)};
  const auto intended = [&](double s) { return Point{} + s * speed; };
  const double step_s = random.between(0.002, 0.012);
  Random same = random;
  const Ink wanted = sampled(4.0, step_s, random, intended);
  const Ink ink =
      sampled(4.0, step_s, same, [&](double s) { return intended(s) + swing(shake, s); });
  SteadyLine line(shake);
  const Drawn out = drawn(line, ink);
  const double before = rms(ink, wanted, 1.0);
  RC_ASSERT(rms(out.live, wanted, 1.0) < 0.21 * before);  // at most 0.201 for 5,000 seeds
  RC_ASSERT(rms(out.settled, wanted, 1.0) < 0.15 * before);
  RC_ASSERT(rms(out.whole, wanted, 1.0) < 0.1 * before);
}

TEST(SteadyLine, OnlyPositionsChangeAndEachSampleSettlesOnce) {
  Random random(3);
  const Shake shake{5.0, 1.0, 30.0};
  const Ink ink = sampled(2.0, 0.003, random, [&](double s) {
    return Point{20 * s, 0} + swing(shake, s);
  });
  SteadyLine line(shake);
  const Drawn out = drawn(line, ink);
  ASSERT_EQ(out.settled.size(), ink.size());
  ASSERT_EQ(out.whole.size(), ink.size());
  for (std::size_t i = 0; i < ink.size(); ++i) {
    EXPECT_EQ(line.raw()[i], ink[i]);
    for (const Ink* other : {&out.settled, &out.whole}) {
      InkSample same = (*other)[i];
      same.position = ink[i].position;
      EXPECT_EQ(same, ink[i]);
    }
  }
}

TEST(SteadyLine, OnlyTheTailIsHeld) {
  Random random(4);
  const Ink ink = sampled(2.0, 0.001, random, [](double s) { return Point{30 * s, 5 * s * s}; });
  SteadyLine line({5.0, 1.0, 0.0});
  std::size_t settled = 0;
  for (const InkSample& sample : ink) {
    settled += line.push(sample).size();
    const auto held = line.held();
    ASSERT_FALSE(held.empty());
    ASSERT_LE(held.size(), SteadyLine::kMaxHeld);
    EXPECT_EQ(held.back().time_ns, sample.time_ns);
    const double tail_s = 1e-9 * static_cast<double>(*held.back().time_ns - *held.front().time_ns);
    ASSERT_LE(tail_s, SteadyLine::kTailS + SteadyLine::kGroupS + 1e-9);
  }
  EXPECT_EQ(settled + line.held().size(), ink.size());
}

TEST(SteadyLine, HoldsABoundedNumberOfSamplesOfAFastPen) {
  SteadyLine line({5.0, 1.0, 0.0});
  for (int i = 0; i < 2000; ++i) {
    line.push({{0.001 * i, 0}, 0.5, 100'000LL * i});  // 10 kHz
    ASSERT_LE(line.held().size(), SteadyLine::kMaxHeld);
  }
}

TEST(SteadyLine, NoSampleMovesFarAndAnythingIsSurvived) {
  constexpr double kBad[] = {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), 1e10};
  Random random(9);
  SteadyLine line({4.0, 2.0, 80.0});
  for (int run = 0; run < 200; ++run) {
    line.begin();
    const int count = run < 4 ? run : static_cast<int>(random.between(1, 300));
    for (int i = 0; i < count; ++i) {
      InkSample sample{{random.between(-50, 50), random.between(-50, 50)}, 0.5, {}};
      const double dice = random.between(0, 1);
      if (dice < 0.02) sample.position.x = kBad[run % 3];
      if (dice > 0.97) sample.position.y = random.between(-1e9, 1e9);
      if (random.between(0, 1) < 0.9) {
        sample.time_ns = static_cast<std::int64_t>(random.bits() >> random.bits() % 64);
      }
      line.push(sample);
      for (const InkSample& held : line.held()) ASSERT_TRUE(std::isfinite(held.position.x));
    }
    const Ink whole = line.smoothed();
    ASSERT_EQ(whole.size(), line.raw().size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
      const Point pen = line.raw()[i].position;
      ASSERT_LE(distance(whole[i].position, pen), 4.0 + 1e-6);
    }
  }
}

TEST(SteadyLine, ADotStaysADot) {
  SteadyLine line({5.0, 1.0, 0.0});
  line.push({{3, 4}, 0.5, 7});
  EXPECT_EQ(line.tip(), (Point{3, 4}));
  ASSERT_EQ(line.held().size(), 1u);
  ASSERT_EQ(line.smoothed().size(), 1u);
  EXPECT_EQ(line.smoothed()[0].position, (Point{3, 4}));
}

TEST(SteadyLine, TheNextLineDoesNotDependOnTheLast) {
  Random random(5);
  const Shake shake{6.0, 1.0, 100.0};
  const Ink ink = sampled(1.0, 0.007, random, [&](double s) {
    return Point{30 * s, 0} + swing(shake, s);
  });
  SteadyLine fresh(shake), used(shake);
  drawn(used, sampled(1.0, 0.002, random, [](double s) { return Point{-80 * s, 5}; }));
  const Drawn a = drawn(fresh, ink), b = drawn(used, ink);
  EXPECT_EQ(a.settled, b.settled);
  EXPECT_EQ(a.whole, b.whole);
}

TEST(SteadyLine, ABadClockIsSaidAfterTheFit) {
  for (const bool has_clock : {true, false}) {
    Random random(3);
    Ink ink = sampled(2.0, 0.008, random, [](double s) { return Point{20.0 * s, 0.0}; });
    for (InkSample& sample : ink) {
      sample.pressure = 0.5 + 0.3 * std::sin(1e-9 * static_cast<double>(*sample.time_ns));
      if (!has_clock) *sample.time_ns /= 1000;
    }
    SteadyLine line({});
    const SampleFaults before = steady_samples(line, ink);
    EXPECT_EQ(before.has_no_clock, !has_clock);
    EXPECT_EQ(ink.front().time_ns.has_value(), has_clock);
    SampleCheck check;
    for (const InkSample& sample : ink) check.add(sample);
    EXPECT_FALSE(check.faults().has_no_clock);  // of the samples that are left
    const SampleFaults all = combined_faults(check.faults(), before);
    EXPECT_EQ(all.has_no_clock, !has_clock);
    EXPECT_TRUE(all.needs_times);
    EXPECT_EQ(all.samples, ink.size());
    EXPECT_EQ(fault_clauses(all).empty(), has_clock);
    EXPECT_EQ(combined_faults(check.faults(), {}), check.faults());
  }
}

}  // namespace
}  // namespace felt::steady_line_test
