#include "felt/render/plot_trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace felt::plot_trace_test {
namespace {

TEST(PlotTrace, KeepsEachValueWhileThereIsRoom) {
  PlotTrace trace(2.0, 0.5, 4);
  for (const double value : {1.0, -3.0, 2.0}) trace.add(value);
  ASSERT_EQ(trace.size(), 3u);
  EXPECT_EQ(trace[1].low, -3.0);
  EXPECT_EQ(trace[1].high, -3.0);
  EXPECT_EQ(trace.time_s(0), 2.0);
  EXPECT_EQ(trace.time_s(3), 3.5);
}

TEST(PlotTrace, NoPeakIsLostAndMemoryIsBounded) {
  for (const int count : {5, 63, 64, 65, 1000, 12345}) {
    for (const int at : {0, 1, count / 3, count - 2, count - 1}) {
      PlotTrace trace(0.0, 0.001, 64);
      for (int i = 0; i < count; ++i) trace.add(i == at ? 7.0 : std::sin(0.1 * i));
      EXPECT_LE(trace.size(), 64u);
      EXPECT_GE(trace.time_s(trace.size()), 0.001 * count - 1e-9);
      EXPECT_LT(trace.time_s(trace.size() - 1), 0.001 * count);
      EXPECT_EQ(trace.range(0.0, 100.0).high, 7.0) << count << " values, peak at " << at;
      // The peak is at the same time as before, up to the width of an interval.
      const double around = trace.stretch_s();
      EXPECT_EQ(trace.range(0.001 * at - around, 0.001 * at + around).high, 7.0);
    }
  }
}

TEST(PlotTrace, WhatIsNotFiniteIsAGap) {
  PlotTrace trace(0.0, 1.0, 8);
  trace.add(std::numeric_limits<double>::quiet_NaN());
  trace.add(std::numeric_limits<double>::infinity());
  trace.add(4.0);
  EXPECT_TRUE(trace[0].empty());
  EXPECT_TRUE(trace[1].empty());
  EXPECT_FALSE(trace[2].empty());
  EXPECT_TRUE(trace.range(0.0, 2.0).empty());
  EXPECT_EQ(trace.range(0.0, 3.0).low, 4.0);
}

}  // namespace
}  // namespace felt::plot_trace_test
