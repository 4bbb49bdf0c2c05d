#include "felt/devices/evdev/effect_plan.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

constexpr double kFull = 32767.0;
constexpr double kFullSaturation = 65535.0;
constexpr double kMinN = 0.01;   // a smaller force cannot be felt
constexpr double kGrowN = 0.05;  // by which a spring may exceed its current force
constexpr double kAlmost = 0.9998;
constexpr double kTurn = 65536.0 / 6.283185307179586;

std::int16_t signed16(double share) noexcept {
  return static_cast<std::int16_t>(std::lround(std::clamp(share, -1.0, 1.0) * kFull));
}

/// Rounds down, so that a saturation is never larger than the intended force.
std::uint16_t saturation(double share) noexcept {
  return static_cast<std::uint16_t>(std::clamp(share, 0.0, 1.0) * kFullSaturation);
}

/// The effects of one axis, in N and mm, before conversion to 16-bit numbers.
struct AxisPlan {
  double spring_n = 0.0;  ///< saturation
  double stiffness_n_per_mm = 0.0;
  double center_mm = 0.0;
  double friction_n = 0.0;
  double constant_n = 0.0;

  [[nodiscard]] double max_n() const noexcept {
    return spring_n + friction_n + std::abs(constant_n);
  }
};

AxisPlan plan_axis(const AxisFit& fit, const StickForces& stick) noexcept {
  AxisPlan plan;
  plan.friction_n = fit.friction_n;
  if (!stick.effects[evdev::kFfSpring]) {
    plan.constant_n = stick.effects[evdev::kFfConstant] ? fit.force_n : 0.0;
    return plan;
  }
  const double k = fit.stiffness_n_per_mm;
  const double center_mm = k > 0.0 ? fit.position_mm + fit.force_n / k : 0.0;
  if (k > 0.0 && std::abs(center_mm) <= stick.half_way_mm) {
    plan.stiffness_n_per_mm = k;
    plan.center_mm = center_mm;
    plan.spring_n = std::abs(fit.force_n) + kGrowN;
    return plan;
  }
  // The force is nearly constant: uses the stiffest possible spring, centred at the end of the
  // travel.
  plan.stiffness_n_per_mm = stick.full_force_n / stick.half_way_mm;
  plan.center_mm = std::copysign(stick.half_way_mm, fit.force_n);
  plan.spring_n = std::abs(fit.force_n);
  return plan;
}

EvdevCondition spring_of(const AxisPlan& axis, const StickForces& stick) noexcept {
  EvdevCondition spring;
  spring.right_saturation = spring.left_saturation = saturation(axis.spring_n / stick.full_force_n);
  spring.right_coefficient = spring.left_coefficient =
      signed16(axis.stiffness_n_per_mm * stick.half_way_mm / stick.full_force_n);
  spring.center = signed16(axis.center_mm / stick.half_way_mm);
  return spring;
}

EvdevCondition friction_of(const AxisPlan& axis, const StickForces& stick) noexcept {
  EvdevCondition friction;
  friction.right_saturation = friction.left_saturation =
      saturation(axis.friction_n / stick.full_force_n);
  friction.right_coefficient = friction.left_coefficient =
      static_cast<std::int16_t>(std::clamp(axis.friction_n / stick.full_force_n, 0.0, 1.0) * kFull);
  return friction;
}

/// Returns the largest force of an effect along each axis, as a part of the full force.
std::array<double, 2> shares_of(const EffectPlan& plan, std::size_t kind) noexcept {
  if (!plan.plays[kind]) return {};
  const EvdevEffect& effect = plan.effects[kind];
  if (kind == EffectPlan::kConstant) {
    const double level = std::abs(effect.level) / kFull, angle = effect.direction / kTurn;
    return {level * std::abs(std::sin(angle)), level * std::abs(std::cos(angle))};
  }
  std::array<double, 2> shares{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const EvdevCondition& c = effect.conditions[axis];
    shares[axis] = std::max(c.left_saturation, c.right_saturation) / kFullSaturation;
  }
  return shares;
}

}  // namespace

