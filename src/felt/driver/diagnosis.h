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
  kAbsent,   ///< neither a device nor software of this maker was found, which is not a problem
  kWarning,  ///< works, but not as well as it could
  kProblem,  ///< does not work; `steps` tell the user how to repair it
};

/// A file that only root may write, and its content. `doctor --fix` writes it.
struct SystemFix {
  std::string path;     ///< "/etc/udev/rules.d/70-feltline-novint.rules"
  std::string content;  ///< the content that follows the first line, kOurFileMark
  /// The shell command that activates the file; it is run as root. It is empty if the file takes
  /// effect only after an action of the user, such as a new login.
  std::string activate;
};

/// One result of a diagnosis, for the user.
struct Finding {
  FindingLevel level = FindingLevel::kOk;
  std::string what;          ///< "The OpenHaptics library was not found."
  std::string details = {};  ///< unchanged text of dlerror() or errno, or a version; may be empty
  /// The actions that the user should take, in this order. Each is a sentence. If an action needs a
  /// command, the command follows on a line of its own so that the user can copy it: "Install the
  /// library that it needs:\nsudo apt install libncurses5".
  std::vector<std::string> steps = {};
  /// The file that `doctor --fix` writes. If it is set, a step must mention it: "Let Feltline do
  /// it:\nfeltline doctor --fix".
  std::optional<SystemFix> fix = {};
};

/// The first line of every file that `doctor --fix` writes. Feltline overwrites an existing file
/// only if the file starts with this line.
inline constexpr std::string_view kOurFileMark =
    "# Written by 'feltline doctor --fix', which may write it anew.\n";
/// The command that applies udev rules to devices that are already plugged in. It is the
/// SystemFix::activate of rule files.
inline constexpr std::string_view kReloadUdev =
    "udevadm control --reload-rules && udevadm trigger --subsystem-match=usb"
    " --subsystem-match=hidraw --subsystem-match=tty --subsystem-match=input";

/// The interface through which a diagnosis reads the system: files, the user, environment
/// variables, libraries that can be loaded and TCP ports that are open. Tests replace it by a fake
/// system. No function changes the system. Used on the edit thread.
class SystemView {
 public:
  virtual ~SystemView() = default;

  /// Returns the names in a folder, sorted; empty if it does not exist. Paths are absolute
  /// ("/sys/class/hidraw").
  [[nodiscard]] virtual std::vector<std::string> list(std::string_view folder) const = 0;
  /// Returns the first 64 KiB of a file, or nullopt if it cannot be read.
  [[nodiscard]] virtual std::optional<std::string> read(std::string_view path) const = 0;
  [[nodiscard]] virtual bool exists(std::string_view path) const = 0;
  /// Succeeds if this user may read and write the file. Fails with kNotFound, or with kIo and the
  /// text of errno.
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
