#pragma once

namespace felt {

/// Returns an ASCII letter in lower case; returns any other character unchanged.
constexpr char ascii_lower(char c) noexcept {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace felt
