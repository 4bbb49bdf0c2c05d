#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace felt {

enum class FindingLevel : std::uint8_t {
  kOk,       ///< there, and as it should be
  kAbsent,   ///< nothing of this maker is here: no problem for those who own nothing of it
  kWarning,  ///< works, but not as well as it could
  kProblem,  ///< hinders: `steps` say what to do
};

/// A file that only the system's owner may write, and what should be in it: `doctor --fix`.
struct SystemFix {
  std::string path;     ///< "/etc/udev/rules.d/70-feltline-novint.rules"
  std::string content;  ///< whole; a first line that says it is ours is added (kOurFileMark)
  /// Shell command that puts it into effect, as root; empty: nothing can but a step of the person.
  std::string activate;
};

/// One thing that a doctor saw, for people.
struct Finding {
  FindingLevel level = FindingLevel::kOk;
  std::string what;          ///< "The OpenHaptics library was not found."
  std::string details = {};  ///< verbatim: dlerror(), errno's text, a version; may be empty
  /// What to do, in order, each one action: a sentence, and where a command does it, that command
  /// as one types it on a line of its own, so that it can be copied:
  /// "Install the library that it needs:\nsudo apt install libncurses5".
  std::vector<std::string> steps = {};
  /// `doctor --fix` writes this; say so in a step: "Let Feltline do it:\nfeltline doctor --fix".
  std::optional<SystemFix> fix = {};
};

/// The first line of every file that `doctor --fix` writes: what begins so is ours to add to.
inline constexpr std::string_view kOurFileMark =
    "# Written by 'feltline doctor --fix', which may write it anew.\n";
/// Brings udev rules into effect for what is plugged in already: SystemFix::activate of such files.
inline constexpr std::string_view kReloadUdev =
    "udevadm control --reload-rules && udevadm trigger --subsystem-match=usb"
    " --subsystem-match=hidraw --subsystem-match=tty --subsystem-match=input";

}  // namespace felt
