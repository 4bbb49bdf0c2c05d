#include "felt/stroke/fit/width_fitter.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "felt/stroke/width_profile.h"

namespace felt::width_fitter_test {
namespace {

constexpr double kTolerance = 0.15;

std::vector<WidthKnot> fit(const std::vector<WidthKnot>& samples, double u_end,
                           const WidthFitOptions& options = {}) {
  WidthFitter fitter(options);
  fitter.begin();
  for (const WidthKnot& s : samples) fitter.push(s.u, s.width_mm);
  fitter.finish(u_end);
  return {fitter.knots().begin(), fitter.knots().end()};
}

double largest_residual(const std::vector<WidthKnot>& samples, const std::vector<WidthKnot>& fit) {
  double worst = 0.0;
  for (const WidthKnot& s : samples) {
    worst = std::max(worst, std::fabs(width_at(fit, s.u) - s.width_mm));
  }
  return worst;
}

// Returns true if I4 and I6 hold.
bool is_profile(const std::vector<WidthKnot>& knots, double u_end) {
  return knots.size() >= 2 && knots.front().u == 0.0 && knots.back().u == u_end &&
         std::adjacent_find(knots.begin(), knots.end(),
                            [](auto a, auto b) { return !(a.u < b.u); }) == knots.end() &&
         std::all_of(knots.begin(), knots.end(),
                     [](auto k) { return k.width_mm >= kMinWidthMm && k.width_mm <= 6.0; });
}

// Returns widths that are sampled on [0, u_end] from a function of u.
template <class Function>
std::vector<WidthKnot> sampled(double u_end, int count, Function width) {
  std::vector<WidthKnot> samples;
  for (int i = 0; i <= count; ++i) {
    const double u = u_end * i / count;
    samples.push_back({u, width(u)});
  }
  return samples;
}

// Counts the knots of the simplest scheme with the same guarantee: a knot wherever the width has
// changed by the tolerance since the last one.
std::size_t knots_by_dead_band(const std::vector<WidthKnot>& samples) {
  std::size_t knots = 2;
  double last = samples.front().width_mm;
  for (const WidthKnot& s : samples) {
    if (std::fabs(s.width_mm - last) <= kTolerance) continue;
    last = s.width_mm;
    ++knots;
  }
  return knots;
}

TEST(WidthFitter, R16ARampOverFiveSegmentsIsOneWidthSegment) {
  const auto samples = sampled(5.0, 400, [](double u) { return 1.0 + 0.8 * u; });
  const auto knots = fit(samples, 5.0);
  ASSERT_EQ(knots.size(), 2u);
  EXPECT_NEAR(knots[0].width_mm, 1.0, 1e-9);
  EXPECT_NEAR(knots[1].width_mm, 5.0, 1e-9);
}

TEST(WidthFitter, R16ASineOverOneSegmentIsSeveralWidthSegments) {
  const auto samples = sampled(1.0, 300, [](double u) { return 2.0 + std::sin(12.0 * u); });
  const auto knots = fit(samples, 1.0);
  EXPECT_GE(knots.size(), 5u);
  EXPECT_LE(knots.size(), 16u);
  EXPECT_LE(largest_residual(samples, knots), kTolerance);
}

TEST(WidthFitter, R17InterpolatesByEquation3) {
  const std::vector<WidthKnot> profile{{0.0, 1.0}, {0.5, 3.0}, {2.0, 0.6}};
  EXPECT_EQ(width_at(profile, 0.5), 3.0);
  EXPECT_NEAR(width_at(profile, 0.125), 0.75 * 1.0 + 0.25 * 3.0, 1e-12);
  EXPECT_NEAR(width_at(profile, 1.1), 0.6 * 3.0 + 0.4 * 0.6, 1e-12);
  EXPECT_EQ(width_at(profile, -1.0), 1.0);
  EXPECT_EQ(width_at(profile, 9.0), 0.6);
  EXPECT_EQ(width_at({}, 1.0), 0.0);
}

TEST(WidthFitter, E11EndsAtTheLastWidthWhereTheToleranceAllows) {
  const auto samples = sampled(1.0, 50, [](double u) { return 2.0 + 0.05 * std::sin(40.0 * u); });
  const auto knots = fit(samples, 1.0);
  ASSERT_EQ(knots.size(), 2u);
  EXPECT_DOUBLE_EQ(knots.back().width_mm, samples.back().width_mm);
}

// Returns a random walk with steps that are often large, samples at the same position, and uneven
// spacing.
std::vector<WidthKnot> random_walk(double u_end) {
  const auto steps = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(-3, 40), rc::gen::inRange(-100, 101))));
  std::vector<WidthKnot> samples;
  double u = 0.0, width = 2.0, total = 0.0;
  for (const auto& [du, dw] : steps) total += std::max(du, 0);
  for (const auto& [du, dw] : steps) {
    // At one position the widths spread by at most 2 tol, because otherwise no profile is within
    // tol of all of them.
    const double step = du > 0 ? dw / 50.0 : 0.0;
    if (du > 0) u += du;
    width = std::clamp(width + step, 0.3, 6.0);
    const double jitter = dw / 100.0 * kTolerance;
    samples.push_back({total > 0.0 ? u_end * (u / total) : 0.0,
                       std::clamp(width + (du > 0 ? 0.0 : jitter * 0.9), 0.3, 6.0)});
  }
  return samples;
}

