#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>

#include "felt/devices/evdev/local_fit.h"
#include "felt/driver/evdev_port.h"

namespace felt {

/// The properties of a stick or wheel that matter for its effects.
struct StickForces {
  std::bitset<evdev::kFfCount> effects;  ///< kinds of effects that the device supports
  double full_force_n = 10.0;            ///< full force at the grip, with all motors
  double half_way_mm = 45.0;             ///< travel of the grip from the centre to position 32767
  bool has_y = true;                     ///< a wheel has x only
};

/// Effects that together make a force: at most one spring, one friction and one constant force.
struct EffectPlan {
  enum Kind : std::uint8_t { kSpring, kFriction, kConstant };
  static constexpr std::size_t kKinds = 3;
  std::array<EvdevEffect, kKinds> effects{};
  std::bitset<kKinds> plays;  ///< the effects that play

  friend bool operator==(const EffectPlan&, const EffectPlan&) = default;
};

/// Returns the parts of a force that this stick can render by itself.
FitAbility ability_of(const StickForces& stick) noexcept;

/// Returns effects that render the fitted force laws of both axes until the next plan replaces
/// them. The centre of the stick is (0, 0). However the grip moves, the effects together never push
/// with more than `max_n`, because the saturation of each effect limits its force. If necessary,
/// all effects are scaled down by the same factor.
///
/// Condition effects (springs and frictions) are preferred: their direction does not depend on how
/// a kernel driver interprets the direction field, and if the program hangs, a spring still has its
/// centre where the program put it. A force that hardly depends on the position becomes a saturated
/// spring whose centre is at the end of the travel. Any other spring saturates at 0.05 N above its
/// current force: if the requested force merely rose with time, the fit may have mistaken this for
/// stiffness, and the spring must not push much harder than requested.
///
/// Units are those of DirectInput's definition of the same effects, which kernel drivers pass on: a
/// spring of coefficient 32767 pushes with the full force at half the travel from its centre. A
/// device that interprets the coefficient differently renders a stiffer or softer spring, but its
/// force still does not exceed the saturation.
EffectPlan plan_effects(std::span<const AxisFit, 2> fits, const StickForces& stick,
                        double max_n) noexcept;

/// Returns the largest force, N, that is possible at any position of the grip if each effect may
/// come from either plan. Such a mixture occurs because the effects of a new plan are uploaded one
/// after another.
double strongest_n(const EffectPlan& one, const EffectPlan& other,
                   const StickForces& stick) noexcept;

/// Duration of each effect. An effect ends by itself unless it is played again, so that no force
/// remains if the program hangs.
inline constexpr std::uint16_t kEffectMs = 100;

}  // namespace felt
