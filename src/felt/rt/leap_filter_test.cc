#include "felt/rt/leap_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "felt/base/constants.h"

namespace felt::leap_filter_test {
namespace {

class Pen {
 public:
  std::optional<PenSample> at(double x_mm, double z_mm) {
    now_ns_ += kMs;
    sample_.time_ns = now_ns_;
    sample_.position = {x_mm, 0, z_mm};
    return pass();
  }
  /// Simulates a tick in which the device does not have a newer sample.
  std::optional<PenSample> wait() {
    now_ns_ += kMs;
    return pass();
  }
  /// Simulates a loop that stands still.
  void stall(std::int64_t ms) { now_ns_ += ms * kMs; }
  [[nodiscard]] std::uint32_t cuts() const { return filter_.cuts(); }
  std::vector<PenSample> handed_on;

 private:
  std::optional<PenSample> pass() {
    auto passed = filter_.pass(sample_, now_ns_);
    if (passed) handed_on.push_back(*passed);
    return passed;
  }

  LeapFilter filter_{SafetyLimits{}};
  PenSample sample_;
  std::int64_t now_ns_ = 0;
};

TEST(LeapFilter, AHandPassesAsItIs) {
  Pen pen;
  for (int i = 0; i < 500; ++i) {
    const auto passed = pen.at(2.5 * (i % 100 < 50 ? i % 100 : 100 - i % 100), -0.5);
    ASSERT_TRUE(passed.has_value()) << i;
    EXPECT_LT(passed->position.z, 0.0);
  }
}

TEST(LeapFilter, OneLeapIsLeftOut) {
  Pen pen;
  pen.at(0, -1);
  EXPECT_FALSE(pen.at(1000, -1).has_value());
  EXPECT_TRUE(pen.at(0.1, -1).has_value());
}

// The stroke ends at the last accepted position. Ink after the position has been steady for a while
// is a new stroke.
TEST(LeapFilter, ALastingLeapLiftsThePenWhereItWas) {
  Pen pen;
  for (int i = 0; i < 10; ++i) pen.at(0.1 * i, -1);
  pen.handed_on.clear();
  for (int i = 0; i < 95; ++i) pen.at(1000, -1);
  ASSERT_EQ(pen.handed_on.size(), 1u);
  EXPECT_NEAR(pen.handed_on[0].position.x, 0.9, 1e-9);
  EXPECT_FALSE(in_contact(pen.handed_on[0]));
  EXPECT_GE(pen.handed_on[0].position.z, LeapFilter::kLiftMm);
  EXPECT_EQ(pen.cuts(), 1u);
  for (int i = 0; i < 20; ++i) pen.at(1000, -1);
  EXPECT_TRUE(pen.at(1000, -1).has_value());
  EXPECT_EQ(pen.cuts(), 1u);
}

TEST(LeapFilter, ALeapInTheAirIsBelievedWhenItLasts) {
  Pen pen;
  for (int i = 0; i < 10; ++i) pen.at(0, 2);
  EXPECT_FALSE(pen.at(60, 2).has_value());
  for (int i = 0; i < 5; ++i) pen.at(60, 2);
  EXPECT_TRUE(pen.at(60, 0.5).has_value());
  EXPECT_TRUE(pen.at(60, -1).has_value());
  EXPECT_EQ(pen.cuts(), 0u);
}

/// Returns the longest line that the samples draw while the pen touches, or is so near that it may
/// be bouncing within a stroke.
double longest_line_mm(const std::vector<PenSample>& samples) {
  double longest = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const PenSample &a = samples[i - 1], &b = samples[i];
    if (a.position.z >= LeapFilter::kLiftMm || b.position.z >= LeapFilter::kLiftMm) continue;
    longest = std::max(longest, std::abs(b.position.x - a.position.x));
  }
  return longest;
}

TEST(LeapFilter, R49_ALeapDuringABounceDrawsNoLine) {
  for (const double before_z : {-1.0, 0.1, 0.9}) {
    for (const double after_z : {-1.0, 0.1, 0.3}) {
      Pen pen;
      for (int i = 0; i < 10; ++i) pen.at(0, -1);
      for (int i = 0; i < 2; ++i) pen.at(0, before_z);
      for (int i = 0; i < 4; ++i) pen.at(1000, after_z);
      for (int i = 0; i < 300; ++i) pen.at(1000, -1);
      EXPECT_LT(longest_line_mm(pen.handed_on), 1.0) << before_z << ' ' << after_z;
      EXPECT_EQ(pen.cuts(), 1u);
      EXPECT_NEAR(pen.handed_on.back().position.x, 1000.0, 1e-9);
    }
  }
}

// The service does not answer for a while, or the loop stands still, while the hand continues to
// move.
TEST(LeapFilter, R49_AStallWhileDrawingLosesNoInk) {
  for (const int stall_ms : {5, 8, 12, 16, 20, 30, 60}) {
    for (const double mm_per_ms : {0.1, 0.2, 0.35, 0.5}) {
      for (const bool repeats : {true, false}) {
        if (repeats && stall_ms > 20) continue;  // because that would be a fault of the device
        SCOPED_TRACE(std::to_string(stall_ms) + " ms at " + std::to_string(mm_per_ms));
        Pen pen;
        double x = 0.0;
        for (int i = 0; i < 50; ++i) pen.at(x += mm_per_ms, -1);
        for (int i = 0; repeats && i < stall_ms; ++i) pen.wait();
        if (!repeats) pen.stall(stall_ms);
        x += stall_ms * mm_per_ms;
        for (int i = 0; i < 50; ++i) EXPECT_TRUE(pen.at(x += mm_per_ms, -1).has_value());
        EXPECT_EQ(pen.cuts(), 0u);
        EXPECT_EQ(pen.handed_on.size(), 100u);
      }
    }
  }
}

TEST(LeapFilter, R49_AfterALongStallAFarPenBeginsANewStroke) {
  Pen pen;
  for (int i = 0; i < 10; ++i) pen.at(0, -1);
  pen.stall(500);
  for (int i = 0; i < 10; ++i) pen.at(200 + i, -1);
  EXPECT_LT(longest_line_mm(pen.handed_on), 1.5);
  EXPECT_EQ(pen.cuts(), 1u);
  EXPECT_EQ(pen.handed_on.size(), 20u) << "one of them says that the pen is lifted";
}

TEST(LeapFilter, ALeapAfterASilenceIsALeap) {
  Pen pen;
  for (int i = 0; i < 10; ++i) pen.at(0, -1);
  for (int i = 0; i < 1000; ++i) pen.wait();
  for (int i = 0; i < 50; ++i) pen.at(80, -1);
  EXPECT_EQ(pen.cuts(), 1u);
}

TEST(LeapFilter, EverySecondPositionALieEndsTheStroke) {
  Pen pen;
  for (int i = 0; i < 10; ++i) pen.at(0, -1);
  pen.handed_on.clear();
  int lifts = 0;
  for (int i = 0; i < 3000; ++i) pen.at(i % 2 == 0 ? 1000 : 0, -1);
  for (const PenSample& sample : pen.handed_on) {
    EXPECT_NEAR(sample.position.x, 0.0, 1e-9);
    lifts += in_contact(sample) ? 0 : 1;
  }
  EXPECT_EQ(lifts, 1);
  EXPECT_LT(pen.handed_on.size(), 30u);
}

TEST(LeapFilter, APressureIsLiftedToo) {
  LeapFilter filter{SafetyLimits{}};
  PenSample sample;
  sample.position.z = -1;
  sample.pressure = 0.5;
  filter.pass(sample, 0);
  sample.position.x = 500;
  std::optional<PenSample> last;
  for (int i = 1; i < 6 && !last; ++i) {
    sample.time_ns = i * kMs;
    last = filter.pass(sample, i * kMs);
  }
  ASSERT_TRUE(last.has_value());
  EXPECT_FALSE(in_contact(*last));
}

}  // namespace
}  // namespace felt::leap_filter_test
