#include "felt/replay/replay_stats.h"

#include <gtest/gtest.h>

namespace felt::replay_stats_test {
namespace {

Stroke line(Point from, Point to) {
  const Cubic c = straight(from, to);
  return Stroke::create({.points = {c.p.begin(), c.p.end()},
                         .joints = {},
                         .closed = false,
                         .widths = {{0.0, 1.0}, {1.0, 1.0}}})
      .value();
}

TEST(InkDistance, InkOnThePathIsAtNoDistance) {
  InkDistance distance;
  const std::vector<Point> meant = {{0, 0}, {5, 0}, {20, 0}};
  distance.add(meant, std::vector<Stroke>{line({0, 0}, {20, 0})});
  EXPECT_GT(distance.count(), 300);
  EXPECT_LT(distance.max_mm(), 1e-5);
}

TEST(InkDistance, InkBesideThePathIsAsFarAsItIs) {
  InkDistance distance;
  const std::vector<Point> meant = {{0, 0}, {20, 0}};
  distance.add(meant, std::vector<Stroke>{line({0, 0.5}, {20, 0.5})});
  EXPECT_NEAR(distance.mean_mm(), 0.5, 1e-5);
  EXPECT_NEAR(distance.p95_mm(), 0.5, 0.01);
  EXPECT_NEAR(distance.max_mm(), 0.5, 1e-5);
}

TEST(InkDistance, AMissingPartIsSeenAndSoIsADetour) {
  const std::vector<Point> meant = {{0, 0}, {20, 0}};
  InkDistance missing;
  missing.add(meant, std::vector<Stroke>{line({0, 0}, {15, 0})});
  EXPECT_NEAR(missing.max_mm(), 5.0, 1e-5);
  InkDistance detour;
  detour.add(meant, std::vector<Stroke>{line({0, 0}, {20, 0}), line({20, 0}, {20, 7})});
  EXPECT_NEAR(detour.max_mm(), 7.0, 1e-5);
}

TEST(InkDistance, ADotIsAPath) {
  InkDistance distance;
  distance.add(std::vector<Point>{{1, 1}}, std::vector<Stroke>{line({1, 1}, {1.2, 1})});
  EXPECT_NEAR(distance.max_mm(), 0.2, 1e-5);
  distance.add({}, std::vector<Stroke>{line({9, 9}, {10, 9})});
  EXPECT_NEAR(distance.max_mm(), 0.2, 1e-5);
}

}  // namespace
}  // namespace felt::replay_stats_test
