#include "felt/stroke/steady/shake_filter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "felt/base/random.h"

namespace felt::shake_filter_test {
namespace {

using Matrix = std::vector<std::vector<double>>;

/// Solves a x = b by Gauss with pivots.
std::vector<double> solved(Matrix a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::fabs(a[i][k]) > std::fabs(a[best][k])) best = i;
    std::swap(a[k], a[best]);
    std::swap(b[k], b[best]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double f = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= f * a[k][j];
      b[i] -= f * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

/// A line of samples at irregular times, and what the filter makes of it.
struct FilterRun {
  ShakeModel model{5.5, 0.8, 6000.0};
  std::vector<double> y, dt;
  std::vector<ShakeFilter::Record> records;

  explicit FilterRun(std::uint64_t seed, std::size_t count = 40) {
    Random random(seed);
    ShakeFilter filter(model);
    double s = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      dt.push_back(i == 0 ? 0.0 : random.between(0.002, 0.03));
      s += dt.back();
      y.push_back(20 * s + std::sin(30 * s) + 0.02 * random.normal());
      records.push_back(i == 0 ? filter.begin(y[0])
                               : filter.push(y[i], shake_step(model.hz, dt[i])));
    }
  }
  [[nodiscard]] std::vector<double> smoothed() const {
    std::vector<double> out(y.size());
    ShakeFilter::Adjoint adjoint{};
    for (std::size_t i = y.size(); i-- > 0;) out[i] = ShakeFilter::smooth(records[i], adjoint);
    return out;
  }
};

/// Returns the mean of all positions p given all measurements, from the joint covariance of the
/// whole line: p(t) is the state after linear steps of independent noises.
std::vector<double> by_joint_covariance(const FilterRun& run) {
  const std::size_t n = run.y.size();
  using M5 = std::array<std::array<double, 5>, 5>;
  const auto times = [](const M5& a, const M5& b) {
    M5 c{};
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = 0; j < 5; ++j)
        for (std::size_t k = 0; k < 5; ++k) c[i][j] += a[i][k] * b[k][j];
    return c;
  };
  const auto turned = [](const M5& a) {
    M5 t{};
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = 0; j < 5; ++j) t[i][j] = a[j][i];
    return t;
  };
  const double w2 = run.model.swing_mm * run.model.swing_mm;
  // The start: the position is measured exactly up to noise, and the oscillation is unknown.
  M5 p{};
  p[0][0] = w2 + ShakeFilter::kNoiseMm2;
  p[0][3] = p[3][0] = -w2;
  p[1][1] = std::pow(ShakeFilter::kStartSpeed, 2);
  p[2][2] = std::pow(ShakeFilter::kStartAcceleration, 2);
  p[3][3] = p[4][4] = w2;
  // cov[i][j] = covariance of the states at i and j.
  std::vector<std::vector<M5>> cov(n, std::vector<M5>(n));
  cov[0][0] = p;
  for (std::size_t k = 1; k < n; ++k) {
    const double t = run.dt[k];
    const ShakeStep s = shake_step(run.model.hz, t);
    M5 f{};
    f[0] = {1, t, t * t / 2, 0, 0};
    f[1] = {0, 1, t, 0, 0};
    f[2] = {0, 0, 1, 0, 0};
    f[3] = {0, 0, 0, s.cos, -s.sin};
    f[4] = {0, 0, 0, s.sin, s.cos};
    for (std::size_t i = 0; i < k; ++i) {
      cov[k][i] = times(f, cov[k - 1][i]);
      cov[i][k] = turned(cov[k][i]);
    }
    M5 c = times(times(f, cov[k - 1][k - 1]), turned(f));
    const double q = std::pow(run.model.jerk_mm_per_s3, 2) / 133.0;
    const double noise[3][3] = {{std::pow(t, 5) / 20, std::pow(t, 4) / 8, std::pow(t, 3) / 6},
                                {std::pow(t, 4) / 8, std::pow(t, 3) / 3, t * t / 2},
                                {std::pow(t, 3) / 6, t * t / 2, t}};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) c[i][j] += q * noise[i][j];
    c[3][3] += w2 * (1 - s.decay * s.decay);
    c[4][4] += w2 * (1 - s.decay * s.decay);
    cov[k][k] = c;
  }
  // The measurements after the first, whose prior mean is y[0].
  Matrix s(n - 1, std::vector<double>(n - 1));
  std::vector<double> innovation(n - 1);
  for (std::size_t i = 1; i < n; ++i) {
    innovation[i - 1] = run.y[i] - run.y[0];
    for (std::size_t j = 1; j < n; ++j) {
      const M5& c = cov[i][j];
      s[i - 1][j - 1] =
          c[0][0] + c[0][3] + c[3][0] + c[3][3] + (i == j ? ShakeFilter::kNoiseMm2 : 0.0);
    }
  }
  const std::vector<double> weights = solved(s, innovation);
  std::vector<double> out(n, run.y[0]);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = 1; j < n; ++j) {
      out[k] += (cov[k][j][0][0] + cov[k][j][0][3]) * weights[j - 1];
    }
  }
  return out;
}

TEST(ShakeFilter, TheSmootherIsTheMeanGivenAllSamples) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const FilterRun run(seed);
    const std::vector<double> wanted = by_joint_covariance(run), got = run.smoothed();
    for (std::size_t i = 0; i < wanted.size(); ++i) ASSERT_NEAR(got[i], wanted[i], 1e-5) << i;
    EXPECT_NEAR(run.records.back().position, wanted.back(), 1e-5) << "the filter is causal";
  }
}

TEST(ShakeFilter, ManySamplesAtTheSameTimeAreHarmless) {
  ShakeFilter filter({5.0, 1.0, 50000.0});
  filter.begin(0.0);
  for (int i = 0; i < 100000; ++i) {
    const ShakeFilter::Record r = filter.push(0.01 * (i % 3), shake_step(5.0, 1e-4));
    ASSERT_TRUE(std::isfinite(r.position));
    ASSERT_GT(r.variance, 0.0);
    ASSERT_GE(r.row[0], 0.0);
  }
}

}  // namespace
}  // namespace felt::shake_filter_test
