#include "felt/trial/trial_metrics.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

#include "felt/geometry/polyline.h"
#include "felt/trial/spectrum.h"
#include "felt/trial/trial_columns.h"
#include "felt/trial/trial_parts.h"

namespace felt::trial_metrics_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr std::int64_t kMs = 1'000'000;

// Samples in contact, one per millisecond.
std::vector<TrialSample> drawn(const std::vector<Point>& points) {
  std::vector<TrialSample> samples;
  for (const Point p : points) {
    samples.push_back({.time_ns = static_cast<std::int64_t>(samples.size()) * kMs,
                       .position = p,
                       .contact = true});
  }
  return samples;
}

std::vector<Point> line_of(Point from, Point to, int count) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
    points.push_back(lerp(from, to, static_cast<double>(i) / (count - 1)));
  return points;
}

std::vector<Point> circle_of(double radius_mm, int count, double turns = 1.0) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * turns * i / count;
    points.push_back(Point{50.0, 50.0} + radius_mm * Vec{std::cos(angle), std::sin(angle)});
  }
  return points;
}

// A curve that wanders about a straight path like the line of a hand, with two lifts.
std::vector<TrialSample> wandering(double amplitude_mm) {
  std::vector<TrialSample> samples;
  for (int i = 0; i < 1200; ++i) {
    const double t = 1e-3 * i, share = t / 1.2;
    TrialSample sample{.time_ns = i * kMs};
    sample.position = {40.0 * share + 0.5 * std::sin(9.0 * t),
                       amplitude_mm * (std::sin(7.0 * t) + 0.3 * std::cos(31.0 * t))};
    sample.contact = i > 40 && !(i > 500 && i < 530) && !(i > 900 && i < 910);
    sample.pressure = 0.5 + 0.2 * std::sin(5.0 * t);
    sample.force_n = Vec{0.4 * std::sin(3.0 * t), 0.6 * std::cos(11.0 * t)};
    samples.push_back(sample);
  }
  return samples;
}

const std::vector<Point> kStraight = {{0, 0}, {40, 0}};
const std::vector<Point> kBent = {{0, 0}, {15, 3}, {28, -4}, {40, 0}};

TEST(TrialMetrics, ALineBesideThePathIsAsFarAsItIs) {
  const auto m = measure_trial(drawn(line_of({0, 0.5}, {40, 0.5}, 400)), kStraight,
                               {.tunnel_width_mm = 2.0, .target_width_mm = 4.0});
  EXPECT_NEAR(*m.err_mean_mm, 0.5, 1e-12);
  EXPECT_NEAR(*m.err_rms_mm, 0.5, 1e-12);
  EXPECT_NEAR(*m.err_p95_mm, 0.5, 1e-12);
  EXPECT_NEAR(*m.err_max_mm, 0.5, 1e-12);
  EXPECT_NEAR(*m.frechet_mm, 0.5, 1e-12);
  EXPECT_NEAR(*m.err_signed_mm, 0.5, 1e-12);  // y points down: to the right
  EXPECT_NEAR(*m.direction_err_deg, 0.0, 1e-6);
  EXPECT_NEAR(*m.area_mm2, 20.0, 1e-9);
  EXPECT_EQ(m.coverage, 1.0);
  EXPECT_EQ(m.out_of_tunnel_share, 0.0);
  EXPECT_EQ(m.steering_id, 20.0);
  EXPECT_NEAR(*m.speed_mean_mm_per_s, 40.0 / 0.399, 1e-9);
  EXPECT_EQ(m.axis_crossings, 0.0);
  EXPECT_EQ(m.direction_changes, 0.0);
  EXPECT_EQ(m.orthogonal_changes, 0.0);
  EXPECT_EQ(m.target_reentries, 0.0);
  EXPECT_NEAR(*m.movement_offset_mm, 0.5, 1e-12);
  EXPECT_NEAR(*m.movement_error_mm, 0.5, 1e-12);
  EXPECT_NEAR(*m.movement_variability_mm, 0.0, 1e-12);
}

