#include "felt/rt/leap_filter.h"

#include <gtest/gtest.h>

#include <vector>

namespace felt {
namespace {

constexpr std::int64_t kMs = 1'000'000;

class Pen {
 public:
  std::optional<PenSample> at(double x_mm, double z_mm) {
    now_ns_ += kMs;
    PenSample sample;
    sample.time_ns = now_ns_;
    sample.position = {x_mm, 0, z_mm};
    auto passed = filter_.pass(sample, now_ns_);
    if (passed) handed_on.push_back(*passed);
    return passed;
  }
  std::vector<PenSample> handed_on;

 private:
  LeapFilter filter_{SafetyLimits{}};
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

// Whatever the position does afterwards, the stroke ends where the pen was last believed, and
// nothing is handed on from the wrong place while it touches there.
TEST(LeapFilter, ALastingLeapLiftsThePenWhereItWas) {
  Pen pen;
  for (int i = 0; i < 10; ++i) pen.at(0.1 * i, -1);
  pen.handed_on.clear();
  for (int i = 0; i < 1000; ++i) pen.at(1000, -1);
  ASSERT_EQ(pen.handed_on.size(), 1u);
  EXPECT_NEAR(pen.handed_on[0].position.x, 0.9, 1e-9);
  EXPECT_FALSE(in_contact(pen.handed_on[0]));
  EXPECT_GE(pen.handed_on[0].position.z, LeapFilter::kLiftMm);
  EXPECT_TRUE(pen.at(1000, 1).has_value()) << "lifted there it is believed again";
  EXPECT_TRUE(pen.at(1000, -1).has_value());
}

TEST(LeapFilter, ALeapInTheAirIsBelievedWhenItLasts) {
  Pen pen;
  for (int i = 0; i < 10; ++i) pen.at(0, 2);
  EXPECT_FALSE(pen.at(60, 2).has_value());
  for (int i = 0; i < 5; ++i) pen.at(60, 2);
  EXPECT_TRUE(pen.at(60, 0.5).has_value());
  EXPECT_TRUE(pen.at(60, -1).has_value());
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
  for (int i = 1; i < 6 && !last; ++i) last = filter.pass(sample, i * kMs);
  ASSERT_TRUE(last.has_value());
  EXPECT_FALSE(in_contact(*last));
}

}  // namespace
}  // namespace felt
