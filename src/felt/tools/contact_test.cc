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

}  // namespace
}  // namespace felt::contact_test
