#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace felt {

/// Encodes bytes as base64 (RFC 4648, section 4) with padding and without line breaks.
std::string base64_text(std::string_view bytes);

/// Decodes base64, and ignores white space. Returns nullopt if the text has other characters, or if
/// its length or its padding is wrong.
std::optional<std::string> base64_bytes(std::string_view text);

}  // namespace felt
