#pragma once

#include <QString>
#include <optional>

#include "felt/haptics/safety/safety_chain.h"
#include "felt/rt/device.h"

namespace felt::desktop {

/// How a state is to be taken; chooses its icon.
enum class FeelLevel { kShown, kOff, kWaiting, kOn, kLimited, kStopped };

/// What the safety chain does, for people.
struct SafetyWords {
  FeelLevel level = FeelLevel::kOff;
  QString state;   ///< "Forces are on"
  QString detail;  ///< what to know or do about it; may be empty
};

/// `has_motors`: the pen pushes back at all. `wanted`: a person has switched the forces on.
/// `device` is its newest fault, which says more than "the device does not answer".
SafetyWords words_for(const SafetyReport& safety, bool has_motors, bool wanted,
                      std::optional<DeviceFault> device = {});

/// Why force was taken away, as half a sentence: "the pen jumped". Empty for kNone.
QString words_for(SafetyFault fault);

/// The term of a force, by the name of its brick: "plane" -> "Sheet".
QString term_label(const char* name);

}  // namespace felt::desktop
