#include "felt/stroke/outline/edge_fit.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

/// Rounds of moving the parameters of the points along the fitted curve and fitting again.
constexpr int kRounds = 4;
/// A curve that is that many tolerances off will not do after another round.
constexpr double kHopeless = 8.0;
/// Between the points a cubic strays a little more than at them.
constexpr double kShareAtPoints = 0.8;

}  // namespace

/// Handle lengths of the cubic between the end points that leaves least squares of distance to the
/// points at their parameters; false when there is no sensible answer. The normal equations of
/// Schneider, "An algorithm for automatically fitting digitized curves", 1990.
bool EdgeFit::fit_handles(Vec d0, Vec d1, Cubic& c) const noexcept {
  const Point p0 = points_.front(), p3 = points_.back();
  double c00 = 0, c01 = 0, c11 = 0, x0 = 0, x1 = 0;
  for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
    const double u = t_[i], w = 1.0 - u;
    const double b1 = 3 * w * w * u, b2 = 3 * w * u * u;
    const Vec base = lerp(p0, p3, u * u * (3 - 2 * u)) - points_[i];
    c00 += b1 * b1;
    c01 += b1 * b2 * dot(d0, d1);
    c11 += b2 * b2;
    x0 -= b1 * dot(d0, base);
    x1 -= b2 * dot(d1, base);
  }
  const double det = c00 * c11 - c01 * c01;
  const double chord = distance(p0, p3);
  double h0 = chord / 3, h1 = chord / 3;
  if (det > 1e-9 * c00 * c11) {
    h0 = (x0 * c11 - x1 * c01) / det;
    h1 = (x1 * c00 - x0 * c01) / det;
  }
  c = Cubic{{p0, p0 + h0 * d0, p3 + h1 * d1, p3}};
  return h0 > 0.0 && h1 > 0.0 && h0 + h1 < 3.0 * chord;
}

/// Moves each parameter towards the nearest place of the curve by Newton's method. Returns the
/// largest squared distance of a point from the curve at its parameter.
double EdgeFit::move_parameters(const Cubic& c) noexcept {
  constexpr int kSteps = 2;
  double worst = 0.0;
  for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
    double t = t_[i];
    for (int step = 0; step < kSteps; ++step) {
      const Vec off = evaluate(c, t) - points_[i], v = derivative(c, t);
      const double curve = norm_squared(v) + dot(off, second_derivative(c, t));
      if (curve > 0.0) t = std::clamp(t - dot(off, v) / curve, 0.0, 1.0);
    }
    t_[i] = t;
    worst = std::max(worst, norm_squared(evaluate(c, t) - points_[i]));
  }
  return worst;
}

bool EdgeFit::fit(Vec begin, Vec end, double tolerance_mm, Cubic& c) {
  if (points_.size() < 2) return false;
  t_.assign(points_.size(), 0.0);
  for (std::size_t i = 1; i < points_.size(); ++i) {
    t_[i] = t_[i - 1] + distance(points_[i - 1], points_[i]);
  }
  const double length = t_.back();
  if (!(length > 0.0)) return false;
  for (double& t : t_) t /= length;
  const double limit = kShareAtPoints * tolerance_mm;
  for (int round = 0; round < kRounds; ++round) {
    if (!fit_handles(begin, -end, c)) return false;
    const double worst = move_parameters(c);
    if (worst <= limit * limit) return true;
    if (!(worst <= kHopeless * kHopeless * tolerance_mm * tolerance_mm)) return false;
  }
  return false;
}

}  // namespace felt
