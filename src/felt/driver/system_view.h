#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"

namespace felt {

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
