#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace felt {

/// Reads the first code point of UTF-8 text and removes it from the front of `text`. Returns false
/// if the code point is malformed, overlong, a surrogate or beyond U+10FFFF; in that case, `text`
/// and `code` are unspecified. Requires that `text` is not empty. Source: RFC 3629.
bool next_code_point(std::string_view& text, std::uint32_t& code) noexcept;

/// Returns true if the text is well-formed UTF-8. Empty text is well-formed.
bool is_utf8(std::string_view text) noexcept;

/// Returns the beginning of `text`, of at most `max_bytes` bytes, without half a code point at its
/// end.
std::string_view utf8_prefix(std::string_view text, std::size_t max_bytes) noexcept;

}  // namespace felt