TEST(TrialMetrics, TheTotalErrorCountsTheHeightOverItsMedian) {
  std::vector<TrialSample> samples = drawn(line_of({0, 0.4}, {40, 0.4}, 399));
  EXPECT_EQ(measure_trial(samples, kStraight).err_total_mm, std::nullopt);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].height_mm = -2.0 + 0.3 * (static_cast<double>(i % 3) - 1.0);
  }
  const auto m = measure_trial(samples, kStraight);
  EXPECT_NEAR(*m.err_total_mm, (0.5 + 0.4 + 0.5) / 3.0, 1e-12);
  EXPECT_NEAR(*m.err_mean_mm, 0.4, 1e-12);
  samples[0].height_mm = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(measure_trial(samples, kStraight).samples_ignored, 1.0);
}

TEST(TrialMetrics, AMissingHalfIsSeenFromThePathOnly) {
  const auto m = measure_trial(drawn(line_of({0, 0}, {20, 0}, 200)), kStraight);
  EXPECT_NEAR(*m.err_max_mm, 20.0, 1e-12);
  EXPECT_NEAR(*m.frechet_mm, 20.0, 1e-9);
  // 81 points of the path, the last 40 of them at 0.5, 1.0 ... 20 mm; those up to 1 mm are covered.
  EXPECT_NEAR(*m.err_mean_mm, 0.5 * (0.5 * 40 * 41 / 2) / 81, 1e-12);
  EXPECT_NEAR(*m.coverage, 43.0 / 81.0, 1e-12);
  EXPECT_EQ(m.out_of_tunnel_share, std::nullopt);
}

TEST(TrialMetrics, OvershootIsAnErrorToNoSide) {
  const auto m = measure_trial(drawn(line_of({0, 0}, {45, 0}, 100)), kStraight);
  EXPECT_NEAR(*m.err_max_mm, 5.0, 1e-12);
  EXPECT_NEAR(*m.err_signed_mm, 0.0, 1e-12);
}

TEST(TrialMetrics, ALargerCircleIsToTheLeftOfAClockwiseOne) {
  const TrialGeometry closed{.ends = TrialPathEnds::kClosed};
  auto ink = circle_of(10.5, 4000);
  ink.push_back(ink.front());
  const auto m = measure_trial(drawn(ink), circle_of(10.0, 4000), closed);
  EXPECT_NEAR(*m.err_mean_mm, 0.5, 1e-4);
  EXPECT_NEAR(*m.err_max_mm, 0.5, 1e-4);
  EXPECT_NEAR(*m.err_signed_mm, -0.5, 1e-4);
  EXPECT_NEAR(*m.frechet_mm, 0.5, 1e-2);
  EXPECT_NEAR(*m.area_mm2, 0.5 * 2.0 * std::numbers::pi * 10.5, 1e-2);
  EXPECT_NEAR(*m.path_length_mm, 2.0 * std::numbers::pi * 10.0, 1e-3);
  EXPECT_EQ(m.movement_error_mm, std::nullopt);  // not a straight path
}

TEST(TrialMetrics, AClosedPathMayBeginAnywhereInBothDirections) {
  const TrialGeometry closed{.ends = TrialPathEnds::kClosed};
  const auto path = circle_of(10.0, 400);
  std::vector<Point> ink;
  for (int i = 0; i <= 400; ++i) ink.push_back(path[static_cast<std::size_t>(800 + 130 - i) % 400]);
  const auto m = measure_trial(drawn(ink), path, closed);
  EXPECT_LT(*m.frechet_mm, 1e-9);
  EXPECT_LT(*m.direction_err_deg, 1.0);
}

