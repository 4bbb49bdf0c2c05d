#pragma once

#include <array>
#include <charconv>
#include <string>
#include <system_error>

namespace felt {

/// Returns the shortest text from which the same number is read: "0.25", "500", "nan". Independent
/// of the locale.
inline std::string number_text(double number) {
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  return error == std::errc() ? std::string(buffer.data(), end) : "nan";
}

}  // namespace felt
