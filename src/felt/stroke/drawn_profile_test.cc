#include "felt/stroke/drawn_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "felt/stroke/outline/outline.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::drawn_profile_test {
namespace {

/// The profile at a point of a piece; the slopes are per mm.
struct End {
  double radius_mm, tone, slope, tone_slope, speed_mm;
};

/// Returns the profile at x, 0..1, of a piece.
End end_of(const Stroke& s, const DrawnPiece& piece, double x) {
  const WidthKnot &a = s.widths()[piece.knot], &b = s.widths()[piece.knot + 1];
  const double part = (piece.t1 - piece.t0) / (b.u - a.u);
  const double u = piece.segment + piece.t0 + x * (piece.t1 - piece.t0);
  const double speed =
      norm(derivative(s.segment(piece.segment), u - piece.segment)) * (piece.t1 - piece.t0);
  return {0.5 * s.width_mm(u) + piece.radius_mm.at(x), s.tone(u) + piece.tone.at(x),
          (0.5 * (b.width_mm - a.width_mm) * part + piece.radius_mm.derivative(x)) / speed,
          ((b.tone - a.tone) * part + piece.tone.derivative(x)) / speed, speed};
}

/// Returns true if the profile can be smooth between two pieces: both have an edge.
bool has_edge(const Stroke& s, DrawnPiece before, DrawnPiece after) {
  before.radius_mm = before.tone = after.radius_mm = after.tone = {};
  const End a = end_of(s, before, 1.0), b = end_of(s, after, 0.0);
  return a.speed_mm > 0.0 && b.speed_mm > 0.0 && std::fabs(a.slope) < kJump &&
         std::fabs(b.slope) < kJump;
}

std::vector<DrawnPiece> pieces_of(const Stroke& s, int first = 0) {
  std::vector<DrawnPiece> pieces;
  DrawnProfile profile(s, first);
  while (const DrawnPiece* piece = profile.next()) pieces.push_back(*piece);
  return pieces;
}

Stroke line_with(std::vector<WidthKnot> widths) {
  StrokeData d = testing::straight_stroke({0, 0}, {30, 0}, 1.0, 1.0).data();
  d.widths = std::move(widths);
  return Stroke::create(std::move(d)).value();
}

TEST(DrawnProfile, PiecesCoverTheStrokeAndEndAtTheNodes) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    std::vector<double> nodes, ends{0.0};
    for (int i = 0; i <= s.segment_count(); ++i) nodes.push_back(i);
    for (const WidthKnot& k : s.widths()) nodes.push_back(k.u);
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (const DrawnPiece& piece : pieces_of(s)) {
      ASSERT_EQ(piece.segment + piece.t0, ends.back());
      ASSERT_LE(s.widths()[piece.knot].u, ends.back());
      ends.push_back(piece.segment + piece.t1);
      ASSERT_GE(s.widths()[piece.knot + 1].u, ends.back());
    }
    ASSERT_EQ(ends, nodes);
  }
}

TEST(DrawnProfile, IsMonotonicBetweenNodesAndExactAtThem) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    for (const DrawnPiece& piece : pieces_of(s)) {
      ASSERT_EQ(piece.radius_mm.at(0.0), 0.0);
      ASSERT_EQ(piece.radius_mm.at(1.0), 0.0);
      const double begin = end_of(s, piece, 0.0).radius_mm, end = end_of(s, piece, 1.0).radius_mm;
      const double sign = end < begin ? -1.0 : 1.0;
      double last = begin, last_tone = end_of(s, piece, 0.0).tone;
      const double tone_sign = end_of(s, piece, 1.0).tone < last_tone ? -1.0 : 1.0;
      for (int k = 1; k <= 50; ++k) {
        const End here = end_of(s, piece, k / 50.0);
        ASSERT_GE(sign * (here.radius_mm - last), -1e-12);
        ASSERT_GE(tone_sign * (here.tone - last_tone), -1e-12);
        last = here.radius_mm;
        last_tone = here.tone;
      }
    }
  }
}

// Equation (3) has hundreds of kinks in the same strokes, so this fails if nothing is smoothed.
TEST(DrawnProfile, HasNoVisibleKink) {
  int smoothed = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    std::optional<DrawnPiece> before;
    for (const DrawnPiece& piece : pieces_of(s)) {
      if (before) {
        const End a = end_of(s, *before, 1.0), b = end_of(s, piece, 0.0);
        if (has_edge(s, *before, piece)) {
          const double large = std::max({1.0, std::fabs(a.slope), std::fabs(a.tone_slope)});
          ASSERT_NEAR(a.slope, b.slope, kUnseenKink + 1e-9 * large);
          ASSERT_NEAR(a.tone_slope, b.tone_slope, kUnseenToneKink + 1e-9 * large);
          smoothed += before->radius_mm.end != 0.0 ? 1 : 0;
        }
      }
      before = piece;
    }
  }
  EXPECT_GT(smoothed, 200);
}

