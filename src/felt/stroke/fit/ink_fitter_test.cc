#include "felt/stroke/fit/ink_fitter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "felt/stroke/fit/curve_fitter.h"
#include "felt/stroke/fit/width_map.h"
#include "felt/stroke/testing/fit_oracle.h"
#include "felt/stroke/testing/test_ink.h"
#include "felt/stroke/width_profile.h"

namespace felt::ink_fitter_test {
namespace {

using testing::TestInk;

void draw(InkFitter& fitter, const std::vector<Point>& ink) {
  fitter.begin();
  for (const Point p : ink) fitter.push({p, {}, {}});
  fitter.end();
}

TEST(InkFitter, R2R4AnyInkBecomesAStrokeOnlineAndRefined) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    InkFitOptions options;
    options.curve.tolerance_mm = random.tolerance();
    const std::vector<Point> ink = random.draw_any(300);
    InkFitter fitter(options);
    draw(fitter, ink);
    const int online = fitter.segment_count();
    for (const bool refined : {false, true}) {
      if (refined) fitter.refine();
      const Result<Stroke> stroke = fitter.stroke();  // create() checks I1 to I6
      ASSERT_TRUE(stroke) << stroke.error().message;
      ASSERT_TRUE(testing::has_all_places(fitter.curve(), ink.size()));
      EXPECT_LE(testing::worst_error(fitter.curve(), ink), options.curve.tolerance_mm);
    }
    EXPECT_LE(fitter.segment_count(), online);
  }
}

TEST(InkFitter, R10SamplesThatAreNoPlaceAreIgnoredAndCounted) {
  InkFitter fitter({});
  fitter.begin();
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const Point p : {Point{nan, 0.0}, Point{0.0, infinity}, Point{1e10, 0.0}}) {
    fitter.push({p, {}, {}});
  }
  fitter.end();
  EXPECT_EQ(fitter.ignored_count(), 3u);
  EXPECT_FALSE(fitter.stroke());
  draw(fitter, {{1.0, 1.0}, {nan, nan}, {5.0, 5.0}});
  EXPECT_EQ(fitter.ignored_count(), 1u);
  EXPECT_TRUE(fitter.stroke());
}

TEST(InkFitter, R10FarAwayAndTinyAndHugeTolerances) {
  for (const double at : {0.0, 1e3, 1e6, 1e9 - 1e3}) {
    for (const double tolerance : {0.0, 1e-9, 0.15, 1e6}) {
      SCOPED_TRACE(::testing::Message() << at << ' ' << tolerance);
      std::vector<Point> ink;
      for (int i = 0; i < 200; ++i) ink.push_back({at + i, at + 20.0 * std::sin(0.1 * i)});
      InkFitOptions options;
      options.curve.tolerance_mm = tolerance;
      InkFitter fitter(options);
      draw(fitter, ink);
      fitter.refine();
      const Result<Stroke> stroke = fitter.stroke();
      ASSERT_TRUE(stroke) << stroke.error().message;
      EXPECT_LE(testing::worst_error(fitter.curve(), ink),
                std::max(tolerance, kMinSegmentMm) + 1e-15 * at);
    }
  }
}

TEST(InkFitter, R15TheWidthsFollowTheFilteredPressure) {
  TestInk random(17);
  const std::vector<Point> ink = random.draw(testing::InkShape::kSmooth, 600);
  InkFitter fitter({});
  WidthMap map(kPenWidths);
  map.begin();
  fitter.begin();
  std::vector<double> widths;
  for (std::size_t i = 0; i < ink.size(); ++i) {
    const double pressure = 0.5 + 0.4 * std::sin(0.03 * static_cast<double>(i));
    const InkSample sample{ink[i], pressure, static_cast<std::int64_t>(i) * 8'000'000};
    fitter.push(sample);
    widths.push_back(map.push(sample).width_mm);
  }
  fitter.end();
  fitter.refine();
  const Result<Stroke> stroke = fitter.stroke();
  ASSERT_TRUE(stroke);
  for (std::size_t i = 0; i < ink.size(); ++i) {
    EXPECT_NEAR(width_at(stroke->widths(), fitter.curve().sample_u[i]), widths[i], 0.15 + 1e-9);
  }
}

