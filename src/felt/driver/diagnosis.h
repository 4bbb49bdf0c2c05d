#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"

namespace felt {

enum class FindingLevel : std::uint8_t {
  kOk,       ///< present and working
  kAbsent,   ///< nothing of this maker is here: no problem for a user who has no such device
  kWarning,  ///< works, but not as well as it could
  kProblem,  ///< does not work: `steps` say what to do
};

/// A file that needs root to write, and its content: for `doctor --fix`.
struct SystemFix {
  std::string path;  ///< "/etc/udev/rules.d/70-feltline-novint.rules"
  std::string
      content;  ///< the whole file; a first line that marks it as ours is added (kOurFileMark)
  /// Shell command that activates it, as root; empty: only a step of the user can.
  std::string activate;
};

/// One result of a diagnosis, for the user.
struct Finding {
  FindingLevel level = FindingLevel::kOk;
  std::string what;          ///< "The OpenHaptics library was not found."
  std::string details = {};  ///< verbatim: dlerror(), errno's text, a version; may be empty
  /// What to do, in order, one action each: a sentence, followed by the command, if there is one,
  /// on a line of its own so that it can be copied: "Install the library that it needs:\nsudo apt
  /// install libncurses5".
  std::vector<std::string> steps = {};
  /// Written by `doctor --fix`; mention it in a step: "Let Feltline do it:\nfeltline doctor --fix".
  std::optional<SystemFix> fix = {};
};

/// The first line of every file that `doctor --fix` writes. Files that start with it are ours to
/// change.
inline constexpr std::string_view kOurFileMark =
    "# Written by 'feltline doctor --fix', which may write it anew.\n";
/// Applies udev rules to devices that are already plugged in: SystemFix::activate of rule files.
inline constexpr std::string_view kReloadUdev =
    "udevadm control --reload-rules && udevadm trigger --subsystem-match=usb"
    " --subsystem-match=hidraw --subsystem-match=tty --subsystem-match=input";

/// The system as a diagnosis sees it, so that tests can substitute another one: files, the user,
/// environment variables, whether a library loads, whether a port is listened on. Reads only;
/// changes nothing. Used on the edit thread.
class SystemView {
 public:
  virtual ~SystemView() = default;

  /// Returns the names in a folder, sorted; empty if it does not exist. Paths are absolute
  /// ("/sys/class/hidraw").
  [[nodiscard]] virtual std::vector<std::string> list(std::string_view folder) const = 0;
  /// Returns the first 64 KiB of a file, or nullopt if it cannot be read.
  [[nodiscard]] virtual std::optional<std::string> read(std::string_view path) const = 0;
  [[nodiscard]] virtual bool exists(std::string_view path) const = 0;
  /// Succeeds if this user may read and write the file. Fails with kNotFound, or kIo with errno's
  /// text.
  [[nodiscard]] virtual Result<void> may_use(std::string_view path) const = 0;
  /// Returns the resolved target of a link; empty if `path` is not a link.
  [[nodiscard]] virtual std::string resolve(std::string_view path) const = 0;
  [[nodiscard]] virtual std::string user() const = 0;
  /// Returns the groups of this process (a group added to the user database counts only after the
  /// next login).
  [[nodiscard]] virtual std::vector<std::string> groups() const = 0;
  [[nodiscard]] virtual std::optional<std::string> environment(std::string_view name) const = 0;
  /// Loads a library and unloads it again. Fails with the text of dlerror(), verbatim.
  [[nodiscard]] virtual Result<void> try_library(const std::string& name) const = 0;
  /// Returns true if a process listens on this TCP port of `host` ("localhost", or a numeric
  /// address).
  [[nodiscard]] virtual bool listens(const std::string& host, std::uint16_t port) const = 0;
};

/// Returns the system of this machine.
const SystemView& this_system();

}  // namespace felt
