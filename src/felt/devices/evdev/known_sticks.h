#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "felt/devices/evdev/effect_plan.h"
#include "felt/devices/evdev/stick_axes.h"
#include "felt/driver/input_nodes.h"

namespace felt {

/// What is made of an input device with force feedback.
struct StickKind {
  StickLayout layout;
  StickForces forces;
  std::string label;  ///< for people
  bool is_wheel = false;
  bool is_known = false;  ///< its strength is from the table; else it is taken for a strong one
};

/// None where it has no axis, no button for the pen, or no force along an axis: a game pad that
/// only rumbles is a cue device.
///
/// How strong a device's motors are the kernel does not tell. A device that is not in the table
/// counts as the strongest of its kind, so that it is asked for less than it should, never more: 10
/// N for a stick, 60 N at the rim of a wheel (8 N m, direct drive).
std::optional<StickKind> stick_kind(const InputNode& node);

}  // namespace felt