TEST(TrialMetrics, TheFrechetDistanceSeesTheOrder) {
  // The ink is on the path, but goes back 10 mm in the middle.
  const auto m = measure_trial(drawn({{0, 0}, {25, 0}, {15, 0}, {40, 0}}), kStraight);
  EXPECT_LT(*m.err_max_mm, 1e-9);
  EXPECT_NEAR(*m.frechet_mm, 5.0, 0.3);
  EXPECT_EQ(m.orthogonal_changes, 2.0);
}

TEST(TrialMetrics, TheSidesOfACornerAreKnown) {
  // At the sharp corner (10, 0), a sample beyond it is nearest to both lines.
  const std::vector<Point> path = {{0, 0}, {10, 0}, {0, 2}};
  EXPECT_NEAR(*measure_trial(drawn({{11, 0.1}}), path).err_signed_mm, -std::hypot(1.0, 0.1), 1e-12);
  EXPECT_NEAR(*measure_trial(drawn({{11, 0.9}}), path).err_signed_mm, -std::hypot(1.0, 0.9), 1e-12);
}

TEST(TrialMetrics, MeasuresOfMacKenzieOnAZigzag) {
  const auto m =
      measure_trial(drawn({{0, 1}, {10, -1}, {20, 1}, {15, 2}, {40, -1}, {44, 0}, {40, 0}}),
                    kStraight, {.target_width_mm = 4.0});
  EXPECT_EQ(m.axis_crossings, 3.0);
  EXPECT_EQ(m.direction_changes, 3.0);
  EXPECT_EQ(m.orthogonal_changes, 3.0);
  EXPECT_EQ(m.target_reentries, 1.0);
  EXPECT_NEAR(*m.movement_error_mm, 6.0 / 7.0, 1e-12);
  EXPECT_NEAR(*m.movement_offset_mm, 2.0 / 7.0, 1e-12);
  EXPECT_NEAR(*m.movement_variability_mm, std::sqrt((8.0 - 4.0 / 7.0) / 6.0), 1e-12);
}

TEST(TrialMetrics, TimesOfHoverAndLifts) {
  std::vector<TrialSample> samples;
  for (int i = 0; i < 10; ++i) {
    const bool contact = i == 2 || i == 3 || i == 6 || i == 7;
    samples.push_back({.time_ns = i * 100 * kMs, .position = {1.0 * i, 0}, .contact = contact});
  }
  const auto m = measure_trial(samples, kStraight);
  EXPECT_NEAR(*m.reaction_s, 0.2, 1e-12);
  EXPECT_NEAR(*m.movement_s, 0.5, 1e-12);
  EXPECT_NEAR(*m.in_air_s, 0.3, 1e-12);
  EXPECT_EQ(m.lifts, 1.0);
  EXPECT_NEAR(*m.ink_length_mm, 2.0, 1e-12);
  EXPECT_NEAR(*m.speed_mean_mm_per_s, 10.0, 1e-9);
}

TEST(TrialMetrics, ForceWorkAndPressure) {
  auto samples = drawn(line_of({0, 0}, {10, 0}, 101));
  for (TrialSample& sample : samples) {
    sample.force_n = sample.position.x < 4.95 ? Vec{-0.4, 0.3} : Vec{0.0, 1.0};
    sample.pressure = 0.4;
  }
  const auto m = measure_trial(samples, kStraight);
  EXPECT_NEAR(*m.work_mj, -0.4 * 4.95, 1e-9);  // the step at 4.95 mm counts half
  EXPECT_NEAR(*m.force_impulse_n_s, 0.1 * (0.5 * 0.495 + 1.0 * 0.505), 1e-9);
  EXPECT_NEAR(*m.force_mean_n, 0.5 * 0.495 + 1.0 * 0.505, 1e-9);
  EXPECT_NEAR(*m.force_above_half_n_share, 0.505, 1e-9);
  EXPECT_NEAR(*m.pressure_mean, 0.4, 1e-12);
  EXPECT_NEAR(*m.pressure_cv, 0.0, 1e-12);
}