FitAbility ability_of(const StickForces& stick) noexcept {
  return {.spring = stick.effects[evdev::kFfSpring],
          .friction = stick.effects[evdev::kFfFriction] || stick.effects[evdev::kFfDamper],
          .max_stiffness_n_per_mm = stick.full_force_n / stick.half_way_mm};
}

EffectPlan plan_effects(std::span<const AxisFit, 2> fits, const StickForces& stick,
                        double max_n) noexcept {
  std::array<AxisPlan, 2> axes{plan_axis(fits[0], stick),
                               stick.has_y ? plan_axis(fits[1], stick) : AxisPlan{}};
  const double worst_n = std::hypot(axes[0].max_n(), axes[1].max_n());
  EffectPlan plan;
  if (!std::isfinite(worst_n) || !(max_n > 0.0)) return plan;
  // Uses slightly less than the maximum, because a constant's direction has only 16 bits.
  const double share = worst_n > kAlmost * max_n ? kAlmost * max_n / worst_n : 1.0;
  for (AxisPlan& axis : axes) {
    axis.spring_n *= share;
    axis.friction_n *= share;
    axis.constant_n *= share;
  }
  for (EvdevEffect& effect : plan.effects) effect.length_ms = kEffectMs;

  EvdevEffect& spring = plan.effects[EffectPlan::kSpring];
  spring.type = evdev::kFfSpring;
  spring.conditions = {spring_of(axes[0], stick), spring_of(axes[1], stick)};
  plan.plays[EffectPlan::kSpring] = std::max(axes[0].spring_n, axes[1].spring_n) > kMinN;

  EvdevEffect& friction = plan.effects[EffectPlan::kFriction];
  friction.type = stick.effects[evdev::kFfFriction] ? evdev::kFfFriction : evdev::kFfDamper;
  friction.conditions = {friction_of(axes[0], stick), friction_of(axes[1], stick)};
  if (friction.type == evdev::kFfDamper) {
    // The speed at which a damper reaches its full force is unknown. So the coefficient is the
    // largest possible one, and the saturation limits the force.
    for (EvdevCondition& c : friction.conditions) {
      const bool brakes = c.right_saturation > 0;
      c.right_coefficient = c.left_coefficient = brakes ? signed16(1.0) : std::int16_t{0};
    }
  }
  plan.plays[EffectPlan::kFriction] = std::max(axes[0].friction_n, axes[1].friction_n) > kMinN;

  EvdevEffect& constant = plan.effects[EffectPlan::kConstant];
  const double x = axes[0].constant_n, y = axes[1].constant_n;
  constant.type = evdev::kFfConstant;
  constant.level =
      static_cast<std::int16_t>(std::min(std::hypot(x, y) / stick.full_force_n, 1.0) * kFull);
  // A direction of 0 is towards the user (+y), and a quarter turn is to the left (-x).
  constant.direction = static_cast<std::uint16_t>(
      static_cast<std::int32_t>(std::lround(std::atan2(-x, y) * kTurn)) & 0xFFFF);
  plan.plays[EffectPlan::kConstant] = std::hypot(x, y) > kMinN;
  return plan;
}

double strongest_n(const EffectPlan& one, const EffectPlan& other,
                   const StickForces& stick) noexcept {
  std::array<double, 2> shares{};
  for (std::size_t kind = 0; kind < EffectPlan::kKinds; ++kind) {
    const std::array<double, 2> a = shares_of(one, kind), b = shares_of(other, kind);
    for (std::size_t axis = 0; axis < 2; ++axis) shares[axis] += std::max(a[axis], b[axis]);
  }
  return std::hypot(shares[0], shares[1]) * stick.full_force_n;
}

}  // namespace felt
