#include "felt/recognise/scratch_out.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <limits>

#include "felt/recognise/testing/drawn_shapes.h"

namespace felt::scratch_out_test {
namespace {

using testing::joined;
using testing::placed;
using testing::unsteady;
using testing::zigzag;

double any(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0;
}

RC_GTEST_PROP(ScratchOut, FindsAZigzagOfAnySizeAndDirection, ()) {
  const int passes = *rc::gen::inRange(ScratchOut::kMinPasses, 16);
  const double length = any(8.0, 60.0);
  const auto path = placed(unsteady(zigzag(passes, length, any(0.5, 0.25 * length)), 0.01 * length,
                                    *rc::gen::inRange<std::uint64_t>(1, 1'000'000)),
                           any(0.0, 6.3), 1.0, {any(-200, 200), any(-200, 200)});
  const auto found = ScratchOut::find(path);
  RC_ASSERT(found.has_value());
  RC_ASSERT(ScratchOut::features(path).passes == passes);
  // A line in the middle of it is covered, one far away is not.
  const Rect box = found->bounds();
  const Point middle{0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)};
  RC_ASSERT(found->covers(joined({middle, middle + Vec{1.0, 0.0}})));
  RC_ASSERT(!found->covers(joined({middle + Vec{300.0, 0.0}, middle + Vec{310.0, 0.0}})));
}

RC_GTEST_PROP(ScratchOut, TheSameTurnedOrBackwards, ()) {
  const auto path = unsteady(zigzag(*rc::gen::inRange(3, 12), any(4, 40), any(0.5, 20)),
                             any(0.0, 0.5), *rc::gen::inRange<std::uint64_t>(1, 1'000'000));
  const std::vector<Point> back(path.rbegin(), path.rend());
  RC_ASSERT(ScratchOut::features(back).passes == ScratchOut::features(path).passes);
  const auto turned = ScratchOut::features(placed(path, any(0.0, 6.3), 1.0, {10, 20}));
  RC_ASSERT(turned.passes == ScratchOut::features(path).passes);
  RC_ASSERT(std::abs(turned.along - ScratchOut::features(path).along) < 0.02);
}

TEST(ScratchOut, AHookAtTheStartIsPartOfItsPassLikeOneAtTheEnd) {
  constexpr double kExtent = 30.0, kHook = 0.1 * kExtent;
  std::vector<Point> ends{{kHook, -0.2}};
  for (int i = 0; i <= 6; ++i) ends.push_back({i % 2 == 0 ? 0.0 : kExtent, 1.0 * i});
  for (const double angle : {0.0, 3.0}) {  // to both sides along the axis first
    const auto path = placed(joined(ends), angle, 1.0, {});
    const std::vector<Point> back(path.rbegin(), path.rend());
    EXPECT_EQ(ScratchOut::features(path).passes, 6) << angle;
    EXPECT_EQ(ScratchOut::features(back).passes, 6) << angle;
  }
}

TEST(ScratchOut, LettersLinesAndCirclesAreInk) {
  const Point m[] = {{0, 10}, {0, 0}, {4, 8}, {8, 0}, {8, 10}};
  EXPECT_FALSE(ScratchOut::find(joined({std::begin(m), std::end(m)})));
  EXPECT_FALSE(ScratchOut::find(joined({{0, 0}, {80, 3}})));
  EXPECT_FALSE(ScratchOut::find(joined({{0, 0}, {80, 0}, {0, 0}, {80, 0}}))) << "three passes";
  EXPECT_FALSE(ScratchOut::find(testing::ellipse_part({50, 50}, 20, 20, 0.0, 25.0)));
  EXPECT_FALSE(ScratchOut::find(zigzag(8, 20, 30))) << "a wide zigzag is a pattern";
  EXPECT_FALSE(ScratchOut::find(zigzag(8, 2, 0.5))) << "a dot";
}

TEST(ScratchOut, CoversOnlyWhatIsMostlyInside) {
  const auto found = ScratchOut::find(zigzag(8, 30, 4));
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->covers(joined({{3, 5}, {27, 9}})));
  EXPECT_FALSE(found->covers(joined({{15, -60}, {15, 60}}))) << "a long line that it crosses";
  EXPECT_GT(found->covered_share(joined({{15, -60}, {15, 60}})), 0.05);
  EXPECT_TRUE(found->is_about({3, 5, 27, 9}));
  EXPECT_FALSE(found->is_about({14, 7, 15, 8})) << "an eye in a shaded face";
}

