#include "tests/support/fit_checker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "tests/support/fit_curve_pieces.h"
#include "tests/support/fit_files.h"

namespace fit_check {
namespace {

constexpr double kTolerance = 1.0;

Segment line(Point a, Point b) {
  return {a, (2.0 / 3.0) * a + (1.0 / 3.0) * b, (1.0 / 3.0) * a + (2.0 / 3.0) * b, b};
}

/// Returns samples on the straight line from a to b, `step` apart, including both ends.
std::vector<Point> ink_along(Point a, Point b, double step) {
  const int count = static_cast<int>(std::ceil(length(b - a) / step));
  std::vector<Point> samples;
  for (int i = 0; i <= count; ++i) samples.push_back(a + (1.0 * i / count) * (b - a));
  return samples;
}

std::vector<Point> joined(std::vector<Point> first, const std::vector<Point>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Ink ink(std::vector<Point> samples) {
  return {"s", "", std::move(samples)};
}
FitCurve curve(std::vector<Segment> segments, std::vector<bool> corners = {}) {
  return {"s", false, std::move(segments), std::move(corners)};
}

TEST(FitChecker, StraightInkWithItsOwnLineIsClean) {
  const Report r = check_stroke(ink(ink_along({0, 0}, {30, 0}, 1.0)),
                                curve({line({0, 0}, {10, 0}), line({10, 0}, {30, 0})}), kTolerance);
  EXPECT_TRUE(r.clean());
  EXPECT_EQ(r.samples, 31);
  EXPECT_EQ(r.segments, 2);
  EXPECT_NEAR(r.max_error, 0.0, 1e-7);
  EXPECT_NEAR(r.max_overshoot(), 0.0, 1e-9);
  EXPECT_EQ(r.kinks, 0);
}

TEST(FitChecker, OneSampleTooFarIsFoundAndMeasured) {
  std::vector<Point> samples = ink_along({0, 0}, {30, 0}, 1.0);
  samples[17].y = 1.25;
  const Report r = check_stroke(ink(samples), curve({line({0, 0}, {30, 0})}), kTolerance);
  EXPECT_EQ(r.over_tolerance, 1);
  EXPECT_NEAR(r.max_error, 1.25, 1e-9);
  EXPECT_NEAR(r.mean_error(), 1.25 / 31.0, 1e-9);
  EXPECT_FALSE(r.clean());
}

TEST(FitChecker, SampleExactlyAtTheToleranceIsWithinIt) {
  std::vector<Point> samples = ink_along({0, 0}, {30, 0}, 1.0);
  samples[17].y = kTolerance;
  EXPECT_EQ(check_stroke(ink(samples), curve({line({0, 0}, {30, 0})}), kTolerance).over_tolerance,
            0);
}

TEST(FitChecker, RepeatedSamplesAllCount) {
  const std::vector<Point> samples{{0, 0}, {5, 0.5}, {5, 0.5}, {5, 0.5}, {10, 0}};
  const Report r = check_stroke(ink(samples), curve({line({0, 0}, {10, 0})}), kTolerance);
  EXPECT_EQ(r.samples, 5);
  EXPECT_NEAR(r.mean_error(), 0.3, 1e-9);
}

TEST(FitChecker, ErrorIsToTheWholeCurveNotToTheSampleOwnPart) {
  // The second segment returns to the first sample.
  const Report r =
      check_stroke(ink({{0, 0}, {10, 0}, {0, 0.1}}),
                   curve({line({1, 0}, {10, 0}), line({10, 0}, {0, 0})}, {true}), kTolerance);
  EXPECT_NEAR(r.max_error, 0.1, 1e-9);
}

TEST(FitChecker, UndeclaredKinkIsABreakAndDeclaredOneIsACorner) {
  const Ink right_angle =
      ink(joined(ink_along({0, 0}, {20, 0}, 1.0), ink_along({20, 0}, {20, 20}, 1.0)));
  const std::vector<Segment> segments{line({0, 0}, {20, 0}), line({20, 0}, {20, 20})};

  const Report undeclared = check_stroke(right_angle, curve(segments), kTolerance);
  EXPECT_THAT(undeclared.breaks, ::testing::ElementsAre(1, 1, 1));
  EXPECT_NEAR(undeclared.max_smooth_turn_deg, 90.0, 1e-9);
  EXPECT_EQ(undeclared.kinks, 1);
  EXPECT_FALSE(undeclared.clean());

  const Report declared = check_stroke(right_angle, curve(segments, {true}), kTolerance);
  EXPECT_THAT(declared.breaks, ::testing::ElementsAre(0, 0, 0));
  EXPECT_EQ(declared.corners, 1);
  EXPECT_EQ(declared.kinks, 0);
  EXPECT_TRUE(declared.clean());
}

TEST(FitChecker, SmallBreaksAreCountedByTheirSize) {
  const auto turned_by = [](double degrees) {
    const double a = degrees * std::numbers::pi / 180.0;
    const Point end{10 + 10 * std::cos(a), 10 * std::sin(a)};
    return check_stroke(ink({{0, 0}, {10, 0}, end}),
                        curve({line({0, 0}, {10, 0}), line({10, 0}, end)}), kTolerance);
  };
  EXPECT_THAT(turned_by(1e-4).breaks, ::testing::ElementsAre(0, 0, 0));
  EXPECT_THAT(turned_by(0.1).breaks, ::testing::ElementsAre(1, 0, 0));
  EXPECT_THAT(turned_by(10).breaks, ::testing::ElementsAre(1, 1, 0));
  EXPECT_THAT(turned_by(40).breaks, ::testing::ElementsAre(1, 1, 1));
}

TEST(FitChecker, ZeroHandlesAndPointSegmentsDoNotHideABreak) {
  const Segment no_handles{Point{0, 0}, {0, 0}, {10, 0}, {10, 0}};
  const Segment point{Point{10, 0}, {10, 0}, {10, 0}, {10, 0}};
  const Segment up{Point{10, 0}, {10, 0}, {10, 10}, {10, 10}};
  const Report r =
      check_stroke(ink({{0, 0}, {10, 0}, {10, 10}}), curve({no_handles, point, up}), kTolerance);
  EXPECT_EQ(r.degenerate_segments, 1);
  EXPECT_THAT(r.breaks, ::testing::ElementsAre(1, 1, 1));
}

TEST(FitChecker, CuspInsideASegmentIsAKink) {
  const Segment cusp{Point{0, 0}, {20, 20}, {0, 20}, {20, 0}};  // a cusp: f' = 0 at 1/2
  const Report r = check_stroke(ink({{0, 0}, {10, 15}, {20, 0}}), curve({cusp}), kTolerance);
  EXPECT_EQ(r.kinks, 1);
  EXPECT_THAT(r.breaks, ::testing::ElementsAre(0, 0, 0));
}

TEST(FitChecker, GapBetweenSegmentsIsNotClean) {
  const Report r =
      check_stroke(ink({{0, 0}, {10, 0}, {20, 0}}),
                   curve({line({0, 0}, {10, 0}), line({10.5, 0}, {20, 0})}), kTolerance);
  EXPECT_NEAR(r.max_gap, 0.5, 1e-12);
  EXPECT_FALSE(r.clean());
}

TEST(FitChecker, SpikeBetweenSamplesIsOvershoot) {
  // The curve passes through every sample. Between the two samples in the middle it is up to 30
  // away from the ink.
  const std::vector<Segment> segments{
      line({0, 0}, {10, 0}), {Point{10, 0}, {10, 40}, {11, 40}, {11, 0}}, line({11, 0}, {20, 0})};
  const Report r =
      check_stroke(ink(ink_along({0, 0}, {20, 0}, 1.0)), curve(segments, {true, true}), kTolerance);
  EXPECT_NEAR(r.max_error, 0.0, 1e-6);
  EXPECT_NEAR(r.max_overshoot(), 30.0, 0.01);
  EXPECT_NEAR(r.overshoot_excess, 30.0 - 4.0 - 1.0, 0.01);
  EXPECT_EQ(r.overshoot_violations, 1);
  EXPECT_FALSE(r.clean());
}

TEST(FitChecker, LoopBetweenSamplesIsOvershoot) {
  const Segment loop{Point{0, 0}, {30, 24}, {-20, 24}, {10, 0}};
  const Report r = check_stroke(ink({{0, 0}, {10, 0}}), curve({loop}), kTolerance);
  EXPECT_NEAR(r.max_overshoot(), 18.0, 0.01);
  EXPECT_EQ(r.overshoot_violations, 1) << "18 > 4 + 10";
}

TEST(FitChecker, OvershootMayGrowWithTheSampleGap) {
  const Segment bulge{Point{0, 0}, {0, 16}, {40, 16}, {40, 0}};
  const Report r = check_stroke(ink({{0, 0}, {40, 0}}), curve({bulge}), kTolerance);
  EXPECT_NEAR(r.max_overshoot(), 12.0, 0.01);
  EXPECT_EQ(r.overshoot_violations, 0) << "12 < 4 + 40";
}

TEST(FitChecker, SlowInkPassingByDoesNotMakeAWideGapNarrow) {
  // The ink has a gap of 40 from (0, 0) to (40, 0). The curve bulges to 8 above it, where it is
  // only 6 below another part of the ink with dense samples. The wide gap must be used as the
  // sample gap, although the dense samples are nearer.
  const Point turn{60, 14};
  std::vector<Point> samples{{0, 0}, {40, 0}, {60, 0}, turn};
  samples = joined(samples, ink_along(turn, {0, 14}, 0.5));
  const Segment bulge{Point{0, 0}, {0, 10.67}, {40, 10.67}, {40, 0}};
  const FitCurve over =
      curve({bulge, line({40, 0}, {60, 0}), line({60, 0}, turn), line(turn, {0, 14})},
            {true, true, true});
  const Report r = check_stroke(ink(samples), over, kTolerance);
  EXPECT_NEAR(r.max_overshoot(), 7.0, 0.1);
  EXPECT_EQ(r.overshoot_violations, 0);

  FitCurve spike = over;  // a spike between dense samples, which exceeds their small gap
  spike.segments[3] = {turn, {30, 40}, {30, 40}, {0, 14}};
  EXPECT_EQ(check_stroke(ink(samples), spike, kTolerance).overshoot_violations, 1);
}

TEST(FitChecker, CornerWhereTheInkIsStraightIsWeak) {
  const Report r =
      check_stroke(ink(ink_along({0, 0}, {60, 0}, 1.0)),
                   curve({line({0, 0}, {30, 0}), line({30, 0}, {60, 0})}, {true}), kTolerance);
  EXPECT_EQ(r.corners, 1);
  EXPECT_EQ(r.corners_bend_less, 1);
  for (const auto& by_limit : r.weak_corners) EXPECT_THAT(by_limit, ::testing::Each(1));
  EXPECT_EQ(r.corners_near_end, 0);
}

TEST(FitChecker, InkTurnIsMeasuredBetweenTheArms) {
  const double a = 55.0 * std::numbers::pi / 180.0;
  const Point end{30 + 30 * std::cos(a), 30 * std::sin(a)};
  const Ink bent = ink(joined(ink_along({0, 0}, {30, 0}, 0.7), ink_along({30, 0}, end, 0.7)));
  const Report r =
      check_stroke(bent, curve({line({0, 0}, {30, 0}), line({30, 0}, end)}, {true}), kTolerance);
  for (const auto& by_limit : r.weak_corners)
    EXPECT_THAT(by_limit, ::testing::ElementsAre(0, 0, 1));
}

TEST(FitChecker, RoundBendLooksLessOfACornerTheShorterTheArm) {
  // On a quarter circle of radius 8, arms of length h give a turn of 2 asin(h / 16).
  Ink round = ink({});
  for (int d = -90; d <= 0; ++d) {
    const double a = d * std::numbers::pi / 180.0;
    round.samples.push_back({8 * std::cos(a), 8 * std::sin(a)});
  }
  const double k = 8 * 0.5522847498, half = std::sqrt(0.5) * 8;
  const Segment arc{Point{0, -8}, {k, -8}, {8, -k}, {8, 0}};
  const Point q01 = 0.5 * (arc[0] + arc[1]), q12 = 0.5 * (arc[1] + arc[2]),
              q23 = 0.5 * (arc[2] + arc[3]);
  const Point middle{half, -half};
  const FitCurve split = curve(
      {{arc[0], q01, 0.5 * (q01 + q12), middle}, {middle, 0.5 * (q12 + q23), q23, arc[3]}}, {true});
  const Report r = check_stroke(round, split, kTolerance);
  EXPECT_THAT(r.weak_corners[0], ::testing::ElementsAre(1, 1, 1)) << "14 degrees";
  EXPECT_THAT(r.weak_corners[1], ::testing::ElementsAre(1, 1, 1)) << "29 degrees";
}

TEST(FitChecker, CornerAtTheEndOfTheInkIsReported) {
  const Report r =
      check_stroke(ink(joined(ink_along({0, 0}, {30, 0}, 1.0), {{30, 1}})),
                   curve({line({0, 0}, {30, 0}), line({30, 0}, {30, 1})}, {true}), kTolerance);
  EXPECT_EQ(r.corners_near_end, 1);
}

TEST(FitChecker, NonFiniteOrEmptyCurveIsInvalid) {
  const Ink some = ink({{0, 0}, {1, 0}});
  EXPECT_EQ(check_stroke(some, curve({}), kTolerance).invalid, 1);
  Segment bad = line({0, 0}, {1, 0});
  bad[2].x = std::nan("");
  EXPECT_EQ(check_stroke(some, curve({bad}), kTolerance).invalid, 1);
}

TEST(FitChecker, DotsAreJudged) {
  const Report r =
      check_stroke(ink({{3, 3}, {3, 3}}), curve({line({3, 3}, {3.05, 3})}), kTolerance);
  EXPECT_NEAR(r.max_error, 0.0, 1e-9);
  EXPECT_NEAR(r.max_overshoot(), 0.05, 1e-9);
}

TEST(CurvePieces, NearestPointIsNeverMissed) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-10.0, 10.0);
  const auto point = [&] { return Point{coordinate(random), coordinate(random)}; };
  for (int i = 0; i < 300; ++i) {
    const std::vector<Segment> segments{{point(), point(), point(), point()}};
    const CurvePieces pieces(segments, kTolerance);
    const Point p = point();
    double dense = 1e300;
    for (int k = 0; k <= 20000; ++k)
      dense = std::min(dense, length(at(segments[0], k / 20000.0) - p));
    std::size_t hint = 0;
    EXPECT_NEAR(pieces.distance(p, hint), dense, 2e-3);
    EXPECT_LE(pieces.distance(p, hint), dense + 1e-9) << "a denser sampling may not find less";
  }
}

TEST(CheckAll, MatchesByIdReportsMissingOnesAndSplitsBySource) {
  std::istringstream raw(
      R"({"id":"a","source":"pen","points":[[0,0,null,0],[10,0,0.5,1]]}
{"id":"b","source":"mouse","points":[[0,0],[0,10]]}

{"id":"c","source":"pen","points":[[0,0],[5,5]]})");
  std::istringstream sketch(
      R"({"id":"b","closed":false,"segments":[[0,0,0,2,0,4,0,5],[0,5,0,6,0,8,0,10]],"joints":["smooth"],"widths":[[0,1],[2,1]]}
{"id":"a","segments":[[0,0,1,0,2,0,5,0]],"joints":[]})");
  std::map<std::string, Report> sources;
  const Report r = check_all(read_inks(raw, 0.5), read_curves(sketch), kTolerance, &sources);
  EXPECT_EQ(r.strokes, 2);
  EXPECT_EQ(r.missing, 1);
  EXPECT_EQ(r.segments, 3);
  EXPECT_NEAR(r.max_overshoot(), 5.0, 1e-9) << "b's ink is half as long as its curve";
  EXPECT_EQ(sources.at("pen").segments, 1);
  EXPECT_EQ(sources.at("mouse").segments, 2);
}

TEST(Report, QuantileOfOvershootIsOverStrokes) {
  Report total;
  for (int i = 1; i <= 100; ++i) {
    Report one;
    one.overshoots = {static_cast<double>(i)};
    total.add(one);
  }
  EXPECT_EQ(total.overshoot_quantile(0.99), 99.0);
  EXPECT_EQ(total.max_overshoot(), 100.0);
}

TEST(FitFiles, BadLineIsNamed) {
  std::istringstream raw("{\"id\":\"a\",\"points\":[]}\n{oops\n");
  EXPECT_THAT([&] { read_inks(raw, 1.0); },
              testing::ThrowsMessage<std::runtime_error>(::testing::StartsWith("line 2:")));
}

}  // namespace
}  // namespace fit_check
