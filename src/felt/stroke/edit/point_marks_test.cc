#include "felt/stroke/edit/point_marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "felt/stroke/testing/random_stroke.h"

namespace felt::point_marks_test {
namespace {

using Marks = std::vector<std::uint8_t>;

/// Converts "110 100 1" to marks; blanks are ignored.
Marks marks_of(const std::string& text) {
  Marks marks;
  for (const char c : text) {
    if (c != ' ') marks.push_back(c == '1' ? 1 : 0);
  }
  return marks;
}

std::string text_of(const Marks& marks) {
  std::string text;
  for (const std::uint8_t m : marks) text += m ? '1' : '0';
  return text;
}

Marks closed_marks(const Stroke& stroke, Marks marks) {
  close_marks(stroke, marks);
  return marks;
}

/// Returns n segments of a wave along x, or of a ring if closed, with joints of this kind.
Stroke chain(int n, bool closed, JointKind kind) {
  StrokeData d;
  d.closed = closed;
  const double step = closed ? 2.0 * 3.14159265358979323846 / n : 1.0;
  const auto at = [&](int i) {
    return closed ? Point{10 * std::cos(step * (i % n)), 10 * std::sin(step * (i % n))}
                  : Point{10.0 * i, i % 2 == 0 ? 0.0 : 4.0};
  };
  const auto way = [&](int i) {
    return closed ? perp(at(i) - Point{}) / 3.0 / n * 4.0 : Vec{3.0, 0.0};
  };
  d.points.push_back(at(0));
  for (int i = 0; i < n; ++i) {
    d.points.insert(d.points.end(), {at(i) + way(i), at(i + 1) - way(i + 1), at(i + 1)});
  }
  d.joints.assign(static_cast<std::size_t>(closed ? n : n - 1), kind);
  d.widths = {{0.0, 1.0}, {static_cast<double>(n), 2.0}};
  return Stroke::create(std::move(d)).value();
}

/// Returns a random stroke. Every other closed stroke is also smooth at its seam.
Stroke any_stroke(std::uint64_t seed) {
  StrokeData d = testing::RandomStroke(seed).make();
  const std::size_t last = d.points.size() - 1;
  const Vec out = d.points[1] - d.points[0];
  if (d.closed && seed % 2 == 0 && norm(out) > 0.01 && last > 3) {
    StrokeData smooth = d;
    smooth.points[last - 1] = smooth.points[0] - 2.0 * normalized(out);
    smooth.joints.back() = JointKind::kSmooth;
    if (auto made = Stroke::create(std::move(smooth))) return *std::move(made);
  }
  return Stroke::create(std::move(d)).value();
}

Marks any_marks(testing::RandomStroke& random, std::size_t size) {
  Marks marks(size);
  const double density = random.uniform(0.05, 0.95);
  for (auto& m : marks) m = random.chance(density) ? 1 : 0;
  return marks;
}

Affine any_similarity(testing::RandomStroke& random) {
  const Point centre{random.uniform(-30, 50), random.uniform(-30, 50)};
  const Affine turn = rotation(random.uniform(-7, 7), centre);
  const Affine size = scaling(std::exp(random.uniform(-1.5, 1.5)), centre);
  const Affine move = translation({random.uniform(-40, 40), random.uniform(-40, 40)});
  return then(then(turn, size), move);
}

// ---- R32 ----

TEST(PointMarks, R32_SmoothJointsTakeTheirHandlesCornersDoNot) {
  const Stroke smooth = chain(3, false, JointKind::kSmooth);
  EXPECT_EQ(text_of(closed_marks(smooth, marks_of("000 100 000 0"))), "0011100000");
  EXPECT_EQ(text_of(closed_marks(smooth, marks_of("000 010 000 0"))), "0000100000");
  EXPECT_EQ(text_of(closed_marks(smooth, marks_of("100 000 000 0"))), "1000000000");
  // Both handles are marked: none is free to rotate, so the joint is marked too.
  EXPECT_EQ(text_of(closed_marks(smooth, marks_of("001 010 000 0"))), "0011100000");
  const Stroke sharp = chain(3, false, JointKind::kCorner);
  EXPECT_EQ(text_of(closed_marks(sharp, marks_of("001 110 000 0"))), "0011100000");
  EXPECT_EQ(text_of(closed_marks(sharp, marks_of("000 100 000 0"))), "0001000000");
}

TEST(PointMarks, R32_TheSeamOfAClosedStrokeCountsOnce) {
  const Stroke ring = chain(3, true, JointKind::kSmooth);
  EXPECT_EQ(text_of(closed_marks(ring, marks_of("100 000 000 0"))), "1100000011");
  EXPECT_EQ(text_of(closed_marks(ring, marks_of("000 000 000 1"))), "1100000011");
  const Stroke sharp = chain(3, true, JointKind::kCorner);
  EXPECT_EQ(text_of(closed_marks(sharp, marks_of("000 000 000 1"))), "1000000001");
}

TEST(PointMarks, R32_AStandingHandleIsItsJoint) {
  // The handle before joint 1 is zero: the joint's arm is the point before it.
  StrokeData d = chain(2, false, JointKind::kSmooth).data();
  d.points[2] = d.points[3];
  d.points[4] = d.points[3] + normalized(d.points[3] - d.points[1]);
  const Stroke stroke = Stroke::create(std::move(d)).value();
  EXPECT_EQ(text_of(closed_marks(stroke, marks_of("000 100 0"))), "0111100");
  EXPECT_EQ(text_of(closed_marks(stroke, marks_of("001 000 0"))), "0111100");
  // No handle is free to rotate: the joint is marked too.
  EXPECT_EQ(text_of(closed_marks(stroke, marks_of("000 010 0"))), "0111100");
  EXPECT_EQ(text_of(closed_marks(stroke, marks_of("010 000 0"))), "0100000");
}

/// Calls `visit` with random strokes, random marks, and the result of close_marks() for them.
template <class Visit>
void for_random_moves(int count, const Visit& visit) {
  for (int i = 0; i < count; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    testing::RandomStroke random(seed + 77'000);
    const Stroke stroke = any_stroke(seed);
    const Marks reported = any_marks(random, stroke.data().points.size());
    visit(seed, random, stroke, reported, closed_marks(stroke, reported));
  }
}

TEST(PointMarks, R32_ClosureIsAClosure) {
  for_random_moves(4000, [](std::uint64_t seed, auto&, const Stroke& stroke, const Marks& reported,
                            const Marks& closed) {
    for (std::size_t i = 0; i < reported.size(); ++i)
      ASSERT_LE(reported[i], closed[i]) << "seed " << seed;
    EXPECT_EQ(closed_marks(stroke, closed), closed) << "seed " << seed;
    const std::size_t n = closed.size() / 3;
    if (stroke.closed()) {
      EXPECT_EQ(closed.front(), closed.back()) << "seed " << seed;
    }
    for (std::size_t k = 0; k < stroke.data().joints.size(); ++k) {
      if (stroke.data().joints[k] != JointKind::kSmooth || !closed[3 * k + 3]) continue;
      EXPECT_TRUE(closed[3 * k + 2] && closed[3 * ((k + 1) % n) + 1]) << "seed " << seed;
    }
  });
}

TEST(PointMarks, R32_AnyLassoAndAnySimilarityKeepTheInvariants) {
  int moved = 0;
  for_random_moves(6000, [&](std::uint64_t seed, auto& random, const Stroke& stroke, const Marks&,
                             const Marks& marks) {
    const auto result = with_marked_moved(stroke, marks, any_similarity(random));
    if (!result) {
      // It fails only because of I5, if a segment became too short.
      EXPECT_EQ(result.error().message.substr(0, 2), "I5") << "seed " << seed;
      return;
    }
    ++moved;
    EXPECT_TRUE(check_invariants(result->data())) << "seed " << seed;
  });
  EXPECT_GT(moved, 5900);
}

TEST(PointMarks, R32_StretchingKeepsThemToo) {
  int moved = 0;
  for_random_moves(6000, [&](std::uint64_t seed, auto& random, const Stroke& stroke, const Marks&,
                             const Marks& marks) {
    const Point centre{random.uniform(0, 20), random.uniform(0, 20)};
    const Affine map =
        scaling(std::exp(random.uniform(-2.9, 2.9)), std::exp(random.uniform(-2.9, 2.9)), centre);
    const auto result = with_marked_moved(stroke, marks, map);
    if (!result) {
      EXPECT_EQ(result.error().message.substr(0, 2), "I5") << "seed " << seed;
      return;
    }
    ++moved;
  });
  EXPECT_GT(moved, 5500);
}

// ---- R33 ----

TEST(PointMarks, R33_UnmarkedJointsStayBitForBit) {
  for_random_moves(4000, [](std::uint64_t seed, auto& random, const Stroke& stroke, const Marks&,
                            const Marks& marks) {
    const Affine map = any_similarity(random);
    const auto result = with_marked_moved(stroke, marks, map);
    if (!result) return;
    const auto& before = stroke.data().points;
    const auto& after = result->data().points;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (marks[i]) {
        EXPECT_LE(distance(after[i], apply(map, before[i])), 1e-12) << "seed " << seed;
      } else if (i % 3 == 0) {
        EXPECT_EQ(after[i], before[i]) << "seed " << seed;
      } else {
        const std::size_t joint = i % 3 == 1 ? i - 1 : i + 1;
        EXPECT_NEAR(distance(after[i], before[joint]), distance(before[i], before[joint]), 1e-12)
            << "a handle that turns keeps its length, seed " << seed;
      }
    }
    EXPECT_EQ(result->data().joints, stroke.data().joints);
    EXPECT_EQ(result->data().widths, stroke.data().widths);
  });
}

TEST(PointMarks, R33_ThereAndBackIsWhereItWas) {
  double worst = 0.0;
  for_random_moves(6000, [&](std::uint64_t, auto& random, const Stroke& stroke, const Marks&,
                             const Marks& marks) {
    const Affine map = any_similarity(random);
    const auto there = with_marked_moved(stroke, marks, map);
    if (!there) return;
    const auto back = with_marked_moved(*there, marks, *inverse(map));
    ASSERT_TRUE(back);
    for (std::size_t i = 0; i < marks.size(); ++i) {
      worst = std::max(worst, distance(back->data().points[i], stroke.data().points[i]));
    }
  });
  EXPECT_LE(worst, 1e-9);
}

TEST(PointMarks, R33_AMarkedHandleTurnsTheOneAcross) {
  const Stroke stroke = chain(2, false, JointKind::kSmooth);  // joint at (10, 4), handles 3 mm
  const Marks marks = marks_of("000 010 0");
  const auto result = with_marked_moved(stroke, marks, translation({-3.0, 5.0}));
  ASSERT_TRUE(result);
  EXPECT_EQ(result->data().points[4], (Point{10, 9}));
  EXPECT_LE(distance(result->data().points[2], Point{10, 1}), 1e-12);
  EXPECT_EQ(result->data().points[1], stroke.data().points[1]);
}

TEST(PointMarks, R33_WhatCannotBeIsRefused) {
  const Stroke stroke = chain(2, false, JointKind::kSmooth);
  const Marks all(7, 1);
  EXPECT_FALSE(with_marked_moved(stroke, all, scaling(1e-4)));
  EXPECT_FALSE(with_marked_moved(stroke, all, translation({std::nan(""), 0})));
  EXPECT_FALSE(with_marked_moved(stroke, Marks(6, 1), translation({1, 0})));
  EXPECT_EQ(*with_marked_moved(stroke, Marks(7, 0), translation({1, 0})), stroke);
}

// ---- widths ----

TEST(PointMarks, WidthsScaleBetweenMarkedJointsAndFadeNextToThem) {
  const Stroke stroke = chain(4, false, JointKind::kSmooth);  // 1 to 2 mm over u = 0..4
  const Marks marks = closed_marks(stroke, marks_of("100 100 000 000 0"));
  const Stroke scaled = with_marked_moved(stroke, marks, translation({0, 0}), 3.0).value();
  for (const double u : {0.0, 0.25, 0.8, 1.0}) {
    EXPECT_NEAR(scaled.width_mm(u), 3.0 * stroke.width_mm(u), 1e-12) << u;
  }
  for (const double u : {2.0, 2.5, 4.0}) {
    EXPECT_NEAR(scaled.width_mm(u), stroke.width_mm(u), 1e-12) << u;
  }
  EXPECT_GT(scaled.width_mm(1.5), stroke.width_mm(1.5));
  EXPECT_LT(scaled.width_mm(1.5), 3.0 * stroke.width_mm(1.5));
  EXPECT_EQ(scaled.data().points, stroke.data().points);

  const Stroke back = with_marked_moved(scaled, marks, translation({0, 0}), 1.0 / 3.0).value();
  for (double u = 0.0; u <= 4.0; u += 0.125) {
    EXPECT_NEAR(back.width_mm(u), stroke.width_mm(u), 1e-12) << u;
  }
}

TEST(PointMarks, WidthsKeepToTheirLimits) {
  const Stroke stroke = chain(2, false, JointKind::kSmooth);
  const Marks all(7, 1);
  const Affine stay = translation({0, 0});
  EXPECT_EQ(with_marked_moved(stroke, all, stay, 1e-3)->width_mm(1.0), kMinWidthMm);
  EXPECT_EQ(with_marked_moved(stroke, all, stay, 1e3)->width_mm(1.0), kMaxScaledWidthMm);
  StrokeData broad = stroke.data();
  for (WidthKnot& k : broad.widths) k.width_mm = 80.0;
  const Stroke import = Stroke::create(std::move(broad)).value();
  EXPECT_EQ(with_marked_moved(import, all, stay, 2.0)->width_mm(1.0), 80.0);
}

// ---- R34 ----

TEST(PointMarks, R34_AnchorsAreTheFirstUnmarkedOnCurvePointsEachWay) {
  struct Case {
    const char* what;
    int segments;
    bool closed;
    const char* marks;
    std::vector<std::size_t> anchors;
  };
  const Case cases[] = {
      {"open, in the middle", 4, false, "000 001 110 000 0", {3, 9}},
      {"open, from the start", 3, false, "111 110 000 0", {6}},
      {"open, to the end", 3, false, "000 001 111 1", {3}},
      {"open, all", 2, false, "111 111 1", {}},
      {"open, none", 2, false, "000 000 0", {}},
      {"open, a handle only", 2, false, "010 000 0", {0, 3}},
      {"open, two runs with a joint between, which counts twice",
       3,
       false,
       "110 001 111 1",
       {3, 3}},
      {"open, two runs apart", 5, false, "110 000 000 000 011 1", {3, 12}},
      {"closed, in the middle", 4, true, "000 001 110 000 0", {3, 9}},
      {"closed, over the seam", 4, true, "110 000 000 001 1", {3, 9}},
      {"closed, all but one joint, which counts twice", 3, true, "111 011 111 1", {3, 3}},
      {"closed, all", 3, true, "111 111 111 1", {}},
      {"closed, a handle beside the seam", 2, true, "010 000 0", {0, 3}},
      {"open, every joint but no handle", 2, false, "100 100 1", {}},
  };
  for (const Case& c : cases) {
    const Stroke stroke = chain(c.segments, c.closed, JointKind::kCorner);
    std::vector<std::size_t> found = anchors(stroke, marks_of(c.marks));
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, c.anchors) << c.what;
  }
}

TEST(PointMarks, R34_AnchorsAreAsAWalkFindsThem) {
  for_random_moves(
      3000, [](std::uint64_t seed, auto&, const Stroke& stroke, const Marks&, const Marks& marks) {
        const int m = static_cast<int>(marks.size()) - (stroke.closed() ? 1 : 0);
        std::vector<std::size_t> expected;
        const auto walk = [&](int from, int step) {
          for (int i = 1; i <= m; ++i) {
            const int at = stroke.closed() ? (from + step * i + m * m) % m : from + step * i;
            if (at < 0 || at >= m) return;
            if (i == 1 && marks[static_cast<std::size_t>(at)]) return;  // the run does not end here
            if (at % 3 == 0 && !marks[static_cast<std::size_t>(at)]) {
              expected.push_back(static_cast<std::size_t>(at));
              return;
            }
          }
        };
        for (int i = 0; i < m; ++i) {
          if (!marks[static_cast<std::size_t>(i)]) continue;
          walk(i, 1);
          walk(i, -1);
        }
        std::vector<std::size_t> found = anchors(stroke, marks);
        std::sort(found.begin(), found.end());
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(found, expected) << "seed " << seed << ": " << text_of(marks);
      });
}

}  // namespace
}  // namespace felt::point_marks_test
