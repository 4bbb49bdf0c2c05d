#include "felt/stroke/fit/run_moments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "felt/stroke/testing/test_ink.h"

namespace felt::run_moments_test {
namespace {

using testing::TestInk;

struct SampleRun {
  std::vector<Point> samples;  // the first is the origin
  std::vector<double> path;
};

// Returns a noisy arc of a circle.
SampleRun noisy_arc(std::uint64_t seed, int count, double sigma, Vec offset = {}) {
  TestInk random(seed);
  const double radius = random.uniform(5.0, 50.0), sweep = random.uniform(0.2, 1.5);
  SampleRun run;
  for (int i = 0; i < count; ++i) {
    const double a = sweep * i / (count - 1);
    const Vec noise = i == 0 ? Vec{} : random.noise(sigma);
    run.samples.push_back(Point{} + offset + radius * Vec{std::sin(a), 1.0 - std::cos(a)} + noise);
    const double step =
        i == 0 ? 0.0 : distance(run.samples[run.samples.size() - 2], run.samples.back());
    run.path.push_back((i == 0 ? 0.0 : run.path.back()) + step);
  }
  return run;
}

RunMoments moments_of(const SampleRun& run, std::optional<Vec> tangent) {
  RunMoments moments;
  tangent ? moments.begin(run.samples[0], *tangent) : moments.begin(run.samples[0]);
  for (std::size_t i = 0; i < run.samples.size(); ++i) moments.add(run.samples[i], run.path[i]);
  return moments;
}

// Errors of the least-squares cubic, found sample by sample in long double.
struct Direct {
  long double sum = 0.0L, largest = 0.0L;  // sum and largest of the squared distances
};

Direct direct_fit(const SampleRun& run, std::optional<Vec> tangent) {
  using Real = long double;
  const Vec end = run.samples.back() - run.samples.front();
  Real a[3] = {}, gx[2] = {}, gy[2] = {};  // s22, s23, s33; right sides
  const auto basis = [&](std::size_t i) {
    const Real t = Real(run.path[i]) / Real(run.path.back()), s = 1.0L - t;
    return std::array<Real, 3>{3 * t * s * s, 3 * t * t * s, t * t * t};
  };
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    const auto [b2, b3, b4] = basis(i);
    const Vec v = run.samples[i] - run.samples.front();
    const Real x = Real(v.x) - b4 * Real(end.x), y = Real(v.y) - b4 * Real(end.y);
    a[0] += b2 * b2, a[1] += b2 * b3, a[2] += b3 * b3;
    gx[0] += b2 * x, gx[1] += b3 * x, gy[0] += b2 * y, gy[1] += b3 * y;
  }
  Real x2 = 0, y2 = 0;
  if (tangent) {
    const Real tx = Real(tangent->x), ty = Real(tangent->y), ratio = a[1] / a[2];
    const Real handle =
        ((tx * gx[0] + ty * gy[0]) - ratio * (tx * gx[1] + ty * gy[1])) / (a[0] - a[1] * ratio);
    x2 = handle * tx, y2 = handle * ty;
  } else {
    const Real determinant = a[0] * a[2] - a[1] * a[1];
    x2 = (a[2] * gx[0] - a[1] * gx[1]) / determinant;
    y2 = (a[2] * gy[0] - a[1] * gy[1]) / determinant;
  }
  const Real x3 = (gx[1] - a[1] * x2) / a[2], y3 = (gy[1] - a[1] * y2) / a[2];
  Direct direct;
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    const auto [b2, b3, b4] = basis(i);
    const Vec v = run.samples[i] - run.samples.front();
    const Real ex = b2 * x2 + b3 * x3 + b4 * Real(end.x) - Real(v.x);
    const Real ey = b2 * y2 + b3 * y3 + b4 * Real(end.y) - Real(v.y);
    direct.sum += ex * ex + ey * ey;
    direct.largest = std::max(direct.largest, ex * ex + ey * ey);
  }
  return direct;
}

TEST(RunMoments, AgreeWithDirectLeastSquaresOnANoisyArc) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const SampleRun run = noisy_arc(seed, 300, 0.05);
    for (const std::optional<Vec> tangent :
         {std::optional<Vec>{}, std::optional<Vec>{{1.0, 0.0}}}) {
      const double residual = moments_of(run, tangent).residual();
      const auto direct = static_cast<double>(direct_fit(run, tangent).sum);
      // The tolerance is 1e-9 of the residual, plus the rounding error of subtracting from the sum
      // of |P|^2.
      EXPECT_NEAR(residual, direct, 1e-9 * direct + 1e-13 * 300 * 2500);
    }
  }
}

TEST(RunMoments, AreAccurateForAHundredThousandSamplesFarOut) {
  const SampleRun run = noisy_arc(7, 100000, 0.05, {1e6, -1e6});
  const auto direct = static_cast<double>(direct_fit(run, {}).sum);
  EXPECT_NEAR(moments_of(run, {}).residual() / direct, 1.0, 1e-6);
}

// residual <= tolerance^2 means a cubic exists that is within the tolerance of every sample.
TEST(RunMoments, TheGateIsRigorous) {
  int accepted = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    const SampleRun run = noisy_arc(seed, random.pick(4, 60), random.uniform(0.0, 0.05));
    const double tolerance = random.tolerance();
    const std::optional<Vec> tangent =
        random.chance(0.5) ? std::optional<Vec>{{1.0, 0.0}} : std::nullopt;
    if (!(moments_of(run, tangent).residual() <= tolerance * tolerance)) continue;
    ++accepted;
    EXPECT_LE(direct_fit(run, tangent).largest, (1.0 + 1e-9) * tolerance * tolerance);
  }
  EXPECT_GT(accepted, 500);
}

TEST(RunMoments, AreInfiniteWhereTheyDoNotDetermineACubic) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  RunMoments moments;
  moments.begin({1.0, 2.0});
  EXPECT_EQ(moments.residual(), kInfinity) << "no sample";
  moments.add({1.0, 2.0}, 0.0);
  moments.add({1.0, 2.0}, 0.0);
  EXPECT_EQ(moments.residual(), kInfinity) << "all samples at the origin";
  moments.add({2.0, 2.0}, 1.0);
  EXPECT_EQ(moments.residual(), kInfinity) << "two places";

  // The samples go in the direction opposite to the tangent.
  moments.begin({0.0, 0.0}, {-1.0, 0.0});
  for (int i = 0; i < 10; ++i) moments.add({1.0 * i, 0.0}, 1.0 * i);
  EXPECT_EQ(moments.residual(), kInfinity);
}

}  // namespace
}  // namespace felt::run_moments_test