RC_GTEST_PROP(WidthFitter, R15EverySampleWithinToleranceAndNoJump, ()) {
  const double u_end = *rc::gen::inRange(1, 2000);
  const auto samples = random_walk(u_end);
  const auto knots = fit(samples, u_end);
  RC_ASSERT(is_profile(knots, u_end));
  RC_ASSERT(largest_residual(samples, knots) <= kTolerance);
}

RC_GTEST_PROP(WidthFitter, R15NeverMoreKnotsThanSamples, ()) {
  const auto samples = random_walk(3.0);
  RC_ASSERT(fit(samples, 3.0).size() <= samples.size() + 2);
}

RC_GTEST_PROP(WidthFitter, AnythingGoesInAndAProfileComesOut, ()) {
  const auto samples = *rc::gen::container<std::vector<std::pair<double, double>>>(
      rc::gen::pair(rc::gen::arbitrary<double>(), rc::gen::arbitrary<double>()));
  WidthFitter fitter;
  fitter.begin();
  for (const auto& [u, w] : samples) fitter.push(u, w);
  fitter.finish(2.0);
  RC_ASSERT(is_profile({fitter.knots().begin(), fitter.knots().end()}, 2.0));
}

TEST(WidthFitter, NeedsHalfTheKnotsOfADeadBand) {
  std::size_t ours = 0, naive = 0;
  std::uint64_t state = 7;
  for (int stroke = 0; stroke < 20; ++stroke) {
    double noise = 0.0;
    const auto samples = sampled(8.0, 500, [&](double u) {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      noise = 0.9 * noise + 0.06 * (static_cast<double>(state >> 33) / 4294967296.0 - 0.25);
      return 2.0 + std::sin(u + stroke) + noise;
    });
    const auto knots = fit(samples, 8.0);
    EXPECT_LE(largest_residual(samples, knots), kTolerance);
    ours += knots.size();
    naive += knots_by_dead_band(samples);
  }
  EXPECT_LE(2 * ours, naive);
}

std::vector<WidthKnot> fit_both(const std::vector<WidthKnot>& samples, double u_end,
                                const WidthFitOptions& options = {}) {
  WidthFitter fitter(options);
  fitter.begin();
  for (const WidthKnot& s : samples) fitter.push(s.u, s.width_mm, s.tone);
  fitter.finish(u_end);
  return {fitter.knots().begin(), fitter.knots().end()};
}

double largest_tone_residual(const std::vector<WidthKnot>& samples,
                             const std::vector<WidthKnot>& fit) {
  double worst = 0.0;
  for (const WidthKnot& s : samples) {
    worst = std::max(worst, std::fabs(tone_at(fit, s.u) - s.tone));
  }
  return worst;
}

// Adds tones that vary independently of the widths.
std::vector<WidthKnot> with_random_tones(std::vector<WidthKnot> samples) {
  double tone = 0.5, u = -1.0;
  for (WidthKnot& s : samples) {
    if (s.u > u) tone = std::clamp(tone + *rc::gen::inRange(-100, 101) / 300.0, 0.0, 1.0);
    u = s.u;
    s.tone = tone;
  }
  return samples;
}

RC_GTEST_PROP(WidthFitter, BothChannelsKeepToTheirTolerances, ()) {
  const double u_end = *rc::gen::inRange(1, 2000);
  const auto samples = with_random_tones(random_walk(u_end));
  const WidthFitOptions options{.tone_tolerance = *rc::gen::element(0.02, 0.1, 0.5)};
  const auto knots = fit_both(samples, u_end, options);
  RC_ASSERT(is_profile(knots, u_end));
  RC_ASSERT(largest_residual(samples, knots) <= kTolerance);
  RC_ASSERT(largest_tone_residual(samples, knots) <= options.tone_tolerance);
  RC_ASSERT(std::all_of(knots.begin(), knots.end(),
                        [](auto k) { return k.tone >= 0.0 && k.tone <= 1.0; }));
  RC_ASSERT(fit_both(samples, u_end, options) == knots);
}

