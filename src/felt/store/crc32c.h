#pragma once

#include <cstdint>
#include <string_view>

namespace felt {

/// Returns the CRC-32C (Castagnoli) of bytes; `crc` is the checksum of the bytes before them.
/// Source: RFC 3720 appendix B.4, which also has the test values.
std::uint32_t crc32c(std::string_view bytes, std::uint32_t crc = 0) noexcept;

}  // namespace felt
