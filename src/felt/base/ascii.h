#pragma once

namespace felt {

/// Returns the lower case of an ASCII letter, and every other character as it is.
constexpr char ascii_lower(char c) noexcept {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace felt