TEST(TrialMetrics, TheTwoThirdsPowerLawIsFoundOnAnEllipse) {
  // An ellipse drawn with harmonic motion obeys the law with the exponent -1/3 exactly.
  std::vector<Point> ink;
  for (int i = 0; i < 3000; ++i)
    ink.push_back({20.0 * std::cos(6e-3 * i), 8.0 * std::sin(6e-3 * i)});
  const auto m = measure_trial(drawn(ink), kStraight);
  EXPECT_NEAR(*m.power_law_exponent, -1.0 / 3.0, 1e-3);
  EXPECT_GT(*m.power_law_r2, 0.99);
  EXPECT_NEAR(*m.velocity_peaks_per_s, 2.0 * 6.0 / (2.0 * std::numbers::pi), 0.2);
  EXPECT_LT(*m.power_share_3_12_hz, 0.01);
}

TEST(TrialMetrics, TremorMakesAMovementLessSmooth) {
  const auto movement = [](double tremor_mm) {
    std::vector<Point> ink;
    for (int i = 0; i < 2000; ++i) {
      const double u = i / 2000.0;
      const double reach = u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);  // the smoothest movement
      ink.push_back({40.0 * reach + tremor_mm * std::sin(2.0 * std::numbers::pi * 6e-3 * i), 0.0});
    }
    return measure_trial(drawn(ink), kStraight);
  };
  const auto steady = movement(0.0), shaking = movement(0.5);
  EXPECT_NEAR(*steady.sparc, -1.4, 0.1);  // doi:10.1186/s12984-015-0090-9 has about -1.4
  EXPECT_LT(*shaking.sparc, *steady.sparc);
  // The minimum-jerk movement has 720 D^2 / T^5; its largest speed is 1.875 D / T.
  EXPECT_NEAR(*steady.log_dimensionless_jerk, -std::log(720.0 / (1.875 * 1.875)), 0.2);
  EXPECT_LT(*shaking.log_dimensionless_jerk, *steady.log_dimensionless_jerk);
  EXPECT_LT(*steady.power_share_3_12_hz, 0.01);
  EXPECT_GT(*shaking.power_share_3_12_hz, 0.3);
  EXPECT_NEAR(*steady.velocity_peaks_per_s, 0.5, 0.01);
}

TEST(TrialMetrics, InvalidSamplesAreIgnoredAndCounted) {
  auto samples = drawn(line_of({0, 0.5}, {40, 0.5}, 400));
  const auto expected = measure_trial(samples, kStraight);
  TrialSample broken = samples[100];
  for (const double bad : {kNan, kInf, -kInf, 1e12}) {
    TrialSample a = broken, b = broken, c = broken;
    a.position.y = bad;
    b.pressure = bad;
    c.force_n = Vec{0, bad};
    samples.insert(samples.begin() + 101, {a, b, c});
  }
  samples.insert(samples.begin() + 101, broken);  // the same time twice
  const auto m = measure_trial(samples, kStraight);
  EXPECT_EQ(m.samples, 400.0);
  EXPECT_EQ(m.samples_ignored, 13.0);
  EXPECT_EQ(m.err_mean_mm, expected.err_mean_mm);
  EXPECT_EQ(m.movement_s, expected.movement_s);
}

TEST(TrialMetrics, WithoutContactOrSamplesOnlyCountsAndThePathAreDefined) {
  auto hover = drawn(line_of({0, 0}, {40, 0}, 10));
  for (TrialSample& sample : hover) sample.contact = false;
  for (const auto& samples : {std::vector<TrialSample>{}, hover}) {
    const auto m = measure_trial(samples, kStraight, {.tunnel_width_mm = 4.0});
    for (const TrialColumn& column : trial_metric_columns()) {
      const bool known = column.name.starts_with("samples") || column.name == "path_length_mm" ||
                         column.name == "steering_id";
      EXPECT_EQ((m.*column.value).has_value(), known) << column.name;
    }
  }
}

