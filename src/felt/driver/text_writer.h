#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace felt {

/// Longest text that append_decimal() writes: a sign, seven digits, the point and six decimals.
inline constexpr std::size_t kMaxDecimal = 15;

/// Appends `text` at `at`, where there must be room for it. Returns the end. Real-time safe.
inline char* append_text(char* at, std::string_view text) noexcept {
  return std::copy(text.begin(), text.end(), at);
}

/// Appends a number with six decimals, so that a force is exact to a micronewton. Larger numbers
/// than 10^6 are shortened to it, and NaN becomes 0. Requires room for kMaxDecimal characters.
/// Returns the end. Real-time safe.
inline char* append_decimal(char* at, double number) noexcept {
  constexpr int kDecimals = 6;
  constexpr double kMax = 1e6;
  const double bounded = std::isfinite(number) ? std::clamp(number, -kMax, kMax) : 0.0;
  return std::to_chars(at, at + kMaxDecimal, bounded, std::chars_format::fixed, kDecimals).ptr;
}

}  // namespace felt
