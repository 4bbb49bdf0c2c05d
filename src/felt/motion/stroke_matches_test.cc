#include "felt/motion/stroke_matches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "felt/geometry/affine.h"
#include "felt/motion/testing/made_drawings.h"
#include "felt/stroke/edit/split.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::stroke_matches_test {
namespace {

using testing::made_strokes;
using testing::moved_strokes;
using testing::straight_stroke;

StrokePtr shared(Stroke stroke) {
  return std::make_shared<const Stroke>(std::move(stroke));
}

/// Returns the partner of each stroke; the last part counts.
std::map<std::size_t, std::size_t> partners(const Correspondence& found) {
  std::map<std::size_t, std::size_t> map;
  for (const StrokeMatch& m : found.matches) {
    if (m.from && m.to) map[*m.from] = *m.to;
  }
  return map;
}

/// Checks that every stroke of both drawings is in a match.
void expect_complete(const Correspondence& found, std::size_t from, std::size_t to) {
  std::vector<int> a(from, 0), b(to, 0);
  for (const StrokeMatch& m : found.matches) {
    EXPECT_TRUE(m.from || m.to);
    if (m.from) ++a.at(*m.from);
    if (m.to) ++b.at(*m.to);
    EXPECT_LT(m.from_start, m.from_end);
    EXPECT_LT(m.to_start, m.to_end);
  }
  EXPECT_EQ(std::count(a.begin(), a.end(), 0), 0);
  EXPECT_EQ(std::count(b.begin(), b.end(), 0), 0);
}

TEST(StrokeMatches, FindsStrokesThatMovedTogether) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto from = made_strokes(30, seed);
    const Similarity motion{{100.0, 100.0},
                            {random.between(0.0, 300.0), random.between(0.0, 300.0)},
                            random.between(-1.5, 1.5),
                            random.between(0.7, 1.4)};
    auto to = moved_strokes(from, motion, 0.5, seed);
    std::reverse(to.begin(), to.end());  // another order
    const auto found = match_strokes(from, to);
    ASSERT_TRUE(found);
    expect_complete(*found, 30, 30);
    EXPECT_NEAR(found->motion.angle_rad, motion.angle_rad, 0.05);
    EXPECT_NEAR(found->motion.scale, motion.scale, 0.05);
    int right = 0;
    for (const auto& [a, b] : partners(*found)) right += a + b == 29 ? 1 : 0;
    EXPECT_GE(right, 29);
  }
}

TEST(StrokeMatches, FindsASplitAMergeAndAMissingStroke) {
  int splits = 0, merges = 0, missing = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    auto from = made_strokes(20, seed);
    auto to = moved_strokes(from, {{100, 100}, {120, 90}, 0.3, 1.1}, 0.3, seed);
    const auto halves = split(*to[4], 0.5 * to[4]->segment_count());
    const auto joined = split(*from[7], 0.4 * from[7]->segment_count());
    ASSERT_TRUE(halves && joined);
    to[4] = shared(halves->first);
    to.push_back(shared(reversed(halves->second)));
    from[7] = shared(joined->first);
    from.push_back(shared(joined->second));
    to.erase(to.begin() + 12);
    const auto found = match_strokes(from, to);
    ASSERT_TRUE(found);
    expect_complete(*found, 21, 20);
    std::vector<StrokeMatch> whole, parts;
    bool is_missing = false;
    for (const StrokeMatch& m : found->matches) {
      if (m.from == 4U) whole.push_back(m);
      if (m.to == 7U) parts.push_back(m);
      if (m.from == 12U) is_missing = !m.to;
    }
    missing += is_missing ? 1 : 0;
    const bool is_split = whole.size() == 2 && whole[0].to == 4U && whole[1].to == 19U;
    splits += is_split ? 1 : 0;
    if (is_split) {
      EXPECT_NEAR(whole[0].from_end, 0.5, 0.15) << seed;
      EXPECT_EQ(whole[0].from_end, whole[1].from_start);
      EXPECT_FALSE(whole[0].reversed);
      EXPECT_TRUE(whole[1].reversed);
    }
    merges += parts.size() == 2 && parts[0].from == 7U && parts[1].from == 20U ? 1 : 0;
  }
  EXPECT_GE(splits, 44);
  EXPECT_GE(merges, 44);
  EXPECT_GE(missing, 47);
}

