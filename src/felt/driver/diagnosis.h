#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"

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

/// The system as a doctor looks at it, so that tests can show it any other: files below a root,
/// who the user is, what the environment says, whether a library loads, whether somebody listens on
/// a port. Looks only; changes nothing. Edit thread.
class SystemView {
 public:
  virtual ~SystemView() = default;

  /// Names in a folder, sorted; empty where there is none. Paths are absolute
  /// ("/sys/class/hidraw").
  [[nodiscard]] virtual std::vector<std::string> list(std::string_view folder) const = 0;
  /// The first 64 KiB of a file, or nothing where it cannot be read.
  [[nodiscard]] virtual std::optional<std::string> read(std::string_view path) const = 0;
  [[nodiscard]] virtual bool exists(std::string_view path) const = 0;
  /// May this user read and write it? Error: kNotFound, or kIo with errno's own text.
  [[nodiscard]] virtual Result<void> may_use(std::string_view path) const = 0;
  /// The target of a link, resolved; empty where it is none.
  [[nodiscard]] virtual std::string resolve(std::string_view path) const = 0;
  [[nodiscard]] virtual std::string user() const = 0;
  /// Of this process (not of the user data base: a new group counts after the next log-in).
  [[nodiscard]] virtual std::vector<std::string> groups() const = 0;
  [[nodiscard]] virtual std::optional<std::string> environment(std::string_view name) const = 0;
  /// Loads a library and lets it go again. Error: dlerror(), verbatim.
  [[nodiscard]] virtual Result<void> try_library(const std::string& name) const = 0;
  /// Does somebody listen on this TCP port of this host ("localhost", or numbers)?
  [[nodiscard]] virtual bool listens(const std::string& host, std::uint16_t port) const = 0;
};

/// This machine.
const SystemView& this_system();

}  // namespace felt
