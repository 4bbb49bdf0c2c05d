#pragma once

#include <cstddef>
#include <string>

#include "felt/base/result.h"

namespace felt {

/// Returns all bytes of a file, or of stdin for "-". Reads to the end even if the system reports
/// another size, so that pipes and devices work. Fails if the file cannot be read, is a folder, or
/// has more than `max_bytes`; the error names the file and the reason.
Result<std::string> read_file(const std::string& path, std::size_t max_bytes);

/// Returns all bytes of a regular file. Use this function for names from an untrusted source. It
/// also fails for pipes and devices, because reading from them may block or never end, and it
/// treats "-" as an ordinary name, not as stdin.
Result<std::string> read_regular_file(const std::string& path, std::size_t max_bytes);

}  // namespace felt
