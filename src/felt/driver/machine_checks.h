#pragma once

#include <string>
#include <vector>

#include "felt/driver/diagnosis.h"

namespace felt {

/// The file that `doctor --fix` writes to allow this user's programs to run in real time.
inline constexpr std::string_view kLimitsFile = "/etc/security/limits.d/70-feltline.conf";

/// Checks the computer itself, independent of devices: whether the force loop may run in real time
/// with its memory locked, whether settings and unsaved drawings can be stored, whether a screen
/// exists, whether the kernel supports haptic touchpads, and whether a system service gives the
/// user access to devices that are plugged in. Uses the system only through `system`.
std::vector<Finding> diagnose_machine(const SystemView& system);

/// A version of the kernel: the major and minor number of a text like "6.1.0-13-amd64". Both are 0
/// if the text has another form.
struct KernelVersion {
  int major = 0, minor = 0;
  friend auto operator<=>(const KernelVersion&, const KernelVersion&) = default;
};
KernelVersion kernel_version(const SystemView& system);

/// Returns the lines of kLimitsFile, in the form of limits.d(5), that grant a user the rights that
/// the force loop needs.
std::string limits_lines(const std::string& user);

}  // namespace felt
