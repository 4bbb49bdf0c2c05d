#include "felt/tools/pencil/shape_hold.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/force_memory.h"

namespace felt::shape_hold_test {
namespace {

struct Fixture {
  Fixture() { hold.begin({0, 0}, now_ns); }

  void at(Point pen, std::optional<double> pressure) {
    now_ns += 4'000'000;
    path.push_back(pen);
    hold.update(pen, pressure, now_ns, path);
  }
  /// Draws a line to (60, 0) with a pressure that varies by `swing`.
  void line(std::optional<double> pressure, double swing = 0.0) {
    for (int i = 0; i <= 120; ++i) {
      at({0.5 * i, 0.0}, pressure ? std::optional(*pressure + swing * (i % 2)) : std::nullopt);
    }
  }
  void rest(double s, std::optional<double> pressure) {
    const Point pen = path.back();
    for (int i = 0; i < static_cast<int>(s / 0.004); ++i) at(pen, pressure);
  }

  std::int64_t now_ns = 0;
  std::vector<Point> path;
  ShapeHold hold;
};

TEST(ShapeHold, OffersAfterHalfASecondAndHoldsThePenUntilTaken) {
  Fixture f;
  f.line(0.4, 0.1);
  f.rest(0.45, 0.4);
  EXPECT_TRUE(f.hold.shapes().empty());
  EXPECT_FALSE(f.hold.holds_at());
  f.rest(0.15, 0.4);
  ASSERT_EQ(f.hold.shapes().size(), 1U);
  ASSERT_TRUE(f.hold.holds_at());
  EXPECT_LT(distance(*f.hold.holds_at(), {60, 0}), RestWatch::kRestMm + 0.01);
  f.rest(5.0, 0.45);
  EXPECT_FALSE(f.hold.accepted()) << "a pen whose pressure varies must press harder";
  f.rest(0.02, 0.65);
  EXPECT_EQ(f.hold.accepted(), 0U);
  EXPECT_FALSE(f.hold.holds_at()) << "the hand is free again";
}

TEST(ShapeHold, WithoutPressureStayingTakes) {
  for (const std::optional<double> pressure : {std::optional<double>(), std::optional(0.5)}) {
    Fixture f;
    f.line(pressure);
    f.rest(1.4, pressure);
    EXPECT_FALSE(f.hold.accepted());
    f.rest(0.3, pressure);
    EXPECT_TRUE(f.hold.accepted());
  }
}

TEST(ShapeHold, APenThatPressesFullyCanStillPressHarder) {
  Fixture f;
  f.line(0.8, 0.08);
  f.rest(0.7, 0.86);
  ASSERT_FALSE(f.hold.shapes().empty());
  f.rest(0.02, 0.95);
  EXPECT_TRUE(f.hold.accepted());
}

TEST(ShapeHold, APenThatGoesOnTakesNothingByItsPressureUntilItRestsAgain) {
  Fixture f;
  f.line(0.4, 0.1);
  f.rest(0.6, 0.4);
  ASSERT_FALSE(f.hold.shapes().empty());
  // Small writing beside the end of the line, with the pressure of writing.
  for (int i = 0; i < 400; ++i) {
    const double t = 0.05 * i;
    f.at({61.0 + 1.5 * std::sin(t), 1.5 * std::cos(t)}, 0.45 + 0.25 * std::sin(0.7 * t));
    ASSERT_FALSE(f.hold.accepted()) << i;
  }
  EXPECT_FALSE(f.hold.shapes().empty()) << "it is still offered";
  f.rest(1.0, 0.7);
  EXPECT_FALSE(f.hold.accepted()) << "a rest with the pressure of the writing";
  f.rest(0.02, 0.9);
  EXPECT_TRUE(f.hold.accepted());
}

TEST(ShapeHold, TheRestAfterWritingTakesNothingAtThePressureOfTheWriting) {
  Fixture f;
  f.line(0.6, 0.1);
  f.rest(1.0, 0.4);
  ASSERT_FALSE(f.hold.shapes().empty());
  for (int i = 0; i < 500; ++i) {  // within 2.5 mm of the rest
    const double t = 0.03 * i;
    f.at({60.0 + 2.4 * std::cos(t), 0.5 * std::sin(4.0 * t)}, 0.65);
    ASSERT_FALSE(f.hold.accepted()) << i;
  }
  f.rest(2.0, 0.65);
  EXPECT_FALSE(f.hold.accepted());
  ASSERT_FALSE(f.hold.shapes().empty());
  f.rest(0.02, 0.84);
  EXPECT_TRUE(f.hold.accepted()) << "pressed harder than in this rest";
}

TEST(ShapeHold, WritingThatGoesOnInOnePlaceTakesNothingUntilThePenRests) {
  Fixture f;
  for (int i = 0; i <= 400; ++i) f.at({0.12 * i, 0.0}, 0.4 + 0.1 * (i % 2));  // 30 mm/s
  f.rest(0.7, 0.4);
  ASSERT_FALSE(f.hold.shapes().empty());
  const Point rest = *f.hold.holds_at();
  for (int i = 0; i < 500; ++i) {  // loops of 0.1 s, at 39 mm/s, and soon with more pressure
    const double t = i * kTau / 25.0;
    f.at(rest + Vec{0.8 * std::sin(t), 0.4 * std::cos(t)}, i < 30 ? 0.4 : 0.65);
    ASSERT_FALSE(f.hold.accepted()) << i;
  }
  ASSERT_FALSE(f.hold.shapes().empty());
  f.rest(0.7, 0.4);
  f.rest(0.02, 0.65);
  EXPECT_TRUE(f.hold.accepted());
}

TEST(ShapeHold, APressIsNotLostIfTheTipSlips) {
  for (const double slip_mm : {0.5, 1.5, 3.0}) {
    Fixture f;
    f.line(0.4, 0.1);
    f.rest(1.0, 0.4);
    for (int i = 1; i <= 25; ++i) f.at({60.0 + slip_mm * i / 25.0, 0.0}, 0.4 + 0.01 * i);
    f.rest(0.55, 0.65);
    EXPECT_TRUE(f.hold.accepted()) << slip_mm;
  }
}

TEST(ShapeHold, AfterALongSlipAPenThatPressesLessMayPressAgain) {
  Fixture f;
  f.line(0.4, 0.1);
  f.rest(1.0, 0.4);
  for (int i = 1; i <= 250; ++i) f.at({60.0 + 0.012 * i, 0.0}, 0.4 + 0.001 * i);
  f.rest(1.0, 0.65);
  EXPECT_FALSE(f.hold.accepted()) << "a pen that moves for a second draws";
  f.rest(0.4, 0.4);
  f.rest(0.02, 0.65);
  EXPECT_TRUE(f.hold.accepted());
}

TEST(ShapeHold, SmallWritingInOnePlaceIsNotARest) {
  Fixture f;
  for (int i = 0; i < 1500; ++i) {  // loops with a radius of 0.6 mm that advance by 1 mm/s
    const double t = 0.004 * i;
    f.at({t + 0.6 * std::cos(12.0 * t), 0.6 * std::sin(12.0 * t)}, 0.5);
    ASSERT_TRUE(f.hold.shapes().empty()) << t;
  }
}

TEST(ShapeHold, APenThatWritesInOnePlaceAndThenRestsIsOffered) {
  Fixture f;
  f.line(0.4, 0.1);
  for (int i = 0; i < 250; ++i) {
    const double t = 0.08 * i;
    f.at({60.0 + 0.9 * std::sin(t), 0.3 * std::sin(2.0 * t)}, 0.4);
  }
  f.rest(2.0, 0.4);
  EXPECT_FALSE(f.hold.shapes().empty());
}

TEST(ShapeHold, AnOfferEndsFarFromTheRestAndIsMadeAgain) {
  Fixture f;
  f.line(0.4, 0.1);
  f.rest(0.6, 0.4);
  ASSERT_TRUE(f.hold.holds_at());
  for (int i = 0; i < 7; ++i) f.at({60.0 + 0.5 * i, 0.0}, 0.4);
  EXPECT_TRUE(f.hold.holds_at()) << "nearer than kLeaveMm";
  for (int i = 0; i < 20; ++i) f.at({63.0 + 0.5 * i, 0.0}, 0.4);
  EXPECT_FALSE(f.hold.holds_at());
  EXPECT_TRUE(f.hold.shapes().empty());
  f.rest(0.6, 0.4);
  EXPECT_TRUE(f.hold.holds_at());
}

TEST(ShapeHold, TheHoldIsBoundedPassiveAndWithinTheBudget) {
  const WellShape shape = hold_shape(1.0);
  EXPECT_LE(shape.force_n, ShapeHold::kHoldN);
  EXPECT_LE(shape.core_slope_n_per_m(), 300.0);
  double last = 0.0;
  for (double d = 0.0; d < 3.0 * ShapeHold::kLeaveMm; d += 0.01) {
    EXPECT_LE(shape.force_at_n(d), ShapeHold::kHoldN);
    EXPECT_GE(shape.potential_mj(d), last - 1e-12) << "it only pulls back";
    last = shape.potential_mj(d);
  }
  EXPECT_GT(shape.force_at_n(ShapeHold::kLeaveMm), 0.2) << "it is felt up to the end of the offer";
  EXPECT_EQ(hold_shape(0.0).force_at_n(1.0), 0.0);
}

}  // namespace
}  // namespace felt::shape_hold_test