TEST(TrialMetrics, OneSampleAndPathsWithoutLength) {
  const auto one = measure_trial(drawn({{3, 4}}), std::vector<Point>{{0, 0}, {0, 0}});
  EXPECT_EQ(one.err_mean_mm, 5.0);
  EXPECT_EQ(one.err_max_mm, 5.0);
  EXPECT_EQ(one.frechet_mm, 5.0);
  EXPECT_EQ(one.coverage, 0.0);
  EXPECT_EQ(one.path_length_mm, 0.0);
  EXPECT_EQ(one.err_signed_mm, std::nullopt);
  EXPECT_EQ(one.direction_err_deg, std::nullopt);
  EXPECT_EQ(one.speed_mean_mm_per_s, std::nullopt);
  EXPECT_EQ(one.movement_error_mm, std::nullopt);
  EXPECT_EQ(one.movement_s, 0.0);

  const auto no_path = measure_trial(wandering(1.0), {});
  EXPECT_EQ(no_path.err_mean_mm, std::nullopt);
  EXPECT_EQ(no_path.path_length_mm, std::nullopt);
  EXPECT_TRUE(no_path.sparc.has_value());
  const auto bad_path = measure_trial(wandering(1.0), std::vector<Point>{{kNan, 0}, {0, kInf}});
  EXPECT_EQ(bad_path.err_mean_mm, std::nullopt);
}

TEST(TrialMetrics, ExtremeTimesAndAStillPenAreSafe) {
  constexpr auto kFirst = std::numeric_limits<std::int64_t>::min();
  constexpr auto kLast = std::numeric_limits<std::int64_t>::max();
  std::vector<TrialSample> samples;
  for (const std::int64_t t : {kFirst, std::int64_t{-1}, std::int64_t{0}, kLast})
    samples.push_back({.time_ns = t, .position = {1e9, -1e9}, .contact = true});
  const auto m =
      measure_trial(samples, kStraight, {.tunnel_width_mm = kNan, .target_width_mm = -1.0});
  EXPECT_NEAR(*m.movement_s, 0x1p64 * 1e-9, 1.0);
  EXPECT_EQ(m.sparc, std::nullopt);
  EXPECT_EQ(m.steering_id, std::nullopt);
  EXPECT_EQ(m.target_reentries, std::nullopt);
}

RC_GTEST_PROP(TrialMetrics, RigidMotionsChangeNothing, ()) {
  const double angle = *rc::gen::inRange(0, 6283) * 1e-3;
  const Vec shift{1.0 * *rc::gen::inRange(-200, 200), 1.0 * *rc::gen::inRange(-200, 200)};
  const auto turned = [&](Vec v) {
    return Vec{std::cos(angle) * v.x - std::sin(angle) * v.y,
               std::sin(angle) * v.x + std::cos(angle) * v.y};
  };
  auto samples = wandering(1.5);
  auto path = kBent;
  const TrialGeometry geometry{.tunnel_width_mm = 3.0};
  const auto before = measure_trial(samples, path, geometry);
  for (TrialSample& sample : samples) {
    sample.position = Point{} + turned(sample.position - Point{}) + shift;
    sample.force_n = turned(*sample.force_n);
  }
  for (Point& p : path) p = Point{} + turned(p - Point{}) + shift;
  const auto after = measure_trial(samples, path, geometry);
  for (const TrialColumn& column : trial_metric_columns()) {
    RC_ASSERT((before.*column.value).has_value() == (after.*column.value).has_value());
    if (!(before.*column.value)) continue;
    RC_ASSERT(std::abs(*(before.*column.value) - *(after.*column.value)) < 1e-6);
  }
}

