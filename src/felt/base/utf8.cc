#include "felt/base/utf8.h"

#include <array>

namespace felt {

bool next_code_point(std::string_view& text, std::uint32_t& code) noexcept {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80           ? 1
                             : (first >> 5) == 0x06 ? 2
                             : (first >> 4) == 0x0e ? 3
                             : (first >> 3) == 0x1e ? 4
                                                    : 0;
  if (length == 0 || text.size() < length) return false;
  constexpr std::array<unsigned, 5> kMask{0, 0x7f, 0x1f, 0x0f, 0x07};
  constexpr std::array<std::uint32_t, 5> kMin{0, 0, 0x80, 0x800, 0x10000};
  code = first & kMask[length];
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) >> 6) != 0x02) return false;
    code = (code << 6) | (byte(i) & 0x3f);
  }
  text.remove_prefix(length);
  return code >= kMin[length] && code <= 0x10ffff && !(code >= 0xd800 && code <= 0xdfff);
}

bool is_utf8(std::string_view text) noexcept {
  std::uint32_t code = 0;
  while (!text.empty()) {
    if (!next_code_point(text, code)) return false;
  }
  return true;
}

std::string_view utf8_prefix(std::string_view text, std::size_t max_bytes) noexcept {
  if (text.size() <= max_bytes) return text;
  std::size_t end = max_bytes;
  // The bytes of a code point after its first are 10xxxxxx.
  while (end > 0 && (static_cast<unsigned char>(text[end]) >> 6) == 0x02) --end;
  return text.substr(0, end);
}

}  // namespace felt
