#include "felt/solid/cut_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "felt/solid/body_parts.h"
#include "felt/solid/testing/random_bodies.h"
#include "felt/solid/testing/surface.h"
#include "felt/solid/view_frame.h"

namespace felt::cut_body_test {
namespace {

using Parts = std::optional<std::vector<SolidBody>>;

constexpr Vec3 kFromFront{0.0, 0.0, -1.0};

double volume_of(const std::vector<SolidBody>& parts) {
  double sum = 0.0;
  for (const SolidBody& part : parts) sum += volume_mm3(part);
  return sum;
}

void expect_closed(const std::vector<SolidBody>& parts) {
  for (const SolidBody& part : parts) {
    const testing::SurfaceReport report = testing::examine(testing::surface_of(part));
    EXPECT_EQ(report.fault, "");
    EXPECT_EQ(report.components, 1U);
    EXPECT_EQ(report.euler, 2 - 2 * part.holes);
    EXPECT_TRUE(check_body(part, {}));
  }
}

std::vector<Vec3> reversed(std::vector<Vec3> path) {
  std::reverse(path.begin(), path.end());
  return path;
}

TEST(CutBody, RemovesThePartAtTheLeftOfTheStroke) {
  const SolidBody ball = testing::ball(20.0);
  // Upwards: the left half goes, and the right half of the ball stays.
  const std::vector<Vec3> up{{0, -30, 0}, {0, 30, 0}};
  const Result<Parts> half = cut_body(ball, up, kFromFront);
  ASSERT_TRUE(half && *half);
  ASSERT_EQ((*half)->size(), 1U);
  expect_closed(**half);
  EXPECT_NEAR(volume_of(**half), 0.5 * volume_mm3(ball), 0.01 * volume_mm3(ball));
  const double tolerance = 2e-3 * mean_edge_mm(ball);
  for (const Vec3& p : (*half)->front().points) EXPECT_GE(p.x, -tolerance);
  EXPECT_EQ((*half)->front().stroke, ball.stroke);
  EXPECT_EQ((*half)->front().color, ball.color);
}

TEST(CutBody, TheNewFaceLiesOnTheSweptStroke) {
  const SolidBody ball = testing::ball(20.0);
  const Result<Parts> half = cut_body(ball, std::vector<Vec3>{{5, -30, 0}, {5, 30, 0}}, kFromFront);
  ASSERT_TRUE(half && *half);
  double area = 0.0;  // of the triangles in the plane x = 5
  const double tolerance = 2e-3 * mean_edge_mm(ball);
  const SolidBody& body = (*half)->front();
  for (const auto& [a, b, c] : body.triangles) {
    const Vec3 &p = body.points[a], &q = body.points[b], &r = body.points[c];
    if (std::max({std::fabs(p.x - 5), std::fabs(q.x - 5), std::fabs(r.x - 5)}) > tolerance)
      continue;
    area += 0.5 * norm(cross(q - p, r - p));
  }
  EXPECT_NEAR(area, std::numbers::pi * (400 - 25), 0.02 * std::numbers::pi * 375);
}

TEST(CutBody, AStrokeBesideTheBodyChangesNothing) {
  const SolidBody ball = testing::ball(20.0);
  const Result<Parts> same =
      cut_body(ball, std::vector<Vec3>{{25, -30, 0}, {25, 30, 0}}, kFromFront);
  ASSERT_TRUE(same);
  EXPECT_FALSE(*same);
}

TEST(CutBody, RefusesAStrokeThatEndsOnTheBodyOrCrossesItself) {
  const SolidBody ball = testing::ball(20.0);
  const auto error = [&](const std::vector<Vec3>& path) {
    const Result<Parts> result = cut_body(ball, path, kFromFront);
    return result ? "" : result.error().message;
  };
  EXPECT_EQ(error({{0, -30, 0}, {0, 5, 0}}), "the stroke ends on the body");
  EXPECT_EQ(error({{0, 5, 0}, {0, 30, 0}}), "the stroke begins on the body");
  EXPECT_EQ(error({{-30, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {0, -30, 0}}),
            "the stroke crosses itself");
  EXPECT_EQ(error({{0, 0, 0}}), "the stroke has no length");
}

// A drawing with two arms: the stroke crosses one, and the other lies in the same direction.
/// The strokes of a file can be far longer than those of a hand.
TEST(CutBody, RefusesAStrokeThatNeedsTooManyPoints) {
  const SolidBody ball = testing::ball(20.0);
  std::vector<Vec3> zigzag;
  for (int i = 0; i < 20'000; ++i) zigzag.push_back({i % 2 ? 1e6 : -1e6, i - 1e4, 0.0});
  const Result<Parts> parts = cut_body(ball, zigzag, kFromFront);
  ASSERT_FALSE(parts);
  EXPECT_EQ(parts.error().message, "the stroke is too long");
}

TEST(CutBody, CutsOnlyWhatTheStrokeCrosses) {
  testing::SolidDrawing drawing;
  drawing.polygon({{0, 0}, {10, 0}, {10, 30}, {30, 30}, {30, 0}, {40, 0}, {40, 45}, {0, 45}});
  const Result<InflatedDrawing> u = inflate(drawing.document, {.triangles = 2000});
  ASSERT_TRUE(u);
  const SolidBody& body = u->solid.bodies.front();
  // From right to left across the right arm (x from 10 to 20 in the frame of the body): the left of
  // it is below, but below is the rest of the body.
  const std::vector<Vec3> across{{14, 15, 0}, {2, 15, 0}};
  const std::vector<Vec3> outwards{{2, 15, 0}, {25, 15, 0}};
  const Result<Parts> tip = cut_body(body, outwards, kFromFront);
  ASSERT_TRUE(tip && *tip) << tip.error().message;
  expect_closed(**tip);
  ASSERT_EQ((*tip)->size(), 1U) << "the other arm is still there";
  double left_top = -100.0, right_top = -100.0;
  for (const Vec3& p : (*tip)->front().points) {
    double& top = p.x < 0.0 ? left_top : right_top;
    top = std::max(top, p.y);
  }
  EXPECT_GT(left_top, 20.0);
  EXPECT_LT(right_top, 15.1);
  const Result<Parts> arm = cut_body(body, reversed(outwards), kFromFront);
  ASSERT_TRUE(arm && *arm) << arm.error().message;
  EXPECT_NEAR(volume_of(**tip) + volume_of(**arm), volume_mm3(body), 1e-3 * volume_mm3(body));
  EXPECT_FALSE(cut_body(body, across, kFromFront)) << "the stroke begins on the arm";
}

TEST(CutBody, AStrokeIntoAHoleCutsNothingOff) {
  testing::SolidDrawing drawing;
  drawing.circle({0, 0}, 30.0);
  drawing.circle({0, 0}, 12.0);
  const Result<InflatedDrawing> ring = inflate(drawing.document, {.triangles = 2000});
  ASSERT_TRUE(ring);
  const Result<Parts> cut =
      cut_body(ring->solid.bodies.front(), std::vector<Vec3>{{40, 0, 0}, {0, 0, 0}}, kFromFront);
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().message, "the stroke does not cut off a part of the body");
  const Result<Parts> through =
      cut_body(ring->solid.bodies.front(), std::vector<Vec3>{{40, 0, 0}, {-40, 0, 0}}, kFromFront);
  ASSERT_TRUE(through && *through) << through.error().message;
  EXPECT_EQ((*through)->front().holes, 0) << "half a ring has no hole";
}

/// Cuts a body several times, and returns the part with the largest volume each time.
SolidBody cut_in_turn(SolidBody body, const std::vector<std::vector<Vec3>>& strokes) {
  for (const std::vector<Vec3>& stroke : strokes) {
    Result<Parts> parts = cut_body(body, stroke, kFromFront);
    EXPECT_TRUE(parts && *parts) << (parts ? "misses" : parts.error().message);
    if (!parts || !*parts) return body;
    expect_closed(**parts);
    body = *std::max_element((*parts)->begin(), (*parts)->end(), [](const auto& a, const auto& b) {
      return volume_mm3(a) < volume_mm3(b);
    });
  }
  return body;
}

TEST(CutBody, TheSameCutAgainChangesNothing) {
  std::vector<Vec3> wave;
  for (int i = -30; i <= 30; ++i) wave.push_back({3.0 + 2.0 * std::sin(i / 4.0), 1.0 * i, 0.0});
  const std::vector<Vec3> axis{{0, -30, 0}, {0, 30, 0}}, slanted{{-17, -30, 3}, {19, 30, 2}};
  for (const std::vector<Vec3>& stroke : {wave, axis, slanted}) {
    const SolidBody once = cut_in_turn(testing::ball(20.0), {stroke});
    const SolidBody again = cut_in_turn(once, {stroke, stroke, stroke});
    EXPECT_EQ(once.points, again.points);
    EXPECT_EQ(once.triangles, again.triangles);
    const Result<Parts> other_way = cut_body(once, reversed(stroke), kFromFront);
    ASSERT_FALSE(other_way);
    EXPECT_EQ(other_way.error().message, "nothing of the body would remain");
  }
}

// The faces of two cuts lie in one plane, on a part of their length.
TEST(CutBody, CutsThatShareAPartOfTheirStrokesAreClosed) {
  std::vector<std::vector<Vec3>> strokes;
  for (int i = 0; i < 4; ++i) {
    const double end = (i % 2 ? -1.0 : 1.0) * (2.0 + i);
    strokes.push_back({{-30, 0, 0}, {0, 0, 0}, {30, end, 0}});
  }
  const SolidBody rest = cut_in_turn(testing::ball(20.0), strokes);
  EXPECT_GT(volume_mm3(rest), 0.4 * 4.0 / 3.0 * std::numbers::pi * 8000.0);
  EXPECT_LT(volume_mm3(rest), 0.5 * 4.0 / 3.0 * std::numbers::pi * 8000.0);
}

// Many small cuts around a ball: each makes about as many triangles as the first.
TEST(CutBody, TheSizeOfABodyGrowsInProportionToItsCuts) {
  const auto around = [](int count) {
    std::vector<std::vector<Vec3>> strokes;
    for (int i = 0; i < count; ++i) {
      const double a = 2.0 * std::numbers::pi * i / count;
      const Vec3 middle{19.0 * std::cos(a), 19.0 * std::sin(a), 0.0};
      const Vec3 along{-std::sin(a), std::cos(a), 0.0};
      strokes.push_back({middle + 9.0 * along, middle - 9.0 * along});
    }
    return strokes;
  };
  const SolidBody ball = testing::ball(20.0);
  const auto added = [&](int count) {
    return static_cast<double>(cut_in_turn(ball, around(count)).triangles.size()) -
           static_cast<double>(ball.triangles.size());
  };
  const double of_one = std::max(added(1), 50.0);
  EXPECT_LT(added(6), 6.0 * 3.0 * of_one);
  EXPECT_LT(added(24), 24.0 * 3.0 * of_one);
}

// Wavy strokes in random directions over random bodies: what remains on both sides of the stroke is
// the whole body.
TEST(CutBody, R60_BothSidesOfAStrokeAreTheWholeBody) {
  int refused = 0, cuts = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    const SolidBody body = testing::random_body(random, 1500);
    const ViewFrame frame = view_frame(testing::random_direction(random));
    const double turn = random.between(0.0, 2.0 * std::numbers::pi);
    const Vec along{std::cos(turn), std::sin(turn)};
    const Point middle = Point{} + random.between(-15.0, 15.0) * perp(along);
    const double wave = random.between(0.0, 4.0), length = random.between(5.0, 30.0);
    std::vector<Vec3> path;
    for (int i = -90; i <= 90; ++i) {
      const Point p =
          middle + static_cast<double>(i) * along + wave * std::sin(i / length) * perp(along);
      path.push_back(frame.to_solid(p, random.between(-1.0, 1.0)));
    }
    const Result<Parts> right = cut_body(body, path, -1.0 * frame.towards);
    const Result<Parts> left = cut_body(body, reversed(path), -1.0 * frame.towards);
    const Result<Parts> again = cut_body(body, path, -1.0 * frame.towards);
    if (!right || !left) {
      ++refused;
      std::printf("seed %d: %s\n", static_cast<int>(seed),
                  (right ? left : right).error().message.c_str());
      continue;
    }
    ASSERT_EQ(right->has_value(), left->has_value()) << "seed " << seed;
    if (!*right) continue;
    ++cuts;
    expect_closed(**right);
    expect_closed(**left);
    EXPECT_NEAR(volume_of(**right) + volume_of(**left), volume_mm3(body), 1e-3 * volume_mm3(body))
        << "seed " << seed;
    ASSERT_EQ((*again)->size(), (*right)->size());
    for (std::size_t i = 0; i < (*right)->size(); ++i) {
      EXPECT_EQ((*again)->at(i).points, (*right)->at(i).points) << "seed " << seed;
      EXPECT_EQ((*again)->at(i).triangles, (*right)->at(i).triangles) << "seed " << seed;
    }
  }
  EXPECT_LE(refused, 1);
  EXPECT_GE(cuts, 20);
}

}  // namespace
}  // namespace felt::cut_body_test
