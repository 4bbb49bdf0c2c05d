#include "felt/solid/mirror_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace felt {
namespace mirror_search {

using Complex = std::complex<double>;

// Nodes and weights on [0, 1] of Gauss-Legendre quadrature, exact up to degree 15. Source:
// Abramowitz, Stegun, "Handbook of mathematical functions", table 25.4, n = 8.
constexpr std::array<double, 4> kNodes = {0.1834346424956498, 0.5255324099163290,
                                          0.7966664774136267, 0.9602898564975363};
constexpr std::array<double, 4> kWeights = {0.3626837833783620, 0.3137066458778873,
                                            0.2223810344533745, 0.1012285362903763};
constexpr int kParts = 4;  // of each cubic, because the integrands have a higher degree

/// Calls visit(z, dz): a position on the curve, and the step along the curve that it stands for.
template <class Visit>
void for_each_node(const std::vector<Cubic>& curve, Point centre, Visit visit) {
  for (const Cubic& c : curve) {
    for (int part = 0; part < kParts; ++part) {
      for (std::size_t k = 0; k < 2 * kNodes.size(); ++k) {
        const double node = k % 2 == 0 ? kNodes[k / 2] : -kNodes[k / 2];
        const double t = (part + 0.5 + 0.5 * node) / kParts;
        const Vec at = evaluate(c, t) - centre;
        const Vec step = (0.5 * kWeights[k / 2] / kParts) * derivative(c, t);
        visit(Complex{at.x, at.y}, Complex{step.x, step.y});
      }
    }
  }
}

/// The moments m_0 to m_(kMaxAxes) of an area by Green's theorem: the integral of z^k over the area
/// is that of z^k conj(z) dz / 2i along its border. The outer curve counts positive.
struct Moments {
  std::array<Complex, kMaxAxes + 1> m{};
  double radius_mm = 0.0;  // positions are divided by it
};

Moments moments_of(std::span<const std::vector<Cubic>> curves, Point centre) {
  Moments result;
  for (const auto& curve : curves) {
    for (const Cubic& c : curve) {
      result.radius_mm = std::max(result.radius_mm, distance(c.p[0], centre));
    }
  }
  const double scale = result.radius_mm > 0.0 ? 1.0 / result.radius_mm : 1.0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    std::array<Complex, kMaxAxes + 1> sums{};
    for_each_node(curves[i], centre, [&](Complex z, Complex dz) {
      z *= scale, dz *= scale;
      Complex term = std::conj(z) * dz / Complex{0.0, 2.0};
      for (Complex& sum : sums) sum += term, term *= z;
    });
    // Whatever its orientation, the outer curve encloses area and the others remove some.
    const bool flips = (sums[0].real() < 0.0) != (i > 0);
    for (std::size_t k = 0; k < sums.size(); ++k) result.m[k] += flips ? -sums[k] : sums[k];
  }
  return result;
}

/// Returns true if the mirror images of the corners are near the border.
bool is_axis(std::span<const Ring> rings, const EdgeGrid& border, Point centre, double angle) {
  const Vec along{std::cos(2.0 * angle), std::sin(2.0 * angle)};
  const auto mirrored = [&](Point p) {
    const Vec v = p - centre;
    return centre + Vec{along.x * v.x + along.y * v.y, along.y * v.x - along.x * v.y};
  };
  return std::all_of(rings.begin(), rings.end(), [&](const Ring& ring) {
    return std::all_of(ring.begin(), ring.end(),
                       [&](Point p) { return border.is_near(mirrored(p)); });
  });
}

/// Makes an angle that is only rounding away from a multiple of 45 degrees exact.
double snapped(double angle) {
  constexpr double kEighth = std::numbers::pi / 4.0;
  const double nearest = kEighth * std::round(angle / kEighth);
  return std::fabs(angle - nearest) < 1e-9 ? nearest : angle;
}

/// Returns the axes among the angles first + i pi / count. Axes within the tolerance that are not
/// at equal angles are no group; then only the one nearest to +y counts.
MirrorAxes axes_among(double first, int count, std::span<const Ring> rings, const EdgeGrid& border,
                      Point centre) {
  MirrorAxes axes{centre, 0.0, 0};
  double upright = -1.0;
  std::vector<int> found;
  for (int i = 0; i < count; ++i) {
    const double angle = snapped(first + i * std::numbers::pi / count);
    if (!is_axis(rings, border, centre, angle)) continue;
    found.push_back(i);
    if (std::fabs(std::sin(angle)) > upright + 1e-9) {
      upright = std::fabs(std::sin(angle));
      axes.angle_rad = angle;
    }
  }
  axes.count = static_cast<int>(found.size());
  for (std::size_t i = 1; i < found.size(); ++i) {
    if (axes.count * (found[i] - found[i - 1]) != count) axes.count = 1;
  }
  return axes;
}

}  // namespace mirror_search

MirrorAxes find_mirror_axes(std::span<const std::vector<Cubic>> curves, std::span<const Ring> rings,
                            double tolerance_mm) {
  using namespace mirror_search;
  // A moment below this share of the largest possible one is rounding.
  constexpr double kSignificant = 1e-7;
  const Point start = curves.front().front().p[0];
  const Moments about_start = moments_of(curves, start);
  if (!(about_start.m[0].real() > 0.0)) return {};
  const Complex mean = about_start.m[1] / about_start.m[0] * about_start.radius_mm;
  const Point centre = start + Vec{mean.real(), mean.imag()};
  const Moments moments = moments_of(curves, centre);

  std::vector<EdgeGrid::Edge> edges;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
  }
  const EdgeGrid border(std::move(edges), tolerance_mm);
  for (int k = 2; k <= kMaxAxes; ++k) {
    const Complex m = moments.m[static_cast<std::size_t>(k)];
    if (std::abs(m) < kSignificant * moments.m[0].real()) continue;
    const MirrorAxes axes = axes_among(std::arg(m) / k, k, rings, border, centre);
    if (axes.count > 0) return axes;
  }
  return axes_among(0.0, 4, rings, border, centre);
}

}  // namespace felt