TEST(ScratchOut, CoversALongLineThatMostPassesCross) {
  const auto found = ScratchOut::find(zigzag(8, 30, 4));  // 30 mm along x, down to 16 mm
  ASSERT_TRUE(found);
  const auto line = joined({{15, -10}, {16, 16}});  // two thirds of it are inside
  EXPECT_LT(found->covered_share(line), ScratchOut::kCoveredShare);
  EXPECT_GE(found->crossings(line), ScratchOut::kMinCrossings);
  EXPECT_TRUE(found->covers(line));
  const auto beside = joined({{3, -3}, {27, 3}});  // few passes cross it
  EXPECT_LT(found->crossings(beside), ScratchOut::kMinCrossings);
  EXPECT_FALSE(found->covers(beside));
}

TEST(ScratchOut, CoversALineThatAFlatScribbleCrosses) {
  const auto found = ScratchOut::find(zigzag(6, 50, 2));  // 50 mm along x, down to 6 mm or so
  ASSERT_TRUE(found);
  const Rect box = found->bounds();
  const double y = 0.5 * (box.y0 + box.y1), half = 0.5 * box.height();
  // It begins in the middle, leaves the area at its border, and goes on.
  const auto line = joined({{2, y}, {56, y + 1.35 * half}});
  EXPECT_LT(found->covered_share(line), ScratchOut::kCoveredShare);
  EXPECT_GE(found->covered_share(line), ScratchOut::kFlatCrossedShare);
  EXPECT_EQ(found->crossings(line), ScratchOut::kMinFlatCrossings);
  EXPECT_TRUE(found->covers(line));
}

TEST(ScratchOut, ASteepScribbleReachesFartherThanWhatItCrossesOut) {
  const auto found = ScratchOut::find(zigzag(10, 60, 6));
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_about({12, 26, 48, 34})) << "two lines of 36 mm under 60 mm x 60 mm";
  EXPECT_FALSE(found->is_about({12, 26, 36, 34}));
}

TEST(ScratchOut, ManyPassesMayBeUneven) {
  // The ends of the passes: the third and fourth are short.
  const std::vector<Point> ends{{0, 0},  {12, 1}, {1, 2},  {12, 3}, {8, 4},
                                {12, 5}, {0, 6},  {12, 7}, {1, 8}};
  const auto features = ScratchOut::features(joined(ends));
  EXPECT_LT(features.overlap, ScratchOut::kMinOverlap);
  EXPECT_TRUE(ScratchOut::find(joined(ends)));
  const std::vector<Point> few(ends.begin(), ends.begin() + ScratchOut::kMinPasses + 1);
  EXPECT_FALSE(ScratchOut::find(joined(few))) << "six passes must be even";
}

TEST(ScratchOut, DegeneratePathsAreInk) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::vector<Point>& path : {std::vector<Point>{},
                                         {{1, 1}},
                                         {{1, 1}, {1, 1}},
                                         {{nan, 1}, {2, nan}},
                                         {{1e300, 0}, {-1e300, 0}}}) {
    EXPECT_FALSE(ScratchOut::find(path));
    EXPECT_EQ(ScratchOut::features(path).passes, 0);
  }
  EXPECT_FALSE(ScratchOut::find(placed(zigzag(8, 30, 4), 0.0, 1e4, {}))) << "larger than any page";
}

}  // namespace
}  // namespace felt::scratch_out_test
