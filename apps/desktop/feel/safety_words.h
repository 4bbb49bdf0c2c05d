#pragma once

#include <QString>
#include <optional>

#include "felt/haptics/safety/safety_chain.h"
#include "felt/rt/device.h"

namespace felt::desktop {

/// The kind of a state of the safety chain. It determines the icon.
enum class FeelLevel { kShown, kOff, kWaiting, kOn, kLimited, kStopped };

/// The state of the safety chain in words.
struct SafetyWords {
  FeelLevel level = FeelLevel::kOff;
  QString state;   ///< "Forces are on"
  QString detail;  ///< advice to the user; may be empty
};

/// Describes the state of the safety chain. `has_motors` is true if the device can exert forces;
/// `wanted` is true if the user has switched the forces on. `device` is the newest fault of the
/// device. If there is such a fault, the text names it, which is more precise than "the device does
/// not answer".
SafetyWords words_for(const SafetyReport& safety, bool has_motors, bool wanted,
                      std::optional<DeviceFault> device = {});

/// Returns in half a sentence why the force was removed: "the pen jumped". Empty for kNone.
QString words_for(SafetyFault fault);

/// Returns the label of a force term for the user. `name` is its internal name: "plane" ->
/// "Surface".
QString term_label(const char* name);

}  // namespace felt::desktop
