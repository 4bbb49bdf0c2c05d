#include "felt/tools/eraser/swept.h"

#include <algorithm>
#include <array>
#include <span>

#include "felt/stroke/width_profile.h"
#include "felt/tools/eraser/below_zero.h"

namespace felt {
namespace {

using Linear = std::array<double, 4>;  // Bernstein coefficients, degree 3

/// A piece of a segment over which the radius is linear, elevated to degree 3.
struct Tube {
  Cubic curve;
  Linear radius;

  Tube(const Cubic& c, double at_start, double at_end) noexcept
      : curve(c),
        radius{at_start, (2.0 * at_start + at_end) / 3.0, (at_start + 2.0 * at_end) / 3.0, at_end} {
  }
};

/// Returns the parts with |f - center|^2 - r^2 < 0. The Bernstein coefficients of this polynomial
/// are c_k = sum over i + j = k of C(3,i) C(3,j) / C(6,k) (a_i.a_j - r_i r_j).
UnitParts within_disc(const Tube& tube, Point center) noexcept {
  const auto term = [&](std::size_t i, std::size_t j) {
    return dot(tube.curve.p[i] - center, tube.curve.p[j] - center) -
           tube.radius[i] * tube.radius[j];
  };
  const std::array<double, 7> c{term(0, 0),
                                term(0, 1),
                                0.4 * term(0, 2) + 0.6 * term(1, 1),
                                0.1 * term(0, 3) + 0.9 * term(1, 2),
                                0.4 * term(1, 3) + 0.6 * term(2, 2),
                                term(2, 3),
                                term(3, 3)};
  return below_zero(c);
}

UnitParts within_rectangle(const Tube& tube, Point from, Point to) noexcept {
  const double length = distance(from, to);
  const Vec along = normalized(to - from), across = perp(along);
  if (along == Vec{}) return {};
  const auto below = [&](Vec axis, double offset, double radii) {
    Linear c;
    for (std::size_t k = 0; k < 4; ++k) {
      c[k] = dot(axis, tube.curve.p[k] - from) - offset - radii * tube.radius[k];
    }
    return below_zero(c);
  };
  UnitParts parts = below(across, 0.0, 1.0);
  if (!parts.empty()) parts = common(parts, below(-across, 0.0, 1.0));
  if (!parts.empty()) parts = common(parts, below(-along, 0.0, 0.0));
  if (!parts.empty()) parts = common(parts, below(along, length, 0.0));
  return parts;
}

class Sweep {
 public:
  Sweep(const Capsule& capsule, ParameterSet& swept) noexcept
      : capsule_(capsule), axis_(capsule.axis_bounds()), swept_(swept) {}

  /// Adds a piece of a segment from u0 to u1. The last two arguments are the ink's width at its
  /// ends.
  void add(const Cubic& curve, double u0, double u1, double width0, double width1) {
    const double half = capsule_.adds_half_width ? 0.5 : 0.0;
    const Tube tube(curve, capsule_.radius_mm + half * width0, capsule_.radius_mm + half * width1);
    const double largest = std::max(tube.radius[0], tube.radius[3]);
    if (!control_bounds(curve).intersects(axis_.inflated(largest))) return;
    unite(within_disc(tube, capsule_.to), u0, u1);
    if (capsule_.from == capsule_.to) return;
    if (!capsule_.goes_on) unite(within_disc(tube, capsule_.from), u0, u1);
    unite(within_rectangle(tube, capsule_.from, capsule_.to), u0, u1);
  }

  /// Returns false if the capsule is too far away to touch ink of this width.
  [[nodiscard]] bool may_reach(const Cubic& curve, double width_mm) const noexcept {
    return control_bounds(curve).intersects(axis_.inflated(capsule_.radius_mm + 0.5 * width_mm));
  }
  [[nodiscard]] bool grew() const noexcept { return grew_; }

 private:
  void unite(const UnitParts& parts, double u0, double u1) {
    const auto at = [&](double t) { return t >= 1.0 ? u1 : u0 + t * (u1 - u0); };
    for (const auto& part : parts) grew_ |= swept_.add({at(part.from), at(part.to)});
  }

  const Capsule& capsule_;
  Rect axis_;
  ParameterSet& swept_;
  bool grew_ = false;
};

/// Returns the largest width from u = begin to u = end.
double widest_between(std::span<const WidthKnot> knots, double begin, double end) noexcept {
  double widest = std::max(width_at(knots, begin), width_at(knots, end));
  auto k = std::upper_bound(knots.begin(), knots.end(), begin,
                            [](double x, const WidthKnot& knot) { return x < knot.u; });
  for (; k != knots.end() && k->u < end; ++k) widest = std::max(widest, k->width_mm);
  return widest;
}

}  // namespace

bool add_swept(const Stroke& stroke, int segment, const Capsule& capsule, ParameterSet& swept) {
  const Cubic curve = stroke.segment(segment);
  const double begin = segment, end = segment + 1.0;
  Sweep sweep(capsule, swept);
  if (!capsule.adds_half_width) {
    sweep.add(curve, begin, end, 0.0, 0.0);
    return sweep.grew();
  }
  const auto knots = stroke.widths();
  double u = begin, width = width_at(knots, begin);
  if (!sweep.may_reach(curve, widest_between(knots, begin, end))) return false;
  auto next = std::upper_bound(knots.begin(), knots.end(), begin,
                               [](double x, const WidthKnot& k) { return x < k.u; });
  while (u < end) {
    const bool last = next == knots.end() || next->u >= end;
    const double to = last ? end : next->u;
    const double to_width = last ? width_at(knots, end) : next->width_mm;
    sweep.add(sub_segment(curve, u - begin, to - begin), u, to, width, to_width);
    u = to;
    width = to_width;
    if (!last) ++next;
  }
  return sweep.grew();
}

}  // namespace felt
