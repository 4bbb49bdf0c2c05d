// Arc length of a cubic and its inverse (declared in cubic.h).
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "felt/geometry/cubic.h"

namespace felt {
namespace {

// |f'(t)| with f' in powers of t.
struct Speed {
  explicit Speed(const Cubic& c) noexcept
      : v0(3.0 * (c.p[1] - c.p[0])),
        v1(6.0 * ((c.p[2] - c.p[1]) - (c.p[1] - c.p[0]))),
        v2(3.0 *
           (((c.p[3] - c.p[2]) - (c.p[2] - c.p[1])) - ((c.p[2] - c.p[1]) - (c.p[1] - c.p[0])))) {}

  double operator()(double t) const noexcept { return norm(v0 + t * (v1 + t * v2)); }

  // Returns true if the speed is analytic in the complex disc of radius 3/4 width about t. With
  // v = f'(t), its square at t + z is v.v + 2 v.e + e.e, e = z (v1 + 2 t v2) + z^2 v2, which has no
  // zero while |v| > (1 + sqrt 2) |e|. Then the rule converges on the interval of that width like
  // 2.6^-23 or better.
  [[nodiscard]] bool smooth_around(double t, double width) const noexcept {
    const double r = 0.75 * width;
    return (*this)(t) > 2.4143 * r * (norm(v1 + (2.0 * t) * v2) + r * norm(v2));
  }

  Vec v0, v1, v2;
};

struct Integral {
  double value;
  double error;  // upper estimate: the difference of the 7 point and the 15 point rule
};

// Gauss-Kronrod (7, 15) on [t0, t1]. Nodes and weights: QUADPACK, qk15.
Integral gauss_kronrod(const Speed& speed, double t0, double t1) noexcept {
  static constexpr std::array<double, 7> kNode = {0.99145537112081263921, 0.94910791234275852453,
                                                  0.86486442335976907279, 0.74153118559939443986,
                                                  0.58608723546769113029, 0.40584515137739716691,
                                                  0.20778495500789846760};
  static constexpr std::array<double, 7> kKronrod = {0.02293532201052922496, 0.06309209262997855329,
                                                     0.10479001032225018384, 0.14065325971552591875,
                                                     0.16900472663926790283, 0.19035057806478540991,
                                                     0.20443294007529889241};
  static constexpr std::array<double, 3> kGauss = {0.12948496616886969327, 0.27970539148927666790,
                                                   0.38183005050511894495};
  const double middle = 0.5 * (t0 + t1), half = 0.5 * (t1 - t0);
  const double centre = speed(middle);
  double kronrod = 0.20948214108472782801 * centre;
  double gauss = 0.41795918367346938776 * centre;
  for (unsigned i = 0; i < 7; ++i) {
    const double both = speed(middle - half * kNode[i]) + speed(middle + half * kNode[i]);
    kronrod += kKronrod[i] * both;
    if (i % 2 == 1) gauss += kGauss[i / 2] * both;
  }
  return {kronrod * half, std::fabs(kronrod - gauss) * half};
}

double integrate(const Speed& speed, double t0, double t1, double accuracy) noexcept {
  constexpr int kMaxDepth = 48, kMaxPieces = 256;
  struct Piece {
    double t0, t1, accuracy;
  };
  // The right halves still to be processed, at most one per level; written before they are read.
  std::array<Piece, kMaxDepth + 1> stack;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  int waiting = 0, pieces = 0;
  double sum = 0.0;
  Piece piece{t0, t1, 0.25 * accuracy};
  for (;;) {
    const Integral part = gauss_kronrod(speed, piece.t0, piece.t1);
    ++pieces;
    const double middle = 0.5 * (piece.t0 + piece.t1);
    // Near a cusp the two rules can agree by accident, so a piece there must be short as well.
    const bool good =
        part.error <= piece.accuracy &&
        (speed.smooth_around(middle, piece.t1 - piece.t0) || part.value <= 0.25 * accuracy);
    if (!good && waiting < kMaxDepth && pieces < kMaxPieces) {
      // Each half may use 0.7 of the accuracy of the whole piece. The sum of 1.4 is no problem:
      // only the half with the cusp is halved again, with a quarter of the error, and elsewhere the
      // 15 point rule is far better than its estimate.
      const double share = 0.7 * piece.accuracy;
      stack[static_cast<unsigned>(waiting++)] = {middle, piece.t1, share};
      piece = {piece.t0, middle, share};
      continue;
    }
    sum += part.value;
    if (waiting == 0) return sum;
    piece = stack[static_cast<unsigned>(--waiting)];
  }
}

double achievable(const Cubic& c, double accuracy_mm) noexcept {
  return std::max(accuracy_mm, 1e-14 * control_length(c));
}

}  // namespace

double arc_length(const Cubic& c, double t0, double t1, double accuracy_mm) noexcept {
  if (!is_finite(c)) return std::numeric_limits<double>::quiet_NaN();
  const Speed speed(c);
  return integrate(speed, std::min(t0, t1), std::max(t0, t1), achievable(c, accuracy_mm));
}

double parameter_at_length(const Cubic& c, double length_mm, double accuracy_mm) noexcept {
  if (length_mm <= 0.0) return 0.0;
  const double accuracy = achievable(c, accuracy_mm);
  if (!is_finite(c)) return 1.0;
  const Speed speed(c);
  const double total = integrate(speed, 0.0, 1.0, 0.25 * accuracy);
  if (!(length_mm < total)) return 1.0;
  double lo = 0.0, hi = 1.0, length_at_lo = 0.0;
  double t = length_mm / total;
  // Newton steps that stay inside the bracket; every third step halves it.
  for (int i = 0; i < 96 && hi - lo > std::numeric_limits<double>::epsilon(); ++i) {
    const double length_at_t = length_at_lo + integrate(speed, lo, t, 0.25 * accuracy);
    const double excess = length_at_t - length_mm;
    if (std::fabs(excess) <= 0.5 * accuracy) return t;
    if (excess > 0.0) {
      hi = t;
    } else {
      lo = t;
      length_at_lo = length_at_t;
    }
    const double next = t - excess / speed(t);
    t = next > lo && next < hi && i % 3 != 2 ? next : 0.5 * (lo + hi);
  }
  return t;
}

}  // namespace felt
