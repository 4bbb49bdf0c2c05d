#include "felt/tools/contact.h"

#include <gtest/gtest.h>

#include <limits>

namespace felt::contact_test {
namespace {

using Change = Contact::Change;

struct Clocked {
  Contact contact;
  std::int64_t now_ns = 0;

  Change at(double z, double ms = 1.0, std::optional<double> pressure = std::nullopt) {
    now_ns += static_cast<std::int64_t>(ms * 1e6);
    PenSample s;
    s.time_ns = now_ns;
    s.position.z = z;
    s.pressure = pressure;
    return contact.update(s);
  }
};

TEST(Contact, BeginsAtOnceAndEndsWithALift) {
  Clocked pen;
  EXPECT_EQ(pen.at(5), Change::kAir);
  EXPECT_EQ(pen.at(-0.001), Change::kTouched);
  EXPECT_EQ(pen.at(-1), Change::kDown);
  EXPECT_EQ(pen.at(Contact::kLiftMm), Change::kLifted);
  EXPECT_EQ(pen.at(0.0), Change::kAir);
  EXPECT_FALSE(pen.contact.is_down());
}

TEST(Contact, ChatterDoesNotEndIt) {
  Clocked pen;
  EXPECT_EQ(pen.at(-0.1), Change::kTouched);
  for (int k = 0; k < 10000; ++k) {
    const double z = k % 7 < 3 ? 0.03 : -0.02;
    EXPECT_NE(pen.at(z), Change::kLifted);
    EXPECT_TRUE(pen.contact.is_down());
  }
  // A bounce of some milliseconds and tenths of a millimetre.
  for (int k = 0; k < 20; ++k) EXPECT_EQ(pen.at(0.3), Change::kGap);
  EXPECT_EQ(pen.at(-0.1), Change::kBack);
}

TEST(Contact, ALowPenThatStaysOutIsLifted) {
  Clocked pen;
  pen.at(-0.1);
  int gap = 0;
  while (pen.at(0.1) == Change::kGap) ++gap;
  EXPECT_EQ(gap, 25);
  EXPECT_FALSE(pen.contact.is_down());
}

TEST(Contact, PressureAloneIsContact) {
  Clocked pen;
  EXPECT_EQ(pen.at(0, 7.5, 0.0), Change::kAir);
  EXPECT_EQ(pen.at(0, 7.5, 0.2), Change::kTouched);
  EXPECT_EQ(pen.at(0, 7.5, 0.0), Change::kGap);  // a lost report
  EXPECT_EQ(pen.at(0, 7.5, 0.3), Change::kBack);
  pen.at(0, 7.5, 0.0);
  EXPECT_EQ(pen.at(0, 30, 0.0), Change::kLifted);
}

TEST(Contact, AClockThatStandsOrRunsBackwardsDoesNotHoldIt) {
  for (const double ms : {0.0, -5.0}) {
    Clocked pen;
    pen.at(-0.1);
    int gap = 0;
    while (pen.at(0.1, ms) == Change::kGap) ++gap;
    EXPECT_LT(gap, Contact::kMaxGapSamples);
  }
  Clocked pen;
  pen.now_ns = std::numeric_limits<std::int64_t>::min() + 1;
  pen.at(-0.1, 0);
  pen.at(0.1, 0);
  pen.now_ns = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(pen.at(0.1, 0), Change::kLifted);
}

/// Lands at a speed, dives for 40 ms, and leaves the surface at another speed, in mm/s.
Clocked landed(double fall, double leave) {
  Clocked pen;
  for (double z = 5.0; z > 0.0; z -= 1e-3 * fall) EXPECT_EQ(pen.at(z), Change::kAir);
  EXPECT_EQ(pen.at(-1e-3 * fall), Change::kTouched);
  for (int k = 40; k > 0; --k) EXPECT_EQ(pen.at(-1e-3 * leave * k), Change::kDown);
  return pen;
}

TEST(Contact, R64_ABounceThatTheSurfaceThrowsIsNoLift) {
  for (const double leave : {10.0, 30.0, 55.0}) {
    SCOPED_TRACE(leave);
    Clocked pen = landed(60.0, leave);
    // The hand slows the pen down, so that it is back after 80 ms.
    for (double t = 1.0; t < 80.0; ++t) {
      ASSERT_EQ(pen.at(1e-3 * leave * t * (1.0 - t / 80.0) + 1e-6), Change::kGap);
    }
    EXPECT_EQ(pen.at(-0.1), Change::kBack);
  }
}

// A hand with the 0.4 kg of a delta.3 stays on the surface for 121 ms between two bounces.
TEST(Contact, R64_AHeavyPenBouncesAfterALongContact) {
  for (const bool is_old : {false, true}) {
    Clocked pen = landed(60.0, 30.0);
    if (is_old) pen.contact.set_landed_ns(120'000'000);
    for (int k = 90; k > 0; --k) EXPECT_EQ(pen.at(-0.03 * k), Change::kDown);
    for (double t = 1.0; t < 26.0; ++t)
      EXPECT_EQ(pen.at(0.03 * t * (1.0 - t / 30.0)), Change::kGap);
    EXPECT_EQ(pen.at(0.1), is_old ? Change::kLifted : Change::kGap);
  }
}

TEST(Contact, R64_ALiftAcceleratesAfterTheSurface) {
  Clocked pen = landed(60.0, 20.0);
  Change change = Change::kGap;
  double ms = 0.0;
  // 3,000 mm/s^2: 2.5 mm are reached after 34 ms, but the speed gives the hand away before.
  for (; change == Change::kGap; ++ms) change = pen.at(0.02 * ms + 0.5 * 3e-3 * ms * ms);
  EXPECT_EQ(change, Change::kLifted);
  EXPECT_LT(ms, 30.0);
}

TEST(Contact, R64_NoBounceIsFasterThanTheLandingNorFollowsASettledPen) {
  Clocked fast = landed(20.0, 60.0);
  Change change = Change::kGap;
  double ms = 1.0;
  for (; change == Change::kGap; ++ms) change = fast.at(0.06 * ms);
  EXPECT_LT(ms, 30.0) << "after at most kLiftNs";

  Clocked settled = landed(60.0, 30.0);
  for (int k = 0; k < 210; ++k) settled.at(-0.5);
  int gap = 0;
  while (settled.at(0.1) == Change::kGap) ++gap;
  EXPECT_EQ(gap, 25);
}

TEST(Contact, R64_PressureAndJumpsHaveTheRuleForChatterOnly) {
  Clocked tablet;
  for (int k = 0; k < 10; ++k) tablet.at(1.0 - 0.1 * k, 10.0, 0.0);
  tablet.at(0.0, 10.0, 0.4);
  tablet.at(0.0, 10.0, 0.0);
  EXPECT_EQ(tablet.at(0.0, 30.0, 0.0), Change::kLifted);

  Clocked script;
  script.at(5.0);
  script.at(-1.0);
  EXPECT_EQ(script.at(1.0), Change::kLifted);

  Clocked old;
  old.contact.set_landed_ns(0);
  for (int k = 0; k < 100; ++k) old.at(5.0 - 0.06 * k);
  EXPECT_TRUE(old.contact.is_down());
  EXPECT_EQ(old.at(0.6), Change::kLifted);
}

}  // namespace
}  // namespace felt::contact_test
