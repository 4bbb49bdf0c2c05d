#include "felt/stroke/edit/corner_trips.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "felt/stroke/edit/split.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::corner_trips_test {
namespace {

/// Writes the points and widths of a stroke whose widths may jump at joints.
class JumpingLine {
 public:
  explicit JumpingLine(Point start) { data_.points.push_back(start); }

  /// Adds a straight segment with these widths at its ends.
  void to(Point end, double begin_mm, double end_mm) {
    const Cubic c = straight(data_.points.back(), end);
    data_.points.insert(data_.points.end(), c.p.begin() + 1, c.p.end());
    const double u = static_cast<double>(data_.points.size() / 3) - 1.0;
    const double jump_u = data_.widths.empty() ? 0.0 : 1e-4;
    data_.widths.push_back({u + jump_u, begin_mm});
    data_.widths.push_back({u + 1.0, end_mm});
    if (u > 0.0) data_.joints.push_back(JointKind::kCorner);
  }
  /// Adds a trip into a corner, which returns as a thin line.
  void trip(Point tip, double width_mm) {
    const Point base = data_.points.back();
    to(tip, width_mm, 0.05);
    to(base, 0.06, 0.06);
  }
  [[nodiscard]] Stroke closed() {
    data_.closed = true;
    data_.points.back() = data_.points.front();
    data_.joints.push_back(JointKind::kCorner);
    return Stroke::create(data_).value();
  }
  [[nodiscard]] Stroke open() const { return Stroke::create(data_).value(); }

 private:
  StrokeData data_;
};

/// A line along the x axis from 0 to 44 with two flat ends, which a file writes with trips.
Stroke line_with_flat_ends(double last_width_mm) {
  JumpingLine line({4, 0});
  line.trip({0.025, 3.975}, 8.0);
  line.trip({0.025, -3.975}, 8.0);
  line.to({20, 0}, 8.0, 8.0);
  line.trip({21, 5}, 8.0);
  line.to({40, 0}, 8.0, last_width_mm);
  line.trip({43.975, 3.975}, last_width_mm);
  line.trip({43.975, -3.975}, last_width_mm);
  return line.open();
}

TEST(CornerTrips, FlatEndsAndPointedCornersGo) {
  for (const bool is_reversed : {false, true}) {
    const Stroke with = line_with_flat_ends(6.0);
    const std::optional<Stroke> plain = without_corner_trips(is_reversed ? reversed(with) : with);
    ASSERT_TRUE(plain);
    const Stroke line = is_reversed ? reversed(*plain) : *plain;
    ASSERT_EQ(line.segment_count(), 2);
    EXPECT_LT(distance(line.position(0.0), {0, 0}), 1e-9);
    EXPECT_EQ(line.position(1.0), (Point{20, 0}));
    EXPECT_LT(distance(line.position(2.0), {44, 0}), 1e-9);
    EXPECT_EQ(line.joint(1), JointKind::kCorner);
    for (const auto& [u, width_mm] : {std::pair(0.0, 8.0), std::pair(0.5, 8.0), std::pair(1.0, 8.0),
                                      std::pair(1.5, 7.0), std::pair(2.0, 6.0)}) {
      EXPECT_NEAR(line.width_mm(u), width_mm, 0.01) << u;
    }
  }
}

TEST(CornerTrips, AClosedLineKeepsItsSidesAndCorners) {
  JumpingLine line({0, 0});
  const Point corners[] = {{60, 0}, {60, 50}, {0, 50}, {0, 0}};
  for (const Point corner : corners) {
    line.to(corner, 2.0, 2.0);
    line.trip(corner + Vec{corner.x > 0 ? 0.9 : -0.9, corner.y > 0 ? 0.9 : -0.9}, 2.0);
  }
  const std::optional<Stroke> plain = without_corner_trips(line.closed());
  ASSERT_TRUE(plain);
  EXPECT_TRUE(plain->closed());
  ASSERT_EQ(plain->segment_count(), 4);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(plain->segment(i).p[3], corners[i]);
    EXPECT_NEAR(plain->width_mm(i + 0.5), 2.0, 0.01);
  }
}

TEST(CornerTrips, ALineThatReturnsAlongItselfIsDrawnTwice) {
  JumpingLine line({0, 0});
  line.to({30, 0}, 2.0, 2.0);
  line.to({0, 0}, 2.0, 2.0);
  EXPECT_FALSE(is_corner_trip(line.open(), 0));
  EXPECT_FALSE(without_corner_trips(line.open()));
}

TEST(CornerTrips, WhatIsOnlyATripStays) {
  JumpingLine line({0, 0});
  line.trip({5, 0}, 2.0);
  EXPECT_TRUE(is_corner_trip(line.open(), 0));
  EXPECT_FALSE(without_corner_trips(line.open()));
}

TEST(CornerTrips, ALongWayThatNarrowsIsALine) {
  JumpingLine line({0, 0});
  line.to({30, 0}, 2.0, 0.5);
  line.to({0, 0}, 0.5, 2.0);
  line.to({0, 30}, 2.0, 2.0);
  EXPECT_FALSE(has_corner_trips(line.open()));
}

TEST(CornerTrips, AnAlmostStraightLineWithFlatEndsKeepsItsShape) {
  JumpingLine line({4, 0});
  line.trip({0.025, 3.975}, 8.0);
  line.trip({0.025, -3.975}, 8.0);
  StrokeData data = line.open().data();
  const Point from = data.points.back();
  for (const Point p : {from + Vec{10, 0.0005}, from + Vec{20, 0.0005}, from + Vec{30, 0},
                        from + Vec{40, -0.0005}, from + Vec{50, -3}, from + Vec{60, -6}}) {
    data.points.push_back(p);
  }
  data.joints.push_back(JointKind::kCorner);
  data.joints.push_back(JointKind::kSmooth);
  data.widths.push_back({4.0001, 8.0});
  data.widths.push_back({6.0, 8.0});
  const std::optional<Stroke> plain = without_corner_trips(Stroke::create(data).value());
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->segment_count(), 2);
  EXPECT_EQ(plain->joint(1), JointKind::kSmooth);
  EXPECT_LT(distance(plain->position(0.0), {0, 0}), 1e-9);
}

/// A stroke may have a million segments and breakpoints.
TEST(CornerTrips, TheWorkDoesNotGrowWithTheSquareOfTheSegments) {
  JumpingLine line({0, 0});
  for (int i = 0; i < 100'000; ++i) line.to({i + 1.0, i % 2 * 1.0}, 0.5, 0.5);
  line.trip({100'001, 0}, 0.5);
  const std::optional<Stroke> plain = without_corner_trips(line.open());
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->segment_count(), 100'000);
}

RC_GTEST_PROP(CornerTrips, DrawnStrokesHaveNone, (std::uint32_t seed)) {
  const Stroke drawn = Stroke::create(::felt::testing::RandomStroke(seed).make()).value();
  RC_ASSERT(!without_corner_trips(drawn));
}

}  // namespace
}  // namespace felt::corner_trips_test
