#include "felt/tools/edge_ridges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/haptics/force_memory.h"

namespace felt::edge_ridges_test {
namespace {

constexpr Rect kPage{0.0, 0.0, 210.0, 297.0};
constexpr Rect kBox{100.0, 100.0, 140.0, 130.0};

/// A pen that moves over the page, with the force that the loop would evaluate.
struct Pen {
  EdgeRidges ridges;
  ForceMemory memory;
  std::int64_t time_ns = 0;

  Vec at(Point p, double z = -0.5) {
    PenSample sample;
    sample.time_ns = time_ns += 1'000'000;
    sample.position = {p.x, p.y, z};
    ridges.update(sample);
    memory.begin_tick(0.001);
    if (!ridges.force()) return {};
    const Force force = (*ridges.force())(sample, memory);
    return {force.x, force.y};
  }
  /// Rests until the force has risen.
  Vec rest_at(Point p) {
    Vec force{};
    for (int i = 0; i < 300; ++i) force = at(p);
    return force;
  }
};

TEST(EdgeRidges, AreOffAtFirst) {
  Pen pen;
  EXPECT_EQ(pen.rest_at({1.0, 100.0}), Vec{});
  EXPECT_FALSE(pen.ridges.force());
  pen.ridges.set({}, {});
  EXPECT_EQ(pen.rest_at({1.0, 100.0}), Vec{});
}

TEST(EdgeRidges, PushAwayFromTheEdgeOfThePageOnBothSides) {
  Pen pen;
  pen.ridges.set(kPage, {});
  EXPECT_GT(pen.rest_at({2.5, 100.0}).x, 0.1);
  EXPECT_LT(pen.rest_at({-2.5, 100.0}).x, -0.1);
  EXPECT_LT(pen.rest_at({207.5, 100.0}).x, -0.1);
  EXPECT_GT(pen.rest_at({100.0, 2.5}).y, 0.1);
  EXPECT_LT(pen.rest_at({100.0, 294.5}).y, -0.1);
  EXPECT_NEAR(pen.rest_at({2.5, 100.0}).y, 0.0, 1e-3);
  EXPECT_EQ(pen.rest_at({100.0, 150.0}), Vec{});
  EXPECT_FALSE(pen.ridges.force());
}

TEST(EdgeRidges, TheNearerEdgeActs) {
  Pen pen;
  pen.ridges.set(kPage, kBox);
  EXPECT_LT(pen.rest_at({97.0, 115.0}).x, -0.1);
  EXPECT_GT(pen.rest_at({103.0, 115.0}).x, 0.1);
  EXPECT_GT(pen.rest_at({2.5, 115.0}).x, 0.1);
  pen.ridges.set(kPage, {});
  EXPECT_EQ(pen.rest_at({97.0, 115.0}), Vec{});
}

// Wherever the pen lands, and whatever acts before, the force begins at zero and stays small.
TEST(EdgeRidges, BeginAtZeroAndStaySmall) {
  Pen pen;
  pen.ridges.set(kPage, kBox);
  pen.rest_at({3.0, 100.0});
  for (int i = 0; i < 2; ++i) pen.at({60.0, 100.0}, 3.0);  // lifts and goes elsewhere, quickly
  EXPECT_LT(norm(pen.at({97.0, 115.0})), 0.01);
  pen.rest_at({97.0, 115.0});
  pen.at({60.0, 115.0});
  EXPECT_LT(norm(pen.at({97.0, 115.0})), 0.01) << "the same edge again";
  pen.rest_at({97.0, 115.0});
  pen.ridges.set(kPage, {98.0, 100.0, 140.0, 130.0});  // the selection has changed
  EXPECT_LT(norm(pen.at({97.0, 115.0})), 0.01);
  for (double x = -10.0; x < 220.0; x += 0.05) {
    ASSERT_LE(norm(pen.at({x, 115.0})), 0.2 + 1e-9) << x;
  }
}

TEST(EdgeRidges, RectanglesThatAreTooSmallOrTooLargeHaveNone) {
  Pen pen;
  pen.ridges.set({0.0, 0.0, 0.1, 0.1}, {});
  EXPECT_EQ(pen.rest_at({1.0, 0.0}), Vec{});
  pen.ridges.set({0.0, 0.0, 1e6, 1e6}, {});
  EXPECT_EQ(pen.rest_at({1.0, 10.0}), Vec{});
  pen.ridges.set({10.0, 20.0, 60.0, 20.0}, {});  // a straight line is selected
  EXPECT_GT(pen.rest_at({30.0, 23.0}).y, 0.05);
}

}  // namespace
}  // namespace felt::edge_ridges_test
