#include "felt/stroke/fit/segment_fit_kernels.h"

#include <cstring>

// Function multi-versioning is used only with g++ and without sanitizers, because the start-up of a
// sanitizer does not expect that the resolver runs first.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(FELT_RTSAN)
#define FELT_LANE_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define FELT_LANE_CLONES
#endif
#define FELT_INLINE inline __attribute__((always_inline))

namespace felt::detail {
namespace {

constexpr std::size_t kLanes = 4;
using Lanes = double __attribute__((vector_size(kLanes * sizeof(double))));
using Mask = long long __attribute__((vector_size(kLanes * sizeof(long long))));

FELT_INLINE void load(Lanes& lanes, const double* from) noexcept {
  std::memcpy(&lanes, from, sizeof(lanes));
}

FELT_INLINE void store(double* to, const Lanes& lanes) noexcept {
  std::memcpy(to, &lanes, sizeof(lanes));
}

// Adds the lanes in a fixed order.
FELT_INLINE double sum(const Lanes& v) noexcept {
  return (v[0] + v[2]) + (v[1] + v[3]);
}

// Computes the Bernstein functions b1..b4 at t.
FELT_INLINE void bernstein(const Lanes& t, Lanes* b) noexcept {
  const Lanes s = 1.0 - t;
  const Lanes tt = t * t, ss = s * s;
  b[0] = ss * s;
  b[1] = 3.0 * t * ss;
  b[2] = 3.0 * tt * s;
  b[3] = tt * t;
}

template <std::size_t kFirst>
FELT_INLINE void accumulate(const PowerCubic& c, const RunView& run, const double* t_in,
                            std::size_t begin, std::size_t end, double w,
                            NormalSums& sums) noexcept {
  constexpr std::size_t kCount = 4 - kFirst;
  constexpr std::size_t kPairs = kCount * (kCount + 1) / 2;
  Lanes xx[kPairs] = {}, xy[kPairs] = {}, yy[kPairs] = {}, rx[kCount] = {}, ry[kCount] = {};
  const double keep = 1.0 - w;
  for (std::size_t i = begin; i < end; i += kLanes) {
    Lanes t, x, y, weight;
    load(t, t_in + i);
    load(x, run.x + i);
    load(y, run.y + i);
    load(weight, run.weight + i);
    x -= run.origin.x;
    y -= run.origin.y;
    const Lanes gx = (3.0 * c.a3.x * t + 2.0 * c.a2.x) * t + c.a1.x;
    const Lanes gy = (3.0 * c.a3.y * t + 2.0 * c.a2.y) * t + c.a1.y;
    const Lanes squared = gx * gx + gy * gy;
    // If the curve's derivative is zero, the normal is undefined, so the metric is M = I.
    const Mask moving = squared > 1e-30;
    const Lanes a = weight * (moving ? keep / squared : Lanes{});
    const Lanes damp = weight * (moving ? Lanes{} + w : Lanes{} + 1.0);
    Lanes m11 = a * gy * gy + damp, m12 = -a * gx * gy, m22 = a * gx * gx + damp;
    if (i + kLanes > end) {
      for (std::size_t lane = end - i; lane < kLanes; ++lane) {
        m11[lane] = m12[lane] = m22[lane] = 0.0;
        x[lane] = y[lane] = 0.0;
      }
    }
    Lanes b[4];
    bernstein(t, b);
    const Lanes mx = m11 * x + m12 * y, my = m12 * x + m22 * y;
    std::size_t pair = 0;
    for (std::size_t j = 0; j < kCount; ++j) {
      rx[j] += b[j + kFirst] * mx;
      ry[j] += b[j + kFirst] * my;
      for (std::size_t k = 0; k <= j; ++k, ++pair) {
        const Lanes bb = b[j + kFirst] * b[k + kFirst];
        xx[pair] += bb * m11;
        xy[pair] += bb * m12;
        yy[pair] += bb * m22;
      }
    }
  }
  for (std::size_t p = 0; p < kPairs; ++p) {
    sums.xx[p] = sum(xx[p]);
    sums.xy[p] = sum(xy[p]);
    sums.yy[p] = sum(yy[p]);
  }
  for (std::size_t j = 0; j < kCount; ++j) {
    sums.rx[j] = sum(rx[j]);
    sums.ry[j] = sum(ry[j]);
  }
}

}  // namespace

FELT_LANE_CLONES
void project(const PowerCubic& c, const RunView& run, double* t_inout, double* ratio) noexcept {
  for (std::size_t i = 0; i < run.count; i += kLanes) {
    Lanes t, x, y, limit;
    load(t, t_inout + i);
    load(x, run.x + i);
    load(y, run.y + i);
    load(limit, run.inverse_limit + i);
    x = (run.origin.x - x) + c.a0.x;
    y = (run.origin.y - y) + c.a0.y;
    const Lanes ex = ((c.a3.x * t + c.a2.x) * t + c.a1.x) * t + x;
    const Lanes ey = ((c.a3.y * t + c.a2.y) * t + c.a1.y) * t + y;
    const Lanes gx = (3.0 * c.a3.x * t + 2.0 * c.a2.x) * t + c.a1.x;
    const Lanes gy = (3.0 * c.a3.y * t + 2.0 * c.a2.y) * t + c.a1.y;
    const Lanes hx = 6.0 * c.a3.x * t + 2.0 * c.a2.x;
    const Lanes hy = 6.0 * c.a3.y * t + 2.0 * c.a2.y;
    const Lanes squared = gx * gx + gy * gy;
    Lanes denominator = squared + (ex * hx + ey * hy);
    denominator = denominator < 0.3 * squared ? squared : denominator;
    const Mask moving = denominator > 1e-30;
    const Lanes step = moving ? (ex * gx + ey * gy) / denominator : Lanes{};
    t -= step;
    t = t < 0.0 ? Lanes{} : t;
    t = t > 1.0 ? Lanes{} + 1.0 : t;
    const Lanes dx = ((c.a3.x * t + c.a2.x) * t + c.a1.x) * t + x;
    const Lanes dy = ((c.a3.y * t + c.a2.y) * t + c.a1.y) * t + y;
    store(t_inout + i, t);
    const Lanes over = (dx * dx + dy * dy) * limit;
    store(ratio + i, over);
  }
}

FELT_LANE_CLONES
void accumulate_fixed_start(const PowerCubic& curve, const RunView& run, const double* t,
                            std::size_t begin, std::size_t end, double w,
                            NormalSums& sums) noexcept {
  accumulate<1>(curve, run, t, begin, end, w, sums);
}

FELT_LANE_CLONES
void accumulate_free_start(const PowerCubic& curve, const RunView& run, const double* t,
                           std::size_t begin, std::size_t end, double w,
                           NormalSums& sums) noexcept {
  accumulate<0>(curve, run, t, begin, end, w, sums);
}

}  // namespace felt::detail