TEST(TrialMetrics, DistancesAreHomogeneous) {
  // Positions, steps along the lines and thresholds are in mm, so only what does not use a step is
  // exactly proportional.
  auto samples = wandering(1.5);
  auto path = kStraight;
  const auto before = measure_trial(samples, path);
  for (TrialSample& sample : samples)
    sample.position = {2.0 * sample.position.x, 2.0 * sample.position.y};
  for (Point& p : path) p = {2.0 * p.x, 2.0 * p.y};
  const auto after = measure_trial(samples, path);
  for (const auto length :
       {&TrialMetrics::ink_length_mm, &TrialMetrics::speed_mean_mm_per_s,
        &TrialMetrics::movement_error_mm, &TrialMetrics::movement_variability_mm,
        &TrialMetrics::movement_offset_mm, &TrialMetrics::work_mj})
    EXPECT_NEAR(*(after.*length), 2.0 * *(before.*length), 1e-9);
  EXPECT_NEAR(*after.area_mm2, 4.0 * *before.area_mm2, 1e-9);
  EXPECT_NEAR(*after.err_mean_mm, 2.0 * *before.err_mean_mm, 0.02);
  for (const auto same : {&TrialMetrics::sparc, &TrialMetrics::log_dimensionless_jerk,
                          &TrialMetrics::power_law_exponent, &TrialMetrics::power_share_3_12_hz,
                          &TrialMetrics::velocity_peaks_per_s})
    EXPECT_NEAR(*(after.*same), *(before.*same), 0.05);
}

TEST(TrialMetrics, LongTrialsAreMeasured) {
  std::vector<Point> ink;
  for (int i = 0; i < 100'000; ++i)
    ink.push_back(
        {50.0 + 40.0 * std::sin(3e-3 * i) + 1e-4 * i, 50.0 + 40.0 * std::cos(2.1e-3 * i)});
  const auto m = measure_trial(drawn(ink), circle_of(40.0, 2000), {.ends = TrialPathEnds::kClosed});
  EXPECT_TRUE(m.err_mean_mm && m.frechet_mm && m.sparc && m.power_share_3_12_hz);
}

TEST(TrialColumns, EveryMetricIsInTheTableOnce) {
  std::set<std::string_view> names;
  for (const TrialColumn& column : trial_metric_columns()) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_TRUE(column.formula.ends_with(".")) << column.name;
    EXPECT_FALSE(column.unit.empty()) << column.name;
    EXPECT_TRUE(column.source.empty() || column.source.starts_with("10.")) << column.source;
  }
  EXPECT_EQ(names.size() * sizeof(TrialMetrics::Value), sizeof(TrialMetrics));
  EXPECT_EQ(trial_metric_text(std::nullopt), "NA");
  EXPECT_EQ(trial_metric_text(0.1), "0.1");
}

RC_GTEST_PROP(LineTree, FindsTheNearestLineLikeASearchOfAll, ()) {
  const auto point =
      rc::gen::map(rc::gen::pair(rc::gen::inRange(-20, 20), rc::gen::inRange(-20, 20)),
                   [](std::pair<int, int> p) {
                     return Point{0.5 * p.first, 0.5 * p.second};
                   });
  const auto line = *rc::gen::container<std::vector<Point>>(point);
  RC_PRE(line.size() > 1);
  const Point p = *point;
  std::vector<LineTree::Line> lines;
  for (std::size_t i = 1; i < line.size(); ++i) lines.push_back({line[i - 1], line[i]});
  const PolylineNearest found = LineTree(lines).nearest(p), wanted = nearest_on_polyline(line, p);
  RC_ASSERT(found.distance_squared == wanted.distance_squared);
  RC_ASSERT(found.index == wanted.index);
}

TEST(Spectrum, AWaveHasOneFrequency) {
  std::vector<double> wave;
  for (int i = 0; i < 64; ++i) wave.push_back(std::cos(2.0 * std::numbers::pi * 5.0 * i / 64.0));
  const auto bins = spectrum(wave, 64);
  for (std::size_t k = 0; k < 64; ++k)
    EXPECT_NEAR(std::abs(bins[k]), k == 5 || k == 59 ? 32.0 : 0.0, 1e-12) << k;
}

}  // namespace
}  // namespace felt::trial_metrics_test
