#include "felt/tools/choice_ring.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "felt/base/constants.h"

namespace felt::choice_ring_test {
namespace {

constexpr Point kMiddle{50.0, 60.0};
constexpr double kRadius = 16.0;

/// The page is upright: y points down.
ChoiceRing upright(double radius_mm = kRadius) {
  return {kMiddle, {0.0, -radius_mm}, {radius_mm, 0.0}};
}

/// A point at this distance and angle, clockwise from the top.
Point at(double mm, double degrees) {
  const double a = degrees / 360.0 * kTau;
  return kMiddle + mm * Vec{std::sin(a), -std::cos(a)};
}

TEST(ChoiceRing, ADirectionChoosesAtAnyDistanceBeyondTheMiddle) {
  for (std::size_t i = 0; i < ChoiceRing::kWells; ++i) {
    for (const double off : {-22.0, 0.0, 22.0}) {
      for (const double mm : {5.7, kRadius, 200.0}) {
        ChoiceRing ring = upright();
        ring.move(at(mm, 45.0 * double(i) + off));
        ASSERT_EQ(ring.chosen(), i) << off << ' ' << mm;
      }
    }
  }
}

TEST(ChoiceRing, TheMiddleChoosesNothing) {
  ChoiceRing ring = upright();
  EXPECT_FALSE(ring.chosen());
  ring.move(at(kRadius, 90.0));
  EXPECT_EQ(ring.chosen(), 2u);
  ring.move(at(5.5, 90.0));
  EXPECT_FALSE(ring.chosen());
  ring.choose(3);
  ring.move({std::numeric_limits<double>::quiet_NaN(), 0.0});
  EXPECT_FALSE(ring.chosen());
}

TEST(ChoiceRing, AChoiceStaysUntilThePenIsClearlyBeyondTheRidge) {
  ChoiceRing ring = upright();
  ring.move(at(kRadius, 340.0));
  EXPECT_EQ(ring.chosen(), 0u);
  ring.move(at(kRadius, 335.5));  // the ridge is at 337.5 degrees
  EXPECT_EQ(ring.chosen(), 0u);
  ring.move(at(kRadius, 332.0));
  EXPECT_EQ(ring.chosen(), 7u);
  ring.move(at(kRadius, 339.5));
  EXPECT_EQ(ring.chosen(), 7u);
  ring.move(at(kRadius, 343.0));
  EXPECT_EQ(ring.chosen(), 0u);
}

TEST(ChoiceRing, FollowsATurnedAndMirroredPage) {
  ChoiceRing ring(kMiddle, {kRadius, 0.0}, {0.0, -kRadius});  // up is +x, right is -y
  ring.move(kMiddle + Vec{10.0, 0.0});
  EXPECT_EQ(ring.chosen(), 0u);
  ring.move(kMiddle + Vec{0.0, -10.0});
  EXPECT_EQ(ring.chosen(), 2u);
  EXPECT_NEAR(distance(ring.well(2), kMiddle + Vec{0.0, -kRadius}), 0.0, 1e-9);
}

// The force is zero where the choice changes, so it never jumps; and no two wells act together.
TEST(ChoiceRing, NoForceActsWhereTheChoiceChanges) {
  for (const double radius : {4.0, 8.0, 16.0, 40.0}) {
    ChoiceRing ring = upright(radius);
    ring.move(at(radius, 0.0));
    const Guide well = ring_guide(ring);
    EXPECT_GT(well.pull_n(at(radius, 5.0)), 0.0);
    EXPECT_EQ(well.pull_n(at(radius * ChoiceRing::kMiddle, 0.0)), 0.0);
    for (const double share : {0.5, 0.92, 1.0, 1.1}) {
      EXPECT_EQ(well.pull_n(at(radius * share, 22.5)), 0.0) << radius << ' ' << share;
      EXPECT_EQ(well.pull_n(at(radius * share, -26.6)), 0.0) << radius << ' ' << share;
    }
  }
}

TEST(ChoiceRing, ItsForcesAreSmallAndItsStiffnessIsBounded) {
  for (const double radius : {0.0, 1.0, 4.0, 8.0, 16.0, 40.0}) {
    const GuideLaw law = ring_law(radius);
    EXPECT_LE(law.well.force_n, 0.5);
    EXPECT_LE(law.well.core_slope_n_per_m(), 250.0 + 1e-9);
    ChoiceRing ring = upright(radius);
    EXPECT_EQ(ring_guide(ring).slopes().lateral_n_per_m, 0.0);
    ring.choose(4);
    const ForceModel model = ring_force(ring, surface_materials()[0], Capabilities{});
    EXPECT_LE(model.slopes().lateral_n_per_m, 250.0 + 1e-9);
  }
}

// Another well begins without force and fades in, also if a key chooses it under the pen.
TEST(ChoiceRing, AnotherWellFadesIn) {
  ChoiceRing ring = upright();
  ring.choose(0);
  const auto hold = ring_guide(ring).piece().hold;
  const auto model = [&ring] { return ring_force(ring, surface_materials()[0], Capabilities{}); };
  const std::uint32_t fade = model().fade_id();
  EXPECT_EQ(model().fade_id(), fade);
  ring.choose(1);
  EXPECT_NE(ring_guide(ring).piece().hold, hold);
  EXPECT_NE(model().fade_id(), fade);
}

}  // namespace
}  // namespace felt::choice_ring_test
