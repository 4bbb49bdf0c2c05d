#include "felt/devices/pantograph/five_bar.h"

#include <algorithm>
#include <cmath>

namespace felt::pantograph {
namespace {

constexpr double kMetresPerMm = 0.001;
constexpr double kMinElbowGap =
    0.02;  // part of a forearm's length; if closer, the position of the handle is undefined

double cross(const Vec3& a, const Vec3& b) noexcept {
  return a.x * b.y - a.y * b.x;
}

double flat_dot(const Vec3& a, const Vec3& b) noexcept {
  return a.x * b.x + a.y * b.y;
}

// Rises from 0 at `from` to 1 at `to`. It is smooth, so that forces do not jump.
double smooth_step(double from, double to, double v) noexcept {
  const double t = std::clamp((v - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

std::optional<FiveBar> FiveBar::at(const FiveBarSize& size,
                                   const std::array<double, 2>& angles_rad) noexcept {
  const double c1 = std::cos(angles_rad[0]), s1 = std::sin(angles_rad[0]);
  const double c2 = std::cos(angles_rad[1]), s2 = std::sin(angles_rad[1]);
  const Vec3 a{size.arm_mm * c1, size.arm_mm * s1, 0.0};
  const Vec3 b{size.base_mm + size.arm_mm * c2, size.arm_mm * s2, 0.0};
  const Vec3 half = 0.5 * (b - a);
  const double half_gap = std::hypot(half.x, half.y);
  const double forearm = size.forearm_mm;
  // Written so that NaN is rejected, too.
  if (!(half_gap >= kMinElbowGap * forearm && half_gap <= forearm)) return std::nullopt;
  const double height = std::sqrt(forearm * forearm - half_gap * half_gap) / half_gap;

  FiveBar bar;
  bar.place_ = a + half + Vec3{-height * half.y, height * half.x, 0.0};
  const Vec3 u = bar.place_ - a, w = bar.place_ - b;
  const double area = cross(u, w);
  const double sine = std::abs(area) / (forearm * forearm);
  bar.authority_ = smooth_step(kNoAuthority, kAllAuthority, sine);
  constexpr double kMinSine = 1e-9;
  if (sine < kMinSine) return bar;  // the linkage is singular: no Jacobian, and authority_ is 0
  const double turn_a = flat_dot(u, {-size.arm_mm * s1, size.arm_mm * c1, 0.0}) / area;
  const double turn_b = flat_dot(w, {-size.arm_mm * s2, size.arm_mm * c2, 0.0}) / area;
  bar.jacobian_ = {{{w.y * turn_a, -u.y * turn_b}, {-w.x * turn_a, u.x * turn_b}}};
  return bar;
}

Vec3 FiveBar::velocity(const std::array<double, 2>& omega_rad_s) const noexcept {
  return {jacobian_[0][0] * omega_rad_s[0] + jacobian_[0][1] * omega_rad_s[1],
          jacobian_[1][0] * omega_rad_s[0] + jacobian_[1][1] * omega_rad_s[1], 0.0};
}

std::array<double, 2> FiveBar::torques(const Force& force) const noexcept {
  const auto torque = [&](std::size_t k) {
    return kMetresPerMm * (jacobian_[0][k] * force.x + jacobian_[1][k] * force.y);
  };
  return {torque(0), torque(1)};
}

std::optional<std::array<double, 2>> angles_for(const FiveBarSize& size,
                                                const Vec3& place) noexcept {
  std::array<double, 2> angles{};
  for (std::size_t k = 0; k < 2; ++k) {
    const double x = place.x - (k == 0 ? 0.0 : size.base_mm), y = place.y;
    const double reach = std::hypot(x, y);
    const double cosine =
        (size.arm_mm * size.arm_mm + reach * reach - size.forearm_mm * size.forearm_mm) /
        (2.0 * size.arm_mm * reach);
    if (!(std::abs(cosine) <= 1.0)) return std::nullopt;
    const double bend = std::acos(cosine);
    angles[k] = std::atan2(y, x) + (k == 0 ? bend : -bend);
  }
  return angles;
}

}  // namespace felt::pantograph
