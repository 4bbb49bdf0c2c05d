#include "felt/stroke/edit/mend_joints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/testing/fit_oracle.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/stroke/testing/test_ink.h"

namespace felt::mend_joints_test {
namespace {

double rounded(double x, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(x * scale) / scale;
}

StrokeData rounded(StrokeData d, int decimals) {
  for (Point& p : d.points) p = {rounded(p.x, decimals), rounded(p.y, decimals)};
  for (WidthKnot& k : d.widths) k.u = rounded(k.u, decimals);
  return d;
}

double largest_move(const StrokeData& a, const StrokeData& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    largest = std::max(largest, distance(a.points[i], b.points[i]));
  }
  return largest;
}

StrokeData ink_of(std::uint64_t seed) {
  testing::TestInk random(seed);
  InkFitter fitter({});
  for (const Point p : random.draw(testing::InkShape::kSmooth, random.pick(1, 400))) {
    fitter.push({.position = p, .pressure = 0.5, .time_ns = 0});
  }
  fitter.end();
  return fitter.stroke().value().data();
}

TEST(MendRounding, AStrokeRoundedToFiveOrThreeDecimalsIsOneAgain) {
  int straightened = 0, corners = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    for (const int decimals : {3, 4, 5, 8}) {
      SCOPED_TRACE(::testing::Message() << "seed " << seed << ", decimals " << decimals);
      const StrokeData before = rounded(ink_of(seed), decimals);
      StrokeData data = before;
      const MendedStroke mended = mend_rounding(data);
      straightened += mended.straightened;
      corners += mended.corners;
      EXPECT_LE(largest_move(before, data), 2.0 * kMaxMendedMm);
      if (mended.lengthened == 0) {
        EXPECT_LT(largest_move(before, data), kMaxMendedMm);
      }
      if (decimals >= 5) {
        EXPECT_EQ(mended.corners, 0);
      }
      const auto stroke = Stroke::create(data);
      EXPECT_TRUE(stroke) << stroke.error().message;
    }
  }
  EXPECT_GT(straightened, 1000);
  EXPECT_LT(corners, straightened / 20);
}

TEST(MendRounding, WhatIsRightStaysBitForBit) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const StrokeData before = ink_of(seed);
    StrokeData data = before;
    EXPECT_FALSE(mend_rounding(data).any());
    EXPECT_EQ(data, before);
  }
}

StrokeData two_segments(double turn_deg, double handle_mm) {
  const double turn = turn_deg * std::numbers::pi / 180.0;
  const Vec out = handle_mm * Vec{std::cos(turn), std::sin(turn)};
  StrokeData d;
  d.points = {{0, 0},  {3, 0}, Point{10, 0} - Vec{handle_mm, 0}, {10, 0}, Point{10, 0} + out,
              {16, 1}, {20, 3}};
  d.joints = {JointKind::kSmooth};
  d.widths = {{0.0, 1.0}, {2.0, 1.0}};
  return d;
}

TEST(MendRounding, MoreThanADegreeOrAThousandthOfAMillimetreIsACorner) {
  StrokeData slight = two_segments(0.9, 0.02);
  EXPECT_EQ(mend_rounding(slight).straightened, 1);
  EXPECT_EQ(slight.joints[0], JointKind::kSmooth);
  EXPECT_TRUE(Stroke::create(slight));
  StrokeData bent = two_segments(1.1, 0.02);
  EXPECT_EQ(mend_rounding(bent).corners, 1);
  EXPECT_EQ(bent.joints[0], JointKind::kCorner);
  StrokeData far = two_segments(0.9, 4.0);  // each handle would move by 0.03 mm
  EXPECT_EQ(mend_rounding(far).corners, 1);
  EXPECT_EQ(largest_move(far, two_segments(0.9, 4.0)), 0.0);
}

TEST(MendRounding, AHandleOfNoLengthLeavesTheDirectionToTheOtherSide) {
  StrokeData d = two_segments(0.01, 2.0);
  d.points[2] = d.points[3];
  d.points[1] = {5.0, 0.0001};
  EXPECT_TRUE(mend_rounding(d).any());
  EXPECT_TRUE(Stroke::create(d));
}

TEST(MendRounding, DamagedDataIsLeftAlone) {
  StrokeData d = two_segments(0.5, 0.02);
  d.joints.clear();
  const StrokeData before = d;
  EXPECT_FALSE(mend_rounding(d).any());
  EXPECT_EQ(d, before);
  StrokeData none;
  EXPECT_FALSE(mend_rounding(none).any());
  StrokeData nan = two_segments(0.5, 0.02);
  nan.points[4].x = std::nan("");
  EXPECT_FALSE(mend_rounding(nan).any());
}

}  // namespace
}  // namespace felt::mend_joints_test
