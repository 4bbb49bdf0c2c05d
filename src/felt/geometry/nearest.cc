#include "felt/geometry/nearest.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "felt/base/constants.h"

namespace felt {
namespace {

constexpr unsigned kMaxHalvings = 48;
constexpr double kMinWidth = 0x1p-48;  // kMaxHalvings halvings

// Part [t0, t0 + width] of the segment, with its control points relative to the query point.
struct CurvePiece {
  std::array<Vec, 4> a;
  double t0 = 0.0;
  double width = 1.0;  // a power of two, so that t0 + width is exact
};

Vec middle(Vec a, Vec b) noexcept {
  return 0.5 * (a + b);
}

// Splits in the middle: `left` becomes the left half; returns the right half.
CurvePiece halve(CurvePiece& left) noexcept {
  const Vec b0 = middle(left.a[0], left.a[1]), b1 = middle(left.a[1], left.a[2]);
  const Vec b2 = middle(left.a[2], left.a[3]);
  const Vec c0 = middle(b0, b1), c1 = middle(b1, b2), m = middle(c0, c1);
  left.width *= 0.5;
  const CurvePiece right{{m, c1, b2, left.a[3]}, left.t0 + left.width, left.width};
  left.a = {left.a[0], b0, c0, m};
  return right;
}

// Bernstein coefficients of the squared distance on a piece.
struct Distance {
  explicit Distance(const std::array<Vec, 4>& a) noexcept
      : c{dot(a[0], a[0]),
          dot(a[0], a[1]),
          0.4 * dot(a[0], a[2]) + 0.6 * dot(a[1], a[1]),
          0.1 * dot(a[0], a[3]) + 0.9 * dot(a[1], a[2]),
          0.4 * dot(a[1], a[3]) + 0.6 * dot(a[2], a[2]),
          dot(a[2], a[3]),
          dot(a[3], a[3])},
        lower(std::min(std::min(std::min(c[0], c[1]), std::min(c[2], c[3])),
                       std::min(std::min(c[4], c[5]), c[6]))),
        size(std::max(std::max(c[0], c[6]), std::max(dot(a[1], a[1]), dot(a[2], a[2])))) {}

  std::array<double, 7> c;
  double lower;  // no point of the piece is nearer
  double size;   // no product in c is larger; the rounding error of c is below 4 eps size
};

// Returns the largest number of sign changes that the six differences can have. Bit k of `minus` or
// `plus` is set if difference k is certainly negative or positive; if neither bit is set, the
// difference may have either sign.
int max_sign_changes(unsigned minus, unsigned plus) noexcept {
  if ((minus | plus) == 63U) return std::popcount((minus ^ (minus >> 1U)) & 31U);
  constexpr int kImpossible = -8;
  int ends_minus = (plus & 1U) != 0U ? kImpossible : 0;
  int ends_plus = (minus & 1U) != 0U ? kImpossible : 0;
  for (unsigned bit = 2U; bit < 64U; bit <<= 1U) {
    const int to_minus = std::max(ends_minus, ends_plus + 1);
    const int to_plus = std::max(ends_plus, ends_minus + 1);
    ends_minus = (plus & bit) != 0U ? kImpossible : to_minus;
    ends_plus = (minus & bit) != 0U ? kImpossible : to_plus;
  }
  return std::max(ends_minus, ends_plus);
}

int max_sign_changes(const Distance& d, double noise) noexcept {
  unsigned minus = 0, plus = 0;
  for (unsigned k = 0; k < 6; ++k) {
    const double difference = d.c[k + 1] - d.c[k];
    minus |= static_cast<unsigned>(difference < -noise) << k;
    plus |= static_cast<unsigned>(difference > noise) << k;
  }
  return max_sign_changes(minus, plus);
}

// A parameter on a piece, and the squared distance there.
struct Candidate {
  double u;
  double distance_squared;
};

// Returns the only stationary point of |a|^2 inside the piece. Requires that the distance falls at
// u = 0 and rises at u = 1. Uses Newton's method on a . a' = 0. A step that leaves the bracket [lo,
// hi], and every fourth step, is replaced by halving the bracket.
Candidate stationary_point(const std::array<Vec, 4>& a, double guess) noexcept {
  const Vec k1 = 3.0 * (a[1] - a[0]), k2 = 3.0 * ((a[2] - a[1]) - (a[1] - a[0]));
  const Vec k3 = (a[3] - a[0]) - 3.0 * (a[2] - a[1]);
  double lo = 0.0, hi = 1.0, u = guess;
  for (int i = 0; i < 80; ++i) {
    const Vec v = a[0] + u * (k1 + u * (k2 + u * k3));
    const Vec first = k1 + u * (2.0 * k2 + (3.0 * u) * k3);
    const Vec second = 2.0 * k2 + (6.0 * u) * k3;
    const double slope = dot(v, first);
    if (slope == 0.0) break;
    (slope > 0.0 ? hi : lo) = u;
    const double curve = dot(first, first) + dot(v, second);
    double next = u - slope / curve;
    const bool newton = next > lo && next < hi && i % 4 != 3;
    if (!newton) next = 0.5 * (lo + hi);
    const double step = std::fabs(next - u);
    u = next;
    // The error of Newton's method is of the order of the square of its last step.
    if (step <= (newton ? 1e-10 : kEpsilon)) break;
  }
  return {u, norm_squared(a[0] + u * (k1 + u * (k2 + u * k3)))};
}

// Returns a first guess of the root: the sign change of the control polygon of the derivative.
double guess_root(const Distance& d) noexcept {
  unsigned k = 1;
  while (k < 5 && d.c[k + 1] < d.c[k]) ++k;
  const double below = d.c[k] - d.c[k - 1], above = d.c[k + 1] - d.c[k];
  const double rise = above - below;
  const double part = rise > 0.0 ? std::clamp(-below / rise, 0.0, 1.0) : 0.5;
  return std::clamp(0.2 * (static_cast<double>(k - 1) + part), 0.001, 0.999);
}

class NearestSearch {
 public:
  NearestSearch(const Cubic& c, Point q, double max_distance_squared) noexcept
      : limit_(max_distance_squared),
        root_{{c.p[0] - q, c.p[1] - q, c.p[2] - q, c.p[3] - q}, 0.0, 1.0} {}

