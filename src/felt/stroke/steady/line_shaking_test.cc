#include "felt/stroke/steady/line_shaking.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/stroke/steady/shake_smoother.h"

namespace felt::line_shaking_test {
namespace {

constexpr double kStepS = ShakeSmoother::kStepS;

/// A shaking line at nodes: an arc, and a shaking of 1 mm whose frequency rises from 4.5 to 6.5 Hz.
struct ArcRun {
  std::vector<Vec> nodes, shaking;
  std::vector<double> steps_s, hz;

  explicit ArcRun(std::size_t count, double step_s = kStepS) {
    double phase = 0.3;
    for (std::size_t k = 0; k < count; ++k) {
      const double u = static_cast<double>(k) / static_cast<double>(count);
      hz.push_back(4.5 + 2.0 * u);
      shaking.push_back({std::cos(phase), 0.3 * std::sin(phase)});
      nodes.push_back(Vec{40.0 * std::sin(2.0 * u), 40.0 * std::cos(2.0 * u)} + shaking.back());
      steps_s.push_back(step_s);
      phase += kTau * hz.back() * step_s;
    }
  }
};

double rms_difference(std::span<const Vec> a, std::span<const Vec> b, std::size_t from = 0) {
  double sum = 0.0;
  for (std::size_t i = from; i < a.size(); ++i) sum += norm_squared(a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size() - from));
}

/// Solves a x = b by Gauss with pivots; a is n by n, row by row.
std::vector<double> solution(std::vector<double> a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t i = k; i < n; ++i) {
      if (std::fabs(a[i * n + k]) > std::fabs(a[best * n + k])) best = i;
    }
    for (std::size_t j = 0; j < n; ++j) std::swap(a[k * n + j], a[best * n + j]);
    std::swap(b[k], b[best]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double f = a[i * n + k] / a[k * n + k];
      for (std::size_t j = k; j < n; ++j) a[i * n + j] -= f * a[k * n + j];
      b[i] -= f * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k * n + j] * b[j];
    b[k] /= a[k * n + k];
  }
  return b;
}

/// Returns the shaking along the axis that one pass must find: the least squares of all equations
/// of ShakeSmoother, solved as one dense system. The numbers are those of shake_smoother.cc.
std::vector<double> by_least_squares(const std::vector<Vec>& nodes, double hz, double jerk,
                                     double swing_mm) {
  const std::size_t n = nodes.size(), size = 3 * n;
  std::vector<double> a(size * size), b(size);
  const auto add = [&](std::initializer_list<std::pair<std::size_t, double>> row, double value,
                       double variance) {
    for (const auto& [i, f] : row) {
      b[i] += f * value / variance;
      for (const auto& [j, g] : row) a[i * size + j] += f * g / variance;
    }
  };
  const double decay = std::exp(-kStepS / 2.5), angle = kTau * hz * kStepS;
  const double c = decay * std::cos(angle), s = decay * std::sin(angle);
  const double swing = swing_mm * swing_mm, fresh = swing * (1.0 - decay * decay);
  add({{1, 1.0}}, 0.0, swing);
  add({{2, 1.0}}, 0.0, swing);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t x = 3 * k;
    add({{x, 1.0}, {x + 1, 1.0}}, nodes[k].x, 1e-4);
    if (k + 3 < n) {
      add({{x, -1.0}, {x + 3, 3.0}, {x + 6, -3.0}, {x + 9, 1.0}}, 0.0,
          jerk * jerk / 133.0 * std::pow(kStepS, 5.0));
    }
    if (k + 1 < n) {
      add({{x + 4, 1.0}, {x + 1, -c}, {x + 2, s}}, 0.0, fresh);
      add({{x + 5, 1.0}, {x + 1, -s}, {x + 2, -c}}, 0.0, fresh);
    }
  }
  std::vector<double> found = solution(a, b), shaking;
  for (std::size_t k = 0; k < n; ++k) shaking.push_back(found[3 * k + 1]);
  return shaking;
}

TEST(ShakeSmoother, APassSolvesTheLeastSquaresOfTheWholeLine) {
  for (const std::size_t count : {1u, 2u, 3u, 4u, 5u, 60u}) {
    const ArcRun run(count);
    ShakeSmoother smoother(run.nodes, kStepS, 5.0, {0.7, 0.35});
    const auto got = smoother.shaking({5.5, 6000.0}, 1);
    const std::vector<double> wanted = by_least_squares(run.nodes, 5.5, 6000.0, 0.7);
    for (std::size_t k = 0; k < count; ++k) ASSERT_NEAR(got[k].x, wanted[k], 1e-6) << count;
  }
}

TEST(ShakeSmoother, LearnsTheFrequencyAtEachMoment) {
  const ArcRun run(500);
  ShakeSmoother smoother(run.nodes, kStepS, 5.5, {0.7, 0.35});
  const double at_first = rms_difference(smoother.shaking({5.5, 8000.0}, 1), run.shaking);
  const double learnt = rms_difference(smoother.shaking({5.5, 8000.0}, 8), run.shaking);
  EXPECT_LT(learnt, 0.06);
  EXPECT_LT(learnt, 0.5 * at_first);
  for (const std::size_t k : {60u, 250u, 440u}) EXPECT_NEAR(smoother.hz(k), run.hz[k], 0.25) << k;
}

TEST(ShakeSmoother, LearnsTheJerkOfTheIntendedMotion) {
  Random random(7);
  for (const double jerk : {3000.0, 30000.0}) {
    std::vector<Vec> nodes;
    Vec x, v, a;
    for (int k = 0; k < 800; ++k) {
      nodes.push_back(x);
      const double noise = jerk * std::sqrt(kStepS / 133.0);
      a += noise * Vec{random.normal(), random.normal()};
      v += kStepS * a;
      x += kStepS * v;
    }
    ShakeSmoother smoother(nodes, kStepS, 5.0, {0.7, 0.35});
    smoother.shaking({5.0, 8000.0}, 30);
    EXPECT_NEAR(std::log(smoother.jerk_mm_per_s3() / jerk), 0.0, std::log(2.0)) << jerk;
  }
}

TEST(LineShaking, TheRateOfTheSamplesHardlyMatters) {
  for (const double step_s : {0.001, 0.002, 0.0075, 0.012, 0.02}) {
    const ArcRun run(static_cast<std::size_t>(4.0 / step_s), step_s);
    const LineShaking found = find_line_shaking(run.nodes, run.steps_s, {5.5, {0.7, 0.35}});
    ASSERT_EQ(found.shaking_mm.size(), run.nodes.size());
    EXPECT_LT(rms_difference(found.shaking_mm, run.shaking), 0.1) << step_s;
  }
}

TEST(LineShaking, ALongLineKeepsItsShakingToo) {
  const ArcRun run(static_cast<std::size_t>(70.0 / kStepS));
  const LineShaking found = find_line_shaking(run.nodes, run.steps_s, {5.5, {0.7, 0.35}});
  EXPECT_LT(rms_difference(found.shaking_mm, run.shaking), 0.1);
}

TEST(LineShaking, EmptyLinesAndDotsHaveNone) {
  EXPECT_TRUE(find_line_shaking({}, {}, {}).shaking_mm.empty());
  const std::vector<Vec> dot(3, Vec{});
  const std::vector<double> steps(3, 0.0);
  for (const Vec& v : find_line_shaking(dot, steps, {}).shaking_mm) EXPECT_LT(norm(v), 1e-9);
}

}  // namespace
}  // namespace felt::line_shaking_test
