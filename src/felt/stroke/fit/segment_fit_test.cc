#include "felt/stroke/fit/segment_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "felt/stroke/fit/segment_fit_kernels.h"
#include "felt/stroke/testing/fit_oracle.h"
#include "felt/stroke/testing/test_ink.h"

namespace felt::segment_fit_test {
namespace {

using testing::TestInk;
using testing::window_of;
using Kind = RunStart::Kind;

// Returns a cubic like the segments of ink: without a cusp or loop, about 10 mm long, with a gentle
// bend.
Cubic random_cubic(TestInk& random) {
  const Point start{random.uniform(0.0, 100.0), random.uniform(0.0, 100.0)};
  const Vec along = random.direction(10.0);
  const auto off = [&] { return random.uniform(-0.3, 0.3) * perp(along); };
  return {{start, start + 0.35 * along + off(), start + 0.65 * along + off(), start + along}};
}

std::vector<Point> samples_of(const Cubic& cubic, int count) {
  std::vector<Point> ink;
  for (int i = 0; i < count; ++i) ink.push_back(evaluate(cubic, i / (count - 1.0)));
  return ink;
}

// Returns a start for a run: free, on the first sample, or on the first sample with a tangent near
// that of the ink.
RunStart random_start(TestInk& random, const SampleWindow& window) {
  const Point first = window.point(0);
  switch (random.pick(0, 2)) {
    case 0:
      return {};
    case 1:
      return {Kind::kPoint, first + random.noise(0.01), {}};
    default:
      return {Kind::kTangent, first + random.noise(0.01),
              normalized(window.point(1) - first + random.noise(0.02))};
  }
}

// The rounds are bounded, so the fit of a few cubics whose speed varies a lot is abandoned.
TEST(SegmentFit, RecoversAnExactCubic) {
  int recovered = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    const Cubic cubic = random_cubic(random);
    const SampleWindow window = window_of(samples_of(cubic, 60), 0.05);
    const std::array<RunStart, 3> starts = {
        RunStart{}, RunStart{Kind::kPoint, cubic.p[0], {}},
        RunStart{Kind::kTangent, cubic.p[0], tangent(cubic, 0.0)}};
    for (const RunStart& start : starts) {
      SegmentFit fit;
      if (!fit.fit(window, start, 0, window.size())) continue;
      ++recovered;
      for (std::size_t i = 0; i < window.size(); ++i) {
        // The priors and the first accepted round leave part of the tolerance.
        EXPECT_LE(distance(evaluate(fit.curve(), fit.parameters()[i]), window.point(i)), 0.05);
      }
    }
  }
  EXPECT_GE(recovered, 900 * 9 / 10);
}

TEST(SegmentFit, StartPointAndPinnedEndAreExact) {
  int pinned = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    const SampleWindow window = window_of(samples_of(random_cubic(random), 40), 0.3);
    const RunStart start = random_start(random, window);
    SegmentFit fit;
    if (!fit.fit(window, start, 0, window.size(), SegmentFit::End::kPinned)) continue;
    ++pinned;
    EXPECT_EQ(fit.curve().p[3], window.point(window.size() - 1));
    if (start.kind != Kind::kFree) {
      EXPECT_EQ(fit.curve().p[0], start.point);
    }
  }
  EXPECT_GT(pinned, 250);
}

TEST(SegmentFit, R4TheStartTangentIsKept) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    const Cubic cubic = random_cubic(random);
    const SampleWindow window = window_of(samples_of(cubic, 40), 0.3);
    const RunStart start{Kind::kTangent, cubic.p[0], tangent(cubic, 0.0)};
    SegmentFit fit;
    ASSERT_TRUE(fit.fit(window, start, 0, window.size()));
    const Vec handle = fit.curve().p[1] - fit.curve().p[0];
    EXPECT_LE(std::fabs(cross(handle, start.tangent)), 1e-13);  // rounding of coordinates near 100
    const double length = window.path_mm(window.size() - 1);
    EXPECT_GE(dot(handle, start.tangent), SegmentFit::kMinHandle * length - 1e-12);
    EXPECT_LE(dot(handle, start.tangent), SegmentFit::kMaxHandle * length + 1e-12);
  }
}

