#include "felt/recognise/round_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace felt {
namespace {

/// Mean and second central moments of points.
struct Spread {
  Point mean;
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

Spread spread_of(std::span<const Point> points) noexcept {
  Spread s;
  if (points.empty()) return s;
  const double n = static_cast<double>(points.size());
  Vec sum;
  for (const Point p : points) sum += p - points[0];
  s.mean = points[0] + sum / n;
  for (const Point p : points) {
    const Vec d = p - s.mean;
    s.xx += d.x * d.x / n;
    s.xy += d.x * d.y / n;
    s.yy += d.y * d.y / n;
  }
  return s;
}

/// Solves a x = b for a symmetric positive definite matrix, by Gaussian elimination without
/// pivoting. Returns false if a pivot is not positive.
template <std::size_t N>
bool solve(std::array<std::array<double, N>, N> a, std::array<double, N>& b) noexcept {
  for (std::size_t i = 0; i < N; ++i) {
    if (!(a[i][i] > 1e-300)) return false;
    for (std::size_t r = i + 1; r < N; ++r) {
      const double factor = a[r][i] / a[i][i];
      for (std::size_t c = i; c < N; ++c) a[r][c] -= factor * a[i][c];
      b[r] -= factor * b[i];
    }
  }
  for (std::size_t i = N; i-- > 0;) {
    for (std::size_t c = i + 1; c < N; ++c) b[i] -= a[i][c] * b[c];
    b[i] /= a[i][i];
  }
  return true;
}

template <std::size_t N, class Residual>
double sum_of_squares(std::span<const Point> points, const std::array<double, N>& x,
                      Residual residual) noexcept {
  double sum = 0.0;
  for (const Point p : points) {
    const double r = residual(x, p);
    sum += r * r;
  }
  return sum;
}

/// One step of Levenberg and Marquardt with derivatives by differences of `step`. Returns the new
/// parameters.
template <std::size_t N, class Residual>
std::array<double, N> marquardt_step(std::span<const Point> points, const std::array<double, N>& x,
                                     const std::array<double, N>& step, double damping,
                                     Residual residual) noexcept {
  std::array<std::array<double, N>, N> a{};
  std::array<double, N> b{};
  for (const Point p : points) {
    std::array<double, N> slope;
    for (std::size_t i = 0; i < N; ++i) {
      std::array<double, N> more = x, less = x;
      more[i] += step[i];
      less[i] -= step[i];
      slope[i] = (residual(more, p) - residual(less, p)) / (2.0 * step[i]);
    }
    const double r = residual(x, p);
    for (std::size_t i = 0; i < N; ++i) {
      b[i] -= slope[i] * r;
      for (std::size_t j = 0; j < N; ++j) a[i][j] += slope[i] * slope[j];
    }
  }
  for (std::size_t i = 0; i < N; ++i) a[i][i] *= 1.0 + damping;
  std::array<double, N> next = x;
  if (!solve(a, b)) return x;
  for (std::size_t i = 0; i < N; ++i) next[i] += b[i];
  return next;
}

/// Minimises the sum of squared residuals. Returns the least sum found.
template <std::size_t N, class Residual>
double minimise(std::span<const Point> points, std::array<double, N>& x,
                const std::array<double, N>& step, Residual residual) noexcept {
  double best = sum_of_squares(points, x, residual), damping = 1e-3;
  for (int i = 0; i < kFitSteps; ++i) {
    const auto next = marquardt_step(points, x, step, damping, residual);
    const double sum = sum_of_squares(points, next, residual);
    if (std::isfinite(sum) && sum < best) {
      const bool is_done = best - sum < 1e-9 * best;
      x = next;
      best = sum;
      damping *= 0.3;
      if (is_done) break;
    } else {
      damping *= 10.0;
    }
  }
  return best;
}

double rms_of(double sum, std::size_t count) noexcept {
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
}

/// The algebraic circle: the least squares of x^2 + y^2 + D x + E y + F about the mean.
CircleFit kasa_circle(std::span<const Point> points) noexcept {
  const Spread s = spread_of(points);
  double xz = 0.0, yz = 0.0;
  for (const Point p : points) {
    const Vec d = p - s.mean;
    xz += d.x * norm_squared(d) / static_cast<double>(points.size());
    yz += d.y * norm_squared(d) / static_cast<double>(points.size());
  }
  const double det = s.xx * s.yy - s.xy * s.xy;
  if (!(det > 1e-9 * (s.xx + s.yy) * (s.xx + s.yy))) return {s.mean, 0.0, 0.0};
  const Vec to{0.5 * (xz * s.yy - yz * s.xy) / det, 0.5 * (yz * s.xx - xz * s.xy) / det};
  return {s.mean + to, std::sqrt(norm_squared(to) + s.xx + s.yy), 0.0};
}

}  // namespace

LineFit fit_line(std::span<const Point> points) noexcept {
  if (points.empty()) return {};
  const Spread s = spread_of(points);
  const double angle = 0.5 * std::atan2(2.0 * s.xy, s.xx - s.yy);
  const Vec along{std::cos(angle), std::sin(angle)};
  const double across = 0.5 * (s.xx + s.yy - std::hypot(s.xx - s.yy, 2.0 * s.xy));
  const auto on_line = [&](Point p) { return s.mean + dot(p - s.mean, along) * along; };
  return {on_line(points.front()), on_line(points.back()), std::sqrt(std::max(0.0, across))};
}

CircleFit fit_circle(std::span<const Point> points) noexcept {
  CircleFit fit = kasa_circle(points);
  if (!(fit.radius_mm > 0.0)) return fit;
  const Point origin = fit.center;
  const double h = 1e-5 * fit.radius_mm;
  const auto residual = [origin](const std::array<double, 3>& x, Point p) {
    return norm(p - (origin + Vec{x[0], x[1]})) - x[2];
  };
  std::array<double, 3> x{0.0, 0.0, fit.radius_mm};
  const double sum = minimise<3>(points, x, {h, h, h}, residual);
  return {origin + Vec{x[0], x[1]}, std::abs(x[2]), rms_of(sum, points.size())};
}

EllipseFit fit_ellipse(std::span<const Point> points) noexcept {
  const Spread s = spread_of(points);
  const double half = 0.5 * (s.xx + s.yy), spread = 0.5 * std::hypot(s.xx - s.yy, 2.0 * s.xy);
  if (!(half - spread > 1e-6 * half)) return {s.mean, 0.0, 0.0, 0.0, 0.0};
  const double size = std::sqrt(half), h = 1e-5 * size;
  // x: centre, radii, angle. A uniform ellipse has about half the squared radius as its moment.
  std::array<double, 5> x{0.0, 0.0, std::sqrt(2.0 * (half + spread)),
                          std::sqrt(2.0 * (half - spread)),
                          0.5 * std::atan2(2.0 * s.xy, s.xx - s.yy)};
  const auto residual = [&s](const std::array<double, 5>& v, Point p) {
    const Vec d = p - (s.mean + Vec{v[0], v[1]});
    const double c = std::cos(v[4]), w = std::sin(v[4]);
    const double u = (c * d.x + w * d.y) / v[2], t = (c * d.y - w * d.x) / v[3];
    const double slope = 2.0 * std::hypot(u / v[2], t / v[3]);
    return (u * u + t * t - 1.0) / std::max(slope, 1e-12);
  };
  const double sum = minimise<5>(points, x, {h, h, h, h, 1e-5}, residual);
  EllipseFit fit{s.mean + Vec{x[0], x[1]}, std::abs(x[2]), std::abs(x[3]), x[4],
                 rms_of(sum, points.size())};
  if (fit.long_mm < fit.short_mm) {
    std::swap(fit.long_mm, fit.short_mm);
    fit.angle += 0.5 * std::numbers::pi;
  }
  return fit;
}

}  // namespace felt
