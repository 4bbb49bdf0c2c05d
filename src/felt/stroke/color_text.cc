#include "felt/stroke/color_text.h"

#include <array>

namespace felt {
namespace {

/// Returns the value of a hexadecimal digit, or -1.
int digit_value(char c) noexcept {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::optional<Rgba> color_from_text(std::string_view text) noexcept {
  if (text.empty() || text.front() != '#') return std::nullopt;
  text.remove_prefix(1);
  const bool is_short = text.size() == 3;
  if (!is_short && text.size() != 6 && text.size() != 8) return std::nullopt;
  std::array<std::uint8_t, 4> channels = {0, 0, 0, 255};
  for (std::size_t i = 0; i * (is_short ? 1 : 2) < text.size(); ++i) {
    const int high = digit_value(text[is_short ? i : 2 * i]);
    const int low = is_short ? high : digit_value(text[2 * i + 1]);
    if (high < 0 || low < 0) return std::nullopt;
    channels[i] = static_cast<std::uint8_t>(16 * high + low);
  }
  return Rgba{channels[0], channels[1], channels[2], channels[3]};
}

std::string color_to_text(Rgba color) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "#";
  const std::array<std::uint8_t, 4> channels = {color.r, color.g, color.b, color.a};
  for (std::size_t i = 0; i < (color.a == 255 ? 3U : 4U); ++i) {
    text += kDigits[channels[i] >> 4];
    text += kDigits[channels[i] & 15];
  }
  return text;
}

}  // namespace felt
