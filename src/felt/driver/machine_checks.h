#pragma once

#include <string>
#include <vector>

#include "felt/driver/diagnosis.h"

namespace felt {

/// Where `doctor --fix` keeps what lets this user's programs run in real time.
inline constexpr std::string_view kLimitsFile = "/etc/security/limits.d/70-feltline.conf";

/// What a doctor sees of the computer itself, whatever device is at hand: whether the force loop
/// may run in real time with its memory locked, whether settings and unsaved drawings can be kept,
/// whether there is a screen, a kernel that knows haptic touchpads, somebody who gives rights to
/// devices that are plugged in. Looks through `system` only.
std::vector<Finding> diagnose_machine(const SystemView& system);

/// Like "6.1.0-13-amd64": major and minor number; zeros where it is no such text.
struct KernelVersion {
  int major = 0, minor = 0;
  friend auto operator<=>(const KernelVersion&, const KernelVersion&) = default;
};
KernelVersion kernel_version(const SystemView& system);

/// The lines of limits.d(5) that give a user what the force loop asks for.
std::string limits_lines(const std::string& user);

}  // namespace felt
