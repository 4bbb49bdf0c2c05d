#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace felt {

/// Returns a path for a temporary file of a test, in the system's temporary folder. The path is
/// different in each process, because tests run in parallel. The caller removes the file.
inline std::string scratch_path(std::string_view name) {
  return (std::filesystem::temp_directory_path() /
          ("felt-" + std::to_string(::getpid()) + "-" + std::string(name)))
      .string();
}

}  // namespace felt
