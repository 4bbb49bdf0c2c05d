#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "felt/devices/evdev/effect_plan.h"
#include "felt/devices/evdev/stick_axes.h"
#include "felt/driver/input_nodes.h"

namespace felt {

/// Our description of an input device with force feedback.
struct StickKind {
  StickLayout layout;
  StickForces forces;
  std::string label;  ///< for the user
  bool is_wheel = false;
  bool is_known = false;  ///< the strength comes from the table; otherwise the largest plausible
                          ///< strength is assumed
};

/// Returns the description of a device. Returns nullopt if the device has no axis, no button for
/// the pen, or no force along an axis; for example, a game pad that only rumbles is a cue device.
///
/// The kernel does not report the strength of a device's motors. A device that is not in the table
/// is assumed to be as strong as the strongest of its kind: 10 N for a stick, 60 N at the rim of a
/// wheel (8 N m, direct drive). So the hand may feel less force than intended, but never more.
std::optional<StickKind> stick_kind(const InputNode& node);

}  // namespace felt
