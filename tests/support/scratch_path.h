#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace felt {

/// Where a test may write: in the system's folder for such things, under a name that no other
/// process has, since tests run side by side. Whoever writes there removes it.
inline std::string scratch_path(std::string_view name) {
  return (std::filesystem::temp_directory_path() /
          ("felt-" + std::to_string(::getpid()) + "-" + std::string(name)))
      .string();
}

}  // namespace felt
