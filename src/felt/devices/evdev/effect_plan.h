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
  std::bitset<evdev::kFfCount> effects;  ///< kinds that it supports
  double full_force_n = 10.0;            ///< at the grip, with all motors
  double half_way_mm = 45.0;             ///< travel of the grip from the centre to position 32767
  bool has_y = true;                     ///< a wheel has x only
};

/// Effects that together make a force. At most one of each kind can play.
struct EffectPlan {
  enum Kind : std::uint8_t { kSpring, kFriction, kConstant };
  static constexpr std::size_t kKinds = 3;
  std::array<EvdevEffect, kKinds> effects{};
  std::bitset<kKinds> plays;  ///< which of them play

  friend bool operator==(const EffectPlan&, const EffectPlan&) = default;
};

/// Returns the parts of a force that this stick can render by itself.
FitAbility ability_of(const StickForces& stick) noexcept;

/// Returns effects that render the fits until the next ones arrive, on a stick with its centre at
/// (0, 0). Together they never push with more than `most_n`, whatever the grip's motion: their
/// saturations guarantee that, and all are scaled down by the same factor if necessary.
///
/// Condition effects are preferred: their direction does not depend on how a kernel driver
/// interprets the direction field, and if the program hangs, a spring remains a spring. A force
/// that does not depend on the position becomes a saturated spring to the end of the travel. No
/// spring grows by more than 0.05 N until the next plan, so that a rising force is not mistaken for
/// a stiff one.
///
/// Units are those of DirectInput's definition of the same effects, which kernel drivers pass on: a
/// spring of coefficient 32767 pushes with the full force at half the travel from its centre. A
/// device with another interpretation is stiffer or softer, but never stronger than its saturation.
EffectPlan plan_effects(std::span<const AxisFit, 2> fits, const StickForces& stick,
                        double most_n) noexcept;

/// Returns the largest possible force, N, at any position of the grip, if each effect comes from
/// either of two plans. This happens because effects are uploaded one after another.
double strongest_n(const EffectPlan& one, const EffectPlan& other,
                   const StickForces& stick) noexcept;

/// Duration of all effects. They end by themselves unless they are played again, so that no force
/// remains if the program hangs.
inline constexpr std::uint16_t kEffectMs = 100;

}  // namespace felt