TEST(DrawnProfile, StraightProfilesStayBitForBit) {
  const Stroke even = line_with({{0, 1.2}, {0.3, 1.2}, {1, 1.2}});
  const Stroke wedge = line_with({{0, 0.4, 0.2}, {0.25, 0.9, 0.35}, {1, 2.4, 0.8}});
  const Stroke gentle =
      line_with({{0, 0.4}, {0.5, 0.5}, {1, 0.4}});  // turns by a third of a degree
  for (const Stroke& s : {even, wedge, gentle}) {
    for (const DrawnPiece& piece : pieces_of(s)) {
      EXPECT_TRUE(piece.radius_mm.is_straight());
      EXPECT_TRUE(piece.tone.is_straight());
    }
    std::vector<Dab> dabs;
    flatten(s, 0.01, dabs);
    ASSERT_EQ(dabs.size(), s.widths().size());
    for (std::size_t k = 0; k < dabs.size(); ++k) {
      EXPECT_EQ(dabs[k].radius_mm, 0.5 * s.widths()[k].width_mm);
    }
  }
}

TEST(DrawnProfile, AnExtremeIsRoundAndNoWiderThanItsKnot) {
  const Stroke s = line_with({{0, 0.4}, {0.5, 2.4}, {1, 0.4}});
  const auto pieces = pieces_of(s);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_NEAR(end_of(s, pieces[0], 1.0).slope, 0.0, 1e-12);
  EXPECT_NEAR(end_of(s, pieces[1], 0.0).slope, 0.0, 1e-12);
  EXPECT_EQ(drawn_width_mm(s, 0.5), 2.4);
  EXPECT_GT(drawn_width_mm(s, 0.4), s.width_mm(0.4) + 0.1);
  EXPECT_LT(drawn_width_mm(s, 0.4), 2.4);
}

// A painter may begin anywhere: the pieces of the rest of a stroke are those of the whole one.
TEST(DrawnProfile, StartsAtAnySegmentWithTheSamePieces) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke s = testing::random_stroke(seed);
    const auto all = pieces_of(s);
    for (int first = 0; first < s.segment_count(); ++first) {
      const auto rest = pieces_of(s, first);
      const std::size_t skipped = all.size() - rest.size();
      for (std::size_t k = 0; k < rest.size(); ++k) {
        const DrawnPiece &a = all[skipped + k], &b = rest[k];
        ASSERT_EQ(a.segment + a.t0, b.segment + b.t0);
        ASSERT_EQ(a.radius_mm.end, b.radius_mm.end);
        ASSERT_EQ(a.radius_mm.start, b.radius_mm.start);
        ASSERT_EQ(a.tone.start, b.tone.start);
      }
    }
  }
}

TEST(DrawnProfile, TheSeamOfARingIsSmooth) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Stroke random = testing::random_stroke(seed);
    if (!random.closed()) continue;
    StrokeData d = random.data();
    d.widths.back().width_mm = d.widths.front().width_mm;
    d.widths.back().tone = d.widths.front().tone;
    const Stroke s = Stroke::create(std::move(d)).value();
    const auto pieces = pieces_of(s);
    const End end = end_of(s, pieces.back(), 1.0), start = end_of(s, pieces.front(), 0.0);
    if (has_edge(s, pieces.back(), pieces.front())) {
      const double large = std::max(1.0, std::fabs(end.slope));
      ASSERT_NEAR(end.slope, start.slope, kUnseenKink + 1e-9 * large) << seed;
    }
  }
}

TEST(DrawnProfile, StraightLinesBetweenDabsAreWithinTheTolerance) {
  const Stroke s = line_with({{0, 0.4, 0.0}, {0.4, 2.4, 0.9}, {0.6, 2.6, 1.0}, {1, 0.4, 0.1}});
  for (const double tolerance : {0.1, 0.01, 0.001}) {
    std::vector<Dab> dabs;
    flatten(s, tolerance, dabs);
    double worst = 0.0;
    for (std::size_t k = 0; k + 1 < dabs.size(); ++k) {
      const Dab &a = dabs[k], &b = dabs[k + 1];
      for (int i = 0; i <= 20; ++i) {
        const double u = std::lerp(a.center.x, b.center.x, i / 20.0) / 30.0;
        worst = std::max(worst, std::fabs(std::lerp(a.radius_mm, b.radius_mm, i / 20.0) -
                                          0.5 * drawn_width_mm(s, u)));
      }
    }
    EXPECT_LE(worst, tolerance);
    EXPECT_GT(worst, 0.01 * tolerance);  // no more dabs than needed
  }
}

}  // namespace
}  // namespace felt::drawn_profile_test