TEST(InkFitter, AMediumWithAToneOfItsOwnIsFittedInBothChannels) {
  const std::vector<Point> ink = TestInk(17).draw(testing::InkShape::kSmooth, 600);
  InkFitOptions options;
  options.width_map.tilt_width = 2.0;
  options.width_map.tone = ToneMapOptions{0.1, 0.9, 1.5, 0.4};
  InkFitter fitter(options);
  WidthMap map(options.width_map);
  fitter.begin();
  std::vector<InkWidth> widths;
  for (std::size_t i = 0; i < ink.size(); ++i) {
    const double x = static_cast<double>(i);
    const InkSample sample{ink[i], 0.5 + 0.4 * std::sin(0.03 * x),
                           static_cast<std::int64_t>(i) * 8'000'000,
                           50.0 + 20.0 * std::cos(0.01 * x)};
    fitter.push(sample);
    widths.push_back(map.push(sample));
  }
  fitter.end();
  fitter.refine();
  const Result<Stroke> stroke = fitter.stroke();
  ASSERT_TRUE(stroke);
  for (std::size_t i = 0; i < ink.size(); ++i) {
    const WidthKnot at = knot_at(stroke->widths(), fitter.curve().sample_u[i]);
    EXPECT_NEAR(at.width_mm, widths[i].width_mm, 0.15 + 1e-9);
    EXPECT_NEAR(at.tone, widths[i].tone, options.width.tone_tolerance + 1e-9);
  }
  EXPECT_EQ(*fitter.stroke(), *stroke);
}

TEST(InkFitter, RefiningMovesTheCurveByAboutTheToleranceAtMost) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    InkFitter fitter({});
    draw(fitter, random.draw(testing::InkShape::kDense, 600));
    const FittedCurve online = fitter.curve();
    fitter.refine();
    const std::vector<Point> before = testing::dense_points(online, 12);
    for (const Point p : testing::dense_points(fitter.curve(), 12)) {
      EXPECT_LE(testing::distance_to_polyline(p, before), 1.1 * 0.15);
    }
  }
}

/// Ends `tried` and checks that it has the stroke of a new fitter with these samples.
void expect_whole(InkFitter& tried, const InkFitOptions& options,
                  std::span<const InkSample> samples) {
  InkFitter whole(options);
  for (const InkSample& sample : samples) whole.push(sample);
  whole.end();
  tried.end();
  EXPECT_TRUE(tried.samples() == whole.samples());
  for (const bool refined : {false, true}) {
    if (refined) whole.refine(), tried.refine();
    const Result<Stroke> stroke = tried.stroke(), expected = whole.stroke();
    ASSERT_TRUE(stroke && expected);
    EXPECT_EQ(*stroke, *expected);
  }
  EXPECT_EQ(tried.faults(), whole.faults());
}

TEST(InkFitter, R7ACopiedStrokeGoesOnLikeItsOriginal) {
  for (const std::uint64_t kind : {0u, 1u, 2u, 3u}) {
    InkFitOptions options;
    options.scheme = kind % 2 == 0 ? FitScheme::kFeltline : FitScheme::kPaper2002;
    options.filter_artefacts = kind >= 2;
    InkFitter original(options), copy(options);
    for (std::uint64_t seed = 0; seed < 15; ++seed) {
      SCOPED_TRACE(::testing::Message() << kind << ' ' << seed);
      std::vector<InkSample> ink;
      for (const Point p : TestInk(seed).draw_any(300)) {
        const double x = static_cast<double>(ink.size());
        ink.push_back({p, 0.5 + 0.4 * std::sin(0.03 * x), static_cast<std::int64_t>(8e6 * x)});
      }
      const std::span<const InkSample> all(ink);
      original.begin();
      for (std::size_t i = 0; i < ink.size(); ++i) {
        original.push(ink[i]);
        if (i % 37 != 5) continue;
        copy.copy_stroke(original);
        expect_whole(copy, options, all.first(i + 1));
        copy.copy_stroke(original);  // over a stroke that was refined
        for (const InkSample& sample : all.subspan(i + 1)) copy.push(sample);
        expect_whole(copy, options, all);
      }
      expect_whole(original, options, all);
      copy.copy_stroke(original);  // of a refined stroke
      EXPECT_EQ(*copy.stroke(), *original.stroke());
    }
  }
}

TEST(InkFitter, R18WithoutPressureTheWidthIsConstant) {
  InkFitter fitter({});
  draw(fitter, TestInk(1).draw(testing::InkShape::kSmooth, 100));
  const Result<Stroke> stroke = fitter.stroke();
  ASSERT_TRUE(stroke);
  EXPECT_EQ(stroke->widths().size(), 2u);
  EXPECT_EQ(stroke->widths().front().width_mm, stroke->widths().back().width_mm);
}

}  // namespace
}  // namespace felt::ink_fitter_test