// An accepted curve is within the tolerance of every sample in order, including merged ones.
TEST(SegmentFit, R2AcceptedMeansWithinTheTolerance) {
  int accepted = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    const double tolerance = random.tolerance();
    const std::vector<Point> ink = random.draw_any(60);
    KeptSamples kept(tolerance, 0.125 * tolerance);
    for (const Point p : ink) kept.add(p);
    const SampleWindow window = window_of(ink, tolerance);
    if (window.size() < 2) continue;
    SegmentFit fit;
    if (!fit.fit(window, random_start(random, window), 0, window.size())) continue;
    ++accepted;
    const auto t = fit.parameters();
    EXPECT_TRUE(std::is_sorted(t.begin(), t.end()));
    EXPECT_GE(t.front(), 0.0);
    EXPECT_EQ(t.back(), 1.0);
    std::size_t next = 0;
    for (std::size_t i = 0; i < window.size(); ++i) {
      const Point on_curve = evaluate(fit.curve(), t[i]);
      for (std::uint32_t k = 0; k < kept.sample_count(i); ++k) {
        ASSERT_LE(distance(on_curve, ink[next++]), tolerance);
      }
    }
  }
  EXPECT_GT(accepted, 500);
}

TEST(SegmentFit, R9_WorkOfOneFitIsBounded) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    TestInk random(seed);
    const SampleWindow window = window_of(random.draw_any(256), random.tolerance());
    if (window.size() < 2) continue;
    SegmentFit fit;
    fit.fit(window, random_start(random, window), 0, window.size());
    EXPECT_LE(fit.work(), 9 * static_cast<long>(window.size())) << seed;
  }
}

TEST(SegmentFit, ABridgeKeepsItsStartAndReachesItsSample) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    const SampleWindow window = window_of(random.draw_any(5), 0.1);
    if (window.size() < 2) continue;
    const RunStart start = random_start(random, window);
    SegmentFit fit;
    fit.bridge(window, start, 0, window.size());
    EXPECT_EQ(fit.curve().p[0], start.kind == Kind::kFree ? window.point(0) : start.point);
    EXPECT_EQ(fit.curve().p[3], window.point(window.size() - 1));
    EXPECT_GE(control_length(fit.curve()), kMinSegmentMm);
    if (start.kind == Kind::kTangent) {
      const Vec handle = fit.curve().p[1] - fit.curve().p[0];
      EXPECT_LE(angle_between(handle, start.tangent), 1e-10);
    }
  }
}

// Compares the lane kernels with plain loops that follow their header.
class Kernels : public ::testing::TestWithParam<std::size_t> {
 protected:
  static constexpr std::size_t kRoom = 64;

  void SetUp() override {
    TestInk random(GetParam() + 100);
    const Cubic c = random_cubic(random);
    const Vec b1 = c.p[0] - run_.origin, b2 = c.p[1] - run_.origin, b3 = c.p[2] - run_.origin,
              b4 = c.p[3] - run_.origin;
    curve_ = {b1, 3.0 * (b2 - b1), 3.0 * (b3 - 2.0 * b2 + b1), b4 - 3.0 * b3 + 3.0 * b2 - b1};
    for (std::size_t i = 0; i < kRoom; ++i) {
      t_[i] = random.uniform(0.0, 1.0);
      const Point p = evaluate(c, t_[i]) + random.noise(0.5);
      x_[i] = p.x;
      y_[i] = p.y;
      limit_[i] = random.uniform(1.0, 100.0);
      weight_[i] = random.uniform(0.5, 20.0);
    }
  }

  [[nodiscard]] Vec value(double t) const {
    return curve_.a0 + t * curve_.a1 + t * t * curve_.a2 + t * t * t * curve_.a3;
  }
  [[nodiscard]] Vec first(double t) const {
    return curve_.a1 + 2.0 * t * curve_.a2 + 3.0 * t * t * curve_.a3;
  }
  [[nodiscard]] Vec second(double t) const { return 2.0 * curve_.a2 + 6.0 * t * curve_.a3; }
  [[nodiscard]] Vec sample(std::size_t i) const { return Point{x_[i], y_[i]} - run_.origin; }

