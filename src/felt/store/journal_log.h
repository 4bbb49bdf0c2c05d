#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace felt {

/// A log that is only ever appended to: records of a type and bytes, each with its length before
/// and a CRC-32C behind. Whatever a crash leaves at its end is seen and left out.
struct LogRecord {
  std::uint8_t type = 0;
  std::string_view bytes;  ///< in the text that was read
};

/// Requires less than 2 GiB of bytes.
void append_log_record(std::string& out, std::uint8_t type, std::string_view bytes);

/// All whole records from the start; what follows the first that is torn or damaged is not
/// believed.
std::vector<LogRecord> read_log(std::string_view text);

}  // namespace felt
