#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>

#include "felt/devices/evdev/local_fit.h"
#include "felt/driver/evdev_port.h"

namespace felt {

/// What a stick or wheel is, for those who plan its effects.
struct StickForces {
  std::bitset<evdev::kFfCount> effects;  ///< kinds that it has
  double full_force_n = 10.0;            ///< at the grip, of all its motors can
  double half_way_mm = 45.0;             ///< of the grip from the middle to an end: position 32767
  bool has_y = true;                     ///< a wheel has x alone
};

/// Effects of a stick that together are a force; at most one of each kind, in this order.
struct EffectPlan {
  enum Kind : std::uint8_t { kSpring, kFriction, kConstant };
  static constexpr std::size_t kKinds = 3;
  std::array<EvdevEffect, kKinds> effects{};
  std::bitset<kKinds> plays;  ///< which of them

  friend bool operator==(const EffectPlan&, const EffectPlan&) = default;
};

/// What such a stick can do of a force by itself.
FitAbility ability_of(const StickForces& stick) noexcept;

/// Effects that do what the fits say until the next ones come, on a stick whose middle is at
/// (0, 0). No effects together ever push with more than `most_n`, wherever the grip goes
/// meanwhile: by their saturations, all of which are made smaller alike where that must be.
///
/// Condition effects are the first choice: which way they push does not depend on how a kernel
/// driver reads a direction, and where the program hangs a spring stays a spring. A force that does
/// not change with the place is a spring to the end of the way, saturated. No spring grows by more
/// than 0.05 N until the next plan, so that a force that rises is not taken for a stiff one.
///
/// Units as of DirectInput's definition of the same effects, which kernel drivers hand on: a spring
/// of coefficient 32767 pushes with the full force when it is half the way from its centre. A
/// device that means something else is stiffer or softer, never stronger than its saturation.
EffectPlan plan_effects(std::span<const AxisFit, 2> fits, const StickForces& stick,
                        double most_n) noexcept;

/// The most that the effects can push with, N, wherever the grip is, while each of them is that of
/// one plan or of the other: effects are uploaded one after another.
double strongest_n(const EffectPlan& one, const EffectPlan& other,
                   const StickForces& stick) noexcept;

/// All effects end by themselves after this, unless they are played again: a program that hangs
/// leaves no force.
inline constexpr std::uint16_t kEffectMs = 100;

}  // namespace felt
