#include "felt/solid/mirror_axes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "felt/base/random.h"
#include "felt/solid/testing/solid_drawings.h"

namespace felt::mirror_axes_test {
namespace {

using Curves = std::vector<std::vector<Cubic>>;

std::vector<Cubic> curve_of(const Stroke& stroke) {
  std::vector<Cubic> curve;
  for (int i = 0; i < stroke.segment_count(); ++i) curve.push_back(stroke.segment(i));
  return curve;
}

std::vector<Cubic> polygon(int corners, double turn_rad, Point centre) {
  std::vector<Cubic> curve;
  const auto at = [&](int k) {
    const double a = turn_rad + 2.0 * std::numbers::pi * (k % corners) / corners;
    return centre + 20.0 * Vec{std::cos(a), std::sin(a)};
  };
  for (int k = 0; k < corners; ++k) curve.push_back(straight(at(k), at(k + 1)));
  return curve;
}

MirrorAxes axes_of(const Curves& curves) {
  const RingSpec spec;
  std::vector<Ring> rings;
  for (const auto& curve : curves) rings.push_back(fine_ring(curve, spec));
  return find_mirror_axes(curves, rings, 0.005);
}

TEST(MirrorAxes, RegularPolygonsHaveAsManyAsCorners) {
  for (int corners = 3; corners <= 12; ++corners) {
    SCOPED_TRACE(corners);
    const double turn = 0.1 * corners;
    const MirrorAxes axes = axes_of({polygon(corners, turn, {30, 40})});
    EXPECT_EQ(axes.count, corners);
    EXPECT_NEAR(distance(axes.centre, {30, 40}), 0.0, 1e-9);
    // One of the axes goes through the first corner.
    const double steps = (axes.angle_rad - turn) / (std::numbers::pi / corners);
    EXPECT_NEAR(steps, std::round(steps), 1e-7);
  }
}

TEST(MirrorAxes, ARectangleHasTwoAndAnUprightOneIsChosen) {
  const MirrorAxes axes = axes_of({{straight({0, 0}, {40, 0}), straight({40, 0}, {40, 10}),
                                    straight({40, 10}, {0, 10}), straight({0, 10}, {0, 0})}});
  EXPECT_EQ(axes.count, 2);
  EXPECT_NEAR(std::fabs(std::sin(axes.angle_rad)), 1.0, 1e-12);
}

TEST(MirrorAxes, AHoleBesideTheMiddleLeavesOneAxis) {
  const auto big = curve_of(*testing::MapDrawing::circle_stroke({50, 50}, 30.0));
  const auto hole = curve_of(*testing::MapDrawing::circle_stroke({60, 50}, 5.0));
  const MirrorAxes axes = axes_of({big, hole});
  EXPECT_EQ(axes.count, 1);
  EXPECT_NEAR(std::sin(axes.angle_rad), 0.0, 1e-9);
  EXPECT_NEAR(axes.centre.y, 50.0, 1e-9);
}

TEST(MirrorAxes, LumpsHaveNone) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const auto at = testing::lumps(random, {50, 50}, 30.0, 11, 0.5);
    const auto curve = curve_of(*testing::stroke_of(testing::smooth_ring(at), true));
    EXPECT_EQ(axes_of({curve}).count, 0) << seed;
  }
}

}  // namespace
}  // namespace felt::mirror_axes_test