  // Returns the sums over samples [begin, end) of the Bernstein functions from `skip` on.
  [[nodiscard]] detail::NormalSums plain_sums(std::size_t skip, std::size_t begin, std::size_t end,
                                              double w) const {
    detail::NormalSums sums{};
    for (std::size_t i = begin; i < end; ++i) {
      const double t = t_[i], s = 1.0 - t;
      const std::array<double, 4> b = {s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t};
      const Vec n = perp(normalized(first(t)));
      const double m11 = weight_[i] * ((1 - w) * n.x * n.x + w),
                   m12 = weight_[i] * (1 - w) * n.x * n.y,
                   m22 = weight_[i] * ((1 - w) * n.y * n.y + w);
      const Vec q = sample(i);
      std::size_t pair = 0;
      for (std::size_t j = 0; j + skip < 4; ++j) {
        sums.rx[j] += b[j + skip] * (m11 * q.x + m12 * q.y);
        sums.ry[j] += b[j + skip] * (m12 * q.x + m22 * q.y);
        for (std::size_t k = 0; k <= j; ++k, ++pair) {
          sums.xx[pair] += b[j + skip] * b[k + skip] * m11;
          sums.xy[pair] += b[j + skip] * b[k + skip] * m12;
          sums.yy[pair] += b[j + skip] * b[k + skip] * m22;
        }
      }
    }
    return sums;
  }

  static void expect_near(const detail::NormalSums& a, const detail::NormalSums& b) {
    for (std::size_t k = 0; k < 10; ++k) {
      EXPECT_NEAR(a.xx[k], b.xx[k], 1e-11);
      EXPECT_NEAR(a.xy[k], b.xy[k], 1e-11);
      EXPECT_NEAR(a.yy[k], b.yy[k], 1e-11);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(a.rx[k], b.rx[k], 1e-9);
      EXPECT_NEAR(a.ry[k], b.ry[k], 1e-9);
    }
  }

  detail::PowerCubic curve_{};
  std::array<double, kRoom> x_{}, y_{}, limit_{}, weight_{}, t_{}, ratio_{};
  detail::RunView run_{x_.data(),      y_.data(),  limit_.data(),
                       weight_.data(), GetParam(), Point{50.0, 50.0}};
};
INSTANTIATE_TEST_SUITE_P(Counts, Kernels, ::testing::Values(1, 2, 3, 4, 5, 7, 8, 31, 60));

TEST_P(Kernels, ProjectIsOneNewtonStep) {
  auto t = t_;
  detail::project(curve_, run_, t.data(), ratio_.data());
  for (std::size_t i = 0; i < run_.count; ++i) {
    const Vec e = value(t_[i]) - sample(i), g = first(t_[i]);
    double slope = dot(g, g) + dot(e, second(t_[i]));
    if (slope < 0.3 * dot(g, g)) slope = dot(g, g);
    const double expected = std::clamp(t_[i] - dot(e, g) / slope, 0.0, 1.0);
    EXPECT_NEAR(t[i], expected, 1e-12);
    EXPECT_NEAR(ratio_[i], norm_squared(value(expected) - sample(i)) * limit_[i], 1e-9);
  }
}

TEST_P(Kernels, AccumulateIsTheSumOverItsSamples) {
  for (const double w : {1.0, 0.05}) {
    for (const std::size_t begin : {std::size_t{0}, std::size_t{1}}) {
      const std::size_t end = std::max(begin, run_.count - 1);
      detail::NormalSums fixed{}, free{};
      detail::accumulate_fixed_start(curve_, run_, t_.data(), begin, end, w, fixed);
      expect_near(fixed, plain_sums(1, begin, end, w));
      detail::accumulate_free_start(curve_, run_, t_.data(), begin, end, w, free);
      expect_near(free, plain_sums(0, begin, end, w));
    }
  }
}

}  // namespace
}  // namespace felt::segment_fit_test
