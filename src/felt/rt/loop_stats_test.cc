#include "felt/rt/loop_stats.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "felt/base/constants.h"

namespace felt::loop_stats_test {
namespace {

RC_GTEST_PROP(TimeHistogram, PercentilesAreNeverTooSmallAndAtMostAnEighthTooLarge, ()) {
  // Durations over all magnitudes.
  auto times = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::int64_t>>(rc::gen::map(
      rc::gen::pair(rc::gen::inRange(0, 40), rc::gen::inRange<std::int64_t>(0, 1 << 20)),
      [](const auto& p) { return (p.second << p.first) >> 20; })));
  TimeHistogram histogram;
  for (const std::int64_t t : times) histogram.add(t);
  std::sort(times.begin(), times.end());
  for (const double q : {0.0, 0.5, 0.99, 0.999, 1.0}) {
    const double rank = std::ceil(q * static_cast<double>(times.size()));
    const auto exact = times[rank < 1.0 ? 0 : static_cast<std::size_t>(rank) - 1];
    RC_ASSERT(histogram.percentile_ns(q) >= exact);
    RC_ASSERT(histogram.percentile_ns(q) <= exact + exact / 8);
  }
  RC_ASSERT(histogram.max_ns() == times.back());
}

TEST(TimeHistogram, EmptyNegativeAndEndlessDurations) {
  TimeHistogram histogram;
  EXPECT_EQ(histogram.percentile_ns(0.5), 0);
  histogram.add(-5);
  EXPECT_EQ(histogram.percentile_ns(1.0), 0);
  histogram.add(INT64_MAX);
  EXPECT_EQ(histogram.percentile_ns(1.0), INT64_MAX);
  EXPECT_EQ(histogram.count(), 2U);
}

TEST(LoopStats, PausesAreNotPartOfTheRate) {
  LoopStats stats;
  std::int64_t now_ns = 0;
  for (int i = 0; i < 101; ++i) {
    if (i % 10 == 5) {
      stats.leave_out(700 * kMs);
      now_ns += 700 * kMs;
    }
    stats.tick(now_ns, 0, kMs);
    now_ns += kMs;
  }
  EXPECT_EQ(stats.duration_ns(), 100 * kMs);
  EXPECT_NEAR(stats.rate_hz(), 1000.0, 1e-6);
}

TEST(LoopStats, CountsTicksRateAndMissedPeriods) {
  LoopStats stats;
  EXPECT_EQ(stats.rate_hz(), 0.0);
  for (int i = 0; i <= 1000; ++i) stats.tick(i * kMs, 10'000, kMs);
  EXPECT_EQ(stats.ticks(), 1001U);
  EXPECT_DOUBLE_EQ(stats.rate_hz(), 1000.0);
  EXPECT_EQ(stats.missed(), 0U);
  stats.tick(1030 * kMs, 29 * kMs, kMs);
  EXPECT_EQ(stats.missed(), 29U);
  EXPECT_EQ(stats.lateness().max_ns(), 29 * kMs);
  EXPECT_EQ(stats.cpu().count(), 0U);
}

TEST(LoopStats, MergedRunsAreAsOne) {
  LoopStats a;
  LoopStats b;
  for (int i = 0; i <= 100; ++i) a.tick(i * 1'000'000, 0, 1'000'000);
  for (int i = 0; i <= 300; ++i) b.tick(77 + i * 1'000'000, 500'000, 1'000'000);
  b.add_cpu(9000);
  a.merge(b);
  EXPECT_EQ(a.ticks(), 402U);
  EXPECT_DOUBLE_EQ(a.rate_hz(), 1000.0);
  EXPECT_EQ(a.lateness().percentile_ns(0.2), 0);
  EXPECT_GE(a.lateness().percentile_ns(0.5), 500'000);
  EXPECT_EQ(a.cpu().max_ns(), 9000);
}

TEST(LoopStats, APersonReadsOneLine) {
  LoopStats stats;
  stats.tick(0, 0, 1'000'000);
  stats.tick(1'000'000, 12'000, 1'000'000);
  EXPECT_EQ(describe(stats),
            "2 ticks at 1000.0 Hz, 0 missed; late by p50 0.0, p99 12.0, p99.9 12.0, max 12.0 us");
  stats.add_cpu(2000);
  EXPECT_NE(describe(stats).find("; CPU p50 2.0"), std::string::npos);
}

}  // namespace
}  // namespace felt::loop_stats_test