  // Returns false if nothing is within the limit, or the work ran out before anything was found.
  bool run(int& pieces_left) noexcept {
    Distance d(root_.a);
    if (!(d.c[0] + d.c[2] + d.c[4] + d.c[6] < std::numeric_limits<double>::infinity()))
      return false;
    // A distance that rounding makes indistinguishable from zero.
    const double zero = 256.0 * kEpsilon * kEpsilon * d.size;
    if (d.lower > limit_ + 4.0 * kEpsilon * d.size) {
      --pieces_left;
      return false;
    }
    offer(0.0, d.c[0]);
    offer(1.0, d.c[6]);
    // Not initialised, because this is the hot path: pieces are written before they are read.
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
    std::array<CurvePiece, kMaxHalvings> waiting;
    unsigned count = 0;
    CurvePiece piece = root_;
    while (--pieces_left > 0 && !(found_ && limit_ <= zero)) {
      if (!finished(piece, d) && piece.width > kMinWidth) {
        waiting[count] = halve(piece);
        const CurvePiece& right = waiting[count++];
        offer(right.t0, norm_squared(right.a[0]));
      } else if (count > 0) {
        piece = waiting[--count];
      } else {
        break;
      }
      d = Distance(piece.a);
    }
    return found_;
  }

  [[nodiscard]] double t() const noexcept { return t_; }
  [[nodiscard]] double distance_squared() const noexcept { return limit_; }

 private:
  // Keeps the point if it is nearer than the best point, or equally near with a lower t.
  void offer(double t, double distance_squared) noexcept {
    constexpr double kTie = 4.0 * kEpsilon;
    if (!found_ ? distance_squared <= limit_
                : distance_squared < limit_ * (1.0 - kTie) ||
                      (t < t_ && distance_squared <= limit_ * (1.0 + kTie))) {
      found_ = true;
      limit_ = distance_squared;
      t_ = t;
    }
  }

  // Returns true if nothing on the piece can be nearer than the best point. If the piece has at
  // most one stationary point, offers the nearest point of the piece first.
  bool finished(const CurvePiece& piece, const Distance& d) noexcept {
    const double noise = 4.0 * kEpsilon * d.size;
    if (d.lower >= limit_ * (1.0 - 64.0 * kEpsilon) + noise) return true;
    // If the piece is large compared with the distance, noise could hide a nearer point.
    const int changes = max_sign_changes(d, d.size > 16.0 * limit_ ? 2.0 * noise : 0.0);
    if (changes > 1) return false;
    const auto& a = piece.a;
    if (dot(a[0], a[1] - a[0]) < 0.0 && dot(a[3], a[3] - a[2]) > 0.0) {
      const Candidate best = stationary_point(a, guess_root(d));
      offer(piece.t0 + piece.width * best.u, best.distance_squared);
    }
    return true;
  }

  double limit_;  // squared distance of the best point, or the caller's limit before there is one
  double t_ = 0.0;
  bool found_ = false;
  CurvePiece root_;
};

}  // namespace

std::optional<Nearest> nearest_within(const Cubic& c, Point q, double max_distance_squared,
                                      int& pieces_left) noexcept {
  NearestSearch search(c, q, max_distance_squared);
  if (!search.run(pieces_left)) return std::nullopt;
  return Nearest{search.t(), search.distance_squared(), evaluate(c, search.t())};
}

std::optional<Nearest> nearest_within(const Cubic& c, Point q,
                                      double max_distance_squared) noexcept {
  int pieces_left = std::numeric_limits<int>::max();
  return nearest_within(c, q, max_distance_squared, pieces_left);
}

Nearest nearest(const Cubic& c, Point q) noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return nearest_within(c, q, kInfinity).value_or(Nearest{0.0, kInfinity, c.p[0]});
}

}  // namespace felt