RC_GTEST_PROP(WidthFitter, InkWithoutAToneOfItsOwnNeedsNoKnotForIt, ()) {
  const auto samples = random_walk(5.0);
  const auto knots = fit(samples, 5.0);
  for (const WidthKnot& k : knots) RC_ASSERT(k.tone == tone_of_width(k.width_mm));
  // A tolerance of the whole range of tones does not affect the widths.
  const auto free = fit_both(samples, 5.0, {.tone_tolerance = 1.0});
  RC_ASSERT(free.size() == knots.size());
  for (std::size_t i = 0; i < knots.size(); ++i) {
    RC_ASSERT(free[i].u == knots[i].u && free[i].width_mm == knots[i].width_mm);
  }
}

TEST(WidthFitter, AToneThatTurnsUnderAnEvenWidthGetsKnotsOfItsOwn) {
  auto samples = sampled(4.0, 400, [](double) { return 2.0; });
  for (WidthKnot& s : samples) s.tone = 1.0 - std::fabs(s.u - 2.0) / 2.0;
  const auto knots = fit_both(samples, 4.0);
  EXPECT_GE(knots.size(), 3u);
  EXPECT_LE(knots.size(), 4u);
  EXPECT_LE(largest_tone_residual(samples, knots), WidthFitOptions{}.tone_tolerance);
}

TEST(WidthFitter, TonesThatAreNoneAreLeftOut) {
  WidthFitter fitter;
  fitter.begin();
  fitter.push(0.0, 1.0, 0.5);
  fitter.push(0.5, 1.0, std::numeric_limits<double>::quiet_NaN());
  fitter.push(1.0, 1.0, 7.0);
  fitter.finish(1.0);
  const std::vector<WidthKnot> expected{{0.0, 1.0, 0.5}, {1.0, 1.0, 1.0}};
  EXPECT_EQ(std::vector<WidthKnot>(fitter.knots().begin(), fitter.knots().end()), expected);
}

TEST(WidthFitter, AStepAtOnePlaceIsMissedByHalfItsHeight) {
  const std::vector<WidthKnot> samples{{0.0, 1.0}, {0.5, 1.0}, {0.5, 3.0}, {1.0, 3.0}};
  const auto knots = fit(samples, 1.0);
  EXPECT_TRUE(is_profile(knots, 1.0));
  EXPECT_NEAR(width_at(knots, 0.5), 2.0, 1e-9);
  EXPECT_LE(std::fabs(width_at(knots, 0.0) - 1.0), kTolerance);
  EXPECT_LE(std::fabs(width_at(knots, 1.0) - 3.0), kTolerance);
}

TEST(WidthFitter, OneSampleAndNoneGiveAConstantProfile) {
  EXPECT_EQ(fit({{0.3, 1.25}}, 1.0),
            (std::vector<WidthKnot>{{0.0, 1.25}, {0.3, 1.25}, {1.0, 1.25}}));
  EXPECT_EQ(fit({{1.0, 1.25}}, 1.0), (std::vector<WidthKnot>{{0.0, 1.25}, {1.0, 1.25}}));
  EXPECT_EQ(fit({}, 3.0), (std::vector<WidthKnot>{{0.0, 0.05}, {3.0, 0.05}}));
}

TEST(WidthFitter, ToleranceZeroMeetsEverySample) {
  const auto samples = sampled(2.0, 60, [](double u) { return 2.0 + std::sin(9.0 * u); });
  EXPECT_LE(largest_residual(samples, fit(samples, 2.0, {.tolerance_mm = 0.0})), 1e-12);
}

/// What is known while a stroke is drawn is the profile that comes, up to the last breakpoint.
TEST(WidthFitter, TheOpenSegmentEndsNearTheLastSample) {
  const auto samples = sampled(20.0, 500, [](double u) { return 3.0 + 2.0 * std::sin(3.0 * u); });
  const auto whole = fit(samples, 20.0);
  WidthFitter fitter;
  fitter.begin();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    fitter.push(samples[i].u, samples[i].width_mm);
    if (i == 0) continue;
    const auto knots = fitter.knots();
    ASSERT_TRUE(std::equal(knots.begin(), knots.end(), whole.begin()));
    const WidthKnot end = fitter.open_end();
    ASSERT_EQ(end.u, samples[i - 1].u);  // the last position still collects samples
    ASSERT_NEAR(end.width_mm, samples[i - 1].width_mm, kTolerance);
  }
}

TEST(WidthFitter, IsReusedWithoutGrowing) {
  WidthFitter fitter;
  const auto samples = sampled(20.0, 5000, [](double u) { return 3.0 + 2.0 * std::sin(30.0 * u); });
  const WidthKnot* buffer = nullptr;
  for (int round = 0; round < 3; ++round) {
    fitter.begin();
    for (const WidthKnot& s : samples) fitter.push(s.u, s.width_mm);
    fitter.finish(20.0);
    if (round > 0) {
      EXPECT_EQ(fitter.knots().data(), buffer);
    }
    buffer = fitter.knots().data();
  }
}

}  // namespace
}  // namespace felt::width_fitter_test
