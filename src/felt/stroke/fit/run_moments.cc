#include "felt/stroke/fit/run_moments.h"

#include <cmath>
#include <limits>

namespace felt {
namespace {

constexpr double kUndetermined = std::numeric_limits<double>::infinity();

}  // namespace

void RunMoments::begin(Point origin) noexcept {
  *this = RunMoments{};
  origin_ = origin;
}

void RunMoments::begin(Point origin, Vec tangent) noexcept {
  begin(origin);
  tangent_ = tangent;
  has_tangent_ = true;
}

void RunMoments::add(Point p, double path_mm) noexcept {
  const Vec v = p - origin_;
  double power = 1.0;
  for (int k = 0; k < 7; ++k) {
    m_[k] += power;
    if (k < 4) q_[k] += power * v;
    power *= path_mm;
  }
  pp_ += norm_squared(v);
  last_ = v;
  length_ = path_mm;
}

// Relative to the origin, B1 is 0 and B4 is the last sample, so only B2 and B3 are unknown. With a
// tangent, B2 = a tangent; the handle is valid only if a > 0.
double RunMoments::residual() const noexcept {
  if (!(length_ > 0.0)) return kUndetermined;
  double m[7];
  Vec q[4];
  const double shrink = 1.0 / length_;
  double scale = 1.0;
  for (int k = 0; k < 7; ++k) {
    m[k] = m_[k] * scale;
    if (k < 4) q[k] = q_[k] * scale;
    scale *= shrink;
  }
  // Sums of b_j b_k and of b_j P over the samples, b2 = 3t(1-t)^2, b3 = 3t^2(1-t), b4 = t^3.
  const double s22 = 9 * m[2] - 36 * m[3] + 54 * m[4] - 36 * m[5] + 9 * m[6];
  const double s23 = 9 * m[3] - 27 * m[4] + 27 * m[5] - 9 * m[6];
  const double s33 = 9 * m[4] - 18 * m[5] + 9 * m[6];
  const double s24 = 3 * m[4] - 6 * m[5] + 3 * m[6];
  const double s34 = 3 * m[5] - 3 * m[6];
  const double s44 = m[6];
  const Vec g2 = 3 * q[1] - 6 * q[2] + 3 * q[3];
  const Vec g3 = 3 * q[2] - 3 * q[3];
  const Vec g4 = q[3];
  const Vec r2 = g2 - s24 * last_;
  const Vec r3 = g3 - s34 * last_;
  Vec b2, b3;
  const double determinant = s22 * s33 - s23 * s23;
  if (!(determinant > 1e-12 * s22 * s33)) return kUndetermined;
  if (has_tangent_) {
    const double a =
        (dot(tangent_, r2) - (s23 / s33) * dot(tangent_, r3)) / (s22 - s23 * s23 / s33);
    if (!(a > 0.0)) return kUndetermined;
    b2 = a * tangent_;
    b3 = (r3 - s23 * b2) / s33;
  } else {
    b2 = (s33 * r2 - s23 * r3) / determinant;
    b3 = (s22 * r3 - s23 * r2) / determinant;
  }
  return pp_ - 2 * (dot(b2, g2) + dot(b3, g3) + dot(last_, g4)) + s22 * dot(b2, b2) +
         2 * s23 * dot(b2, b3) + s33 * dot(b3, b3) + 2 * s24 * dot(b2, last_) +
         2 * s34 * dot(b3, last_) + s44 * dot(last_, last_);
}

}  // namespace felt
