#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "felt/base/result.h"

namespace felt {

/// Checks a file before most of it is read. Gets its first bytes, and its size or 0 if that is
/// unknown. Returns the maximum size of such a file, or the reason why it is refused, without a
/// name.
using HeadCheck = std::function<Result<std::size_t>(std::string_view head, std::uint64_t size)>;
/// Number of bytes that a HeadCheck gets, or fewer if the file is shorter.
inline constexpr std::size_t kCheckedHeadBytes = 4096;

/// Returns all bytes of a file, or of stdin for "-". Reads to the end even if the system reports
/// another size, so that pipes and devices work. Fails if the file cannot be read, is a folder, or
/// has more than `max_bytes`; the error names the file and the reason.
Result<std::string> read_file(const std::string& path, std::size_t max_bytes);
/// Does the same, but refuses a file that `check` refuses without reading the rest of it.
Result<std::string> read_file(const std::string& path, const HeadCheck& check);

/// Returns all bytes of a regular file. Use this function for names from an untrusted source. It
/// also fails for pipes and devices, because reading from them may block or never end, and it
/// treats "-" as an ordinary name, not as stdin.
Result<std::string> read_regular_file(const std::string& path, std::size_t max_bytes);
Result<std::string> read_regular_file(const std::string& path, const HeadCheck& check);

}  // namespace felt
