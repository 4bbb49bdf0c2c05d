#include "felt/stroke/outline/envelope.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace felt {
namespace {

/// Returns true if the end of a normal of length r at a dab is within the left half strip of a
/// stretch. The stretch reaches from `begin` to `end` along its tangent, with the dab at 0. In the
/// skewed axes (tangent, normal) of the strip, this is begin <= a <= end, 0 <= b <= radius.
bool reaches_into(Vec normal, const EnvelopeFrame& strip, double begin, double end,
                  double r) noexcept {
  // A stretch that is almost covered by one dab has a negligible strip and ill-conditioned axes.
  if (strip.height < 1e-3) return false;
  const double b = r * cross(strip.tangent, normal) / strip.height;
  const double a = r * dot(normal, strip.tangent) + b * strip.slope;
  const double slack = 1e-9 * r;
  return a >= begin - slack && a <= end + slack && b >= 0.0 && b <= r + strip.slope * a + slack;
}

/// Returns the angle by which the left normal turns, in (-2 pi, 2 pi): not reduced modulo 2 pi.
double normal_turn(const EnvelopeFrame& from, const EnvelopeFrame& to, int tie) noexcept {
  const double c = cross(from.tangent, to.tangent), d = dot(from.tangent, to.tangent);
  const Vec n = from.normal(), m = to.normal();
  // The tangents and the normals differ by less than a right angle, so the angle is unambiguous.
  if (d > 0.0 && dot(n, m) > 0.5) return std::atan2(cross(n, m), dot(n, m));
  // If the stroke reverses its direction, rounding must not decide whether it turns left or right,
  // because rounding differs between the sides.
  const bool reverses = d < 0.0 && std::fabs(c) < 1e-9;
  const double heading = reverses ? tie * std::numbers::pi : std::atan2(c, d);
  return heading + to.normal_angle() - from.normal_angle();
}

}  // namespace

EnvelopeFrame EnvelopeFrame::of(Vec tangent, double dr, double ds) noexcept {
  if (std::fabs(dr) >= ds) return {tangent, dr < 0.0 ? -1.0 : 1.0, 0.0};
  const double slope = dr / ds;
  return {tangent, slope, std::sqrt((1.0 - slope) * (1.0 + slope))};
}

bool has_room(const Stretch& from, const Stretch& to, double radius_mm) noexcept {
  return reaches_into(from.frame.normal(), to.frame, 0.0, to.length_mm, radius_mm) &&
         reaches_into(to.frame.normal(), from.frame, -from.length_mm, 0.0, radius_mm);
}

Turn turn_between(const Stretch& from, const Stretch& to, double radius_mm, int tie) noexcept {
  const double sweep = normal_turn(from.frame, to.frame, tie);
  if (sweep <= 0.0) return {Turn::Kind::kArc, sweep};
  return {has_room(from, to, radius_mm) ? Turn::Kind::kShortcut : Turn::Kind::kPivot, 0.0};
}

}  // namespace felt
