#include "felt/stroke/fit/normal_equations.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "felt/stroke/fit/segment_fit.h"

namespace felt::detail {
namespace {

// A symmetric system A z = b; only the lower triangle of A is used.
template <std::size_t N>
struct System {
  std::array<std::array<double, N>, N> a{};
  std::array<double, N> b{};
};

// Solves in place by the factorisation A = L D L' (no square roots); the solution replaces b.
template <std::size_t N>
bool solve_in_place(System<N>& s) noexcept {
  std::array<double, N> inverse{};
  for (std::size_t i = 0; i < N; ++i) {
    double pivot = s.a[i][i];
    std::array<double, N> scaled{};  // row i of L D
    for (std::size_t j = 0; j < i; ++j) {
      double v = s.a[i][j];
      for (std::size_t k = 0; k < j; ++k) v -= scaled[k] * s.a[j][k];
      scaled[j] = v;
      s.a[i][j] = v * inverse[j];
      pivot -= v * s.a[i][j];
    }
    if (!(pivot > 1e-300)) return false;
    inverse[i] = 1.0 / pivot;
    for (std::size_t k = 0; k < i; ++k) s.b[i] -= s.a[i][k] * s.b[k];
  }
  for (std::size_t i = N; i-- > 0;) {
    s.b[i] *= inverse[i];
    for (std::size_t k = i + 1; k < N; ++k) s.b[i] -= s.a[k][i] * s.b[k];
  }
  return true;
}

// Coefficients of B1..B4 in the jerk f'''/6.
constexpr std::array<double, 4> kJerk = {-1.0, 3.0, -3.0, 1.0};
// Positions of B1..B4 on the chord, as fractions.
constexpr std::array<double, 4> kOnChord = {0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0};

// Assembles the system of the control points kFirst..4, x and y interleaved, with the priors.
template <std::size_t kFirst>
System<2 * (4 - kFirst)> assemble(const NormalSums& sums, const Priors& priors) noexcept {
  constexpr std::size_t kCount = 4 - kFirst;
  System<2 * kCount> s;
  std::size_t pair = 0;
  for (std::size_t j = 0; j < kCount; ++j) {
    for (std::size_t k = 0; k <= j; ++k, ++pair) {
      const double jerk = priors.energy * kJerk[j + kFirst] * kJerk[k + kFirst];
      s.a[2 * j][2 * k] = sums.xx[pair] + jerk;
      s.a[2 * j + 1][2 * k] = sums.xy[pair];
      s.a[2 * j + 1][2 * k + 1] = sums.yy[pair] + jerk;
      if (k < j) s.a[2 * j][2 * k + 1] = sums.xy[pair];
    }
    s.a[2 * j][2 * j] += priors.ridge;
    s.a[2 * j + 1][2 * j + 1] += priors.ridge;
    s.b[2 * j] = sums.rx[j] + priors.ridge * kOnChord[j + kFirst] * priors.chord.x;
    s.b[2 * j + 1] = sums.ry[j] + priors.ridge * kOnChord[j + kFirst] * priors.chord.y;
  }
  return s;
}

// Assembles the system of (a, B3, B4) with B2 = a tangent: the rows and columns of B2 are projected
// on the tangent.
System<5> assemble_on_tangent(const NormalSums& sums, const Priors& priors, Vec tangent) noexcept {
  // Pairs of (B2, B3, B4) in the lower triangle.
  enum Pair : std::size_t { k22, k32, k33, k42, k43, k44 };
  const double e = priors.energy, ridge = priors.ridge;
  const auto on_tangent = [&](Pair p, double jerk) {
    return Vec{(sums.xx[p] + jerk) * tangent.x + sums.xy[p] * tangent.y,
               sums.xy[p] * tangent.x + (sums.yy[p] + jerk) * tangent.y};
  };
  const Vec a22 = on_tangent(k22, e * kJerk[1] * kJerk[1]);
  const Vec a32 = on_tangent(k32, e * kJerk[2] * kJerk[1]);
  const Vec a42 = on_tangent(k42, e * kJerk[3] * kJerk[1]);
  const double e33 = e * kJerk[2] * kJerk[2] + ridge, e43 = e * kJerk[3] * kJerk[2];
  const double e44 = e * kJerk[3] * kJerk[3] + ridge;
  System<5> s;
  s.a[0] = {dot(a22, tangent) + ridge};
  s.a[1] = {a32.x, sums.xx[k33] + e33};
  s.a[2] = {a32.y, sums.xy[k33], sums.yy[k33] + e33};
  s.a[3] = {a42.x, sums.xx[k43] + e43, sums.xy[k43], sums.xx[k44] + e44};
  s.a[4] = {a42.y, sums.xy[k43], sums.yy[k43] + e43, sums.xy[k44], sums.yy[k44] + e44};
  // The ridge term pulls `a`, the length of the handle, towards a third of the path length and not
  // of the chord, because the chord may be short.
  s.b = {sums.rx[0] * tangent.x + sums.ry[0] * tangent.y + ridge * priors.length_mm / 3.0,
         sums.rx[1] + ridge * kOnChord[2] * priors.chord.x,
         sums.ry[1] + ridge * kOnChord[2] * priors.chord.y,
         sums.rx[2] + ridge * kOnChord[3] * priors.chord.x,
         sums.ry[2] + ridge * kOnChord[3] * priors.chord.y};
  return s;
}

}  // namespace

void add_end_sample(NormalSums& sums, std::size_t basis, Vec sample, double weight) noexcept {
  const std::size_t diagonal = basis * (basis + 1) / 2 + basis;
  sums.xx[diagonal] += weight;
  sums.yy[diagonal] += weight;
  sums.rx[basis] += weight * sample.x;
  sums.ry[basis] += weight * sample.y;
}

bool solve_free(const NormalSums& sums, const Priors& priors, Point origin, Cubic& curve) noexcept {
  System<8> s = assemble<0>(sums, priors);
  if (!solve_in_place(s)) return false;
  for (std::size_t k = 0; k < 4; ++k) curve.p[k] = origin + Vec{s.b[2 * k], s.b[2 * k + 1]};
  return true;
}

bool solve_point(const NormalSums& sums, const Priors& priors, Point origin,
                 Cubic& curve) noexcept {
  System<6> s = assemble<1>(sums, priors);
  if (!solve_in_place(s)) return false;
  curve.p[0] = origin;
  for (std::size_t k = 1; k < 4; ++k) curve.p[k] = origin + Vec{s.b[2 * k - 2], s.b[2 * k - 1]};
  return true;
}

bool solve_tangent(const NormalSums& sums, const Priors& priors, Point origin, Vec tangent,
                   Cubic& curve) noexcept {
  System<5> s = assemble_on_tangent(sums, priors, tangent);
  const System<5> kept = s;
  if (!solve_in_place(s)) return false;
  double handle = s.b[0];
  const double smallest = SegmentFit::kMinHandle * priors.length_mm;
  const double largest = SegmentFit::kMaxHandle * priors.length_mm;
  std::array<double, 4> rest = {s.b[1], s.b[2], s.b[3], s.b[4]};
  if (handle < smallest || handle > largest) {
    handle = handle < smallest ? smallest : largest;
    System<4> bound;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j <= i; ++j) bound.a[i][j] = kept.a[i + 1][j + 1];
      bound.b[i] = kept.b[i + 1] - handle * kept.a[i + 1][0];
    }
    if (!solve_in_place(bound)) return false;
    rest = bound.b;
  }
  curve.p[0] = origin;
  curve.p[1] = origin + handle * tangent;
  curve.p[2] = origin + Vec{rest[0], rest[1]};
  curve.p[3] = origin + Vec{rest[2], rest[3]};
  return true;
}

}  // namespace felt::detail