TEST(StrokeMatches, GivenPairsComeFirst) {
  const auto from = made_strokes(10, 3);
  const std::vector<GivenPair> given{{2, 5}, {5, std::nullopt}, {std::nullopt, 1}};
  const auto found = match_strokes(from, from, given);
  ASSERT_TRUE(found);
  expect_complete(*found, 10, 10);
  for (const StrokeMatch& m : found->matches) {
    EXPECT_TRUE(m.from != 2U || m.to == 5U);
    EXPECT_TRUE(m.from != 5U || !m.to);
    EXPECT_TRUE(m.to != 1U || !m.from);
    EXPECT_TRUE(m.from != 8U || m.to == 8U);
    EXPECT_EQ(m.is_given, m.from == 2U || m.from == 5U || m.to == 1U);
  }
  EXPECT_FALSE(match_strokes(from, from, std::vector<GivenPair>{{10, 0}}));
  EXPECT_FALSE(match_strokes(from, from, std::vector<GivenPair>{{1, 0}, {1, 2}}));
}

TEST(StrokeMatches, ALineBetweenStrokesGivesAPair) {
  const std::vector<StrokePtr> from{shared(straight_stroke({0, 0}, {50, 0}, 1, 1)),
                                    shared(straight_stroke({0, 30}, {50, 30}, 1, 1))};
  const std::vector<StrokePtr> to{shared(straight_stroke({0, 60}, {50, 60}, 1, 1))};
  const auto pair = pair_by_line(from, to, {20, 28}, {25, 63});
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->from, 1U);
  EXPECT_EQ(pair->to, 0U);
  EXPECT_FALSE(pair_by_line(from, to, {20, 28}, {25, 200}));
  EXPECT_FALSE(pair_by_line(from, {}, {20, 28}, {25, 63}));
}

TEST(StrokeMatches, HandlesEmptyAndUnequalDrawings) {
  const auto some = made_strokes(5, 1);
  const std::vector<StrokePtr> none;
  EXPECT_TRUE(match_strokes(none, none)->matches.empty());
  EXPECT_EQ(match_strokes(some, none)->matches.size(), 5U);
  EXPECT_EQ(match_strokes(none, some)->matches.size(), 5U);
  expect_complete(*match_strokes(some, made_strokes(1, 2)), 5, 1);
  expect_complete(*match_strokes(made_strokes(1, 2), some), 1, 5);
  const std::vector<StrokePtr> same(7, some[0]);
  expect_complete(*match_strokes(same, same), 7, 7);
  const std::vector<StrokePtr> dots{shared(straight_stroke({0, 0}, {0.05, 0}, 1, 1)),
                                    shared(straight_stroke({9, 0}, {9, 0.05}, 1, 1))};
  EXPECT_EQ(partners(*match_strokes(dots, dots)),
            (std::map<std::size_t, std::size_t>{{0, 0}, {1, 1}}));
  const std::vector<StrokePtr> many(kMaxMatchedStrokes + 1, some[0]);
  EXPECT_EQ(match_strokes(many, some).error().code, ErrorCode::kLimitExceeded);
}

TEST(StrokeMatches, TheSameDrawingMatchesItselfExactly) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const auto strokes = made_strokes(40, seed);
    const auto found = match_strokes(strokes, strokes);
    ASSERT_TRUE(found);
    for (const StrokeMatch& m : found->matches) {
      EXPECT_EQ(m.from, m.to);
      EXPECT_FALSE(m.reversed);
      EXPECT_LT(m.cost, 1e-3);
    }
    const auto again = match_strokes(strokes, strokes);
    EXPECT_EQ(found->matches, again->matches);
  }
}

TEST(StrokeMatches, AMirroredDrawingIsMatchedByPosition) {
  // No motion without mirroring explains a mirrored drawing, so strokes are matched where they are.
  const auto from = made_strokes(15, 8);
  std::vector<StrokePtr> to;
  for (const StrokePtr& stroke : from) {
    StrokeData data = stroke->data();
    for (Point& p : data.points) p.x = 200.0 - p.x;
    to.push_back(shared(Stroke::create(std::move(data)).value()));
  }
  const auto found = match_strokes(from, to);
  ASSERT_TRUE(found);
  expect_complete(*found, 15, 15);
  EXPECT_GT(found->motion.scale, 0.3);
}

}  // namespace
}  // namespace felt::stroke_matches_test
