#pragma once

#include <cstdint>
#include <string_view>

namespace felt {

/// Takes the next code point off the front of UTF-8 text. False when it is malformed, overlong, a
/// surrogate or beyond U+10FFFF; `text` and `code` mean nothing then. Requires text that is not
/// empty. Source: RFC 3629.
bool next_code_point(std::string_view& text, std::uint32_t& code) noexcept;

/// True for well-formed UTF-8, also for no text at all.
bool is_utf8(std::string_view text) noexcept;

}  // namespace felt
