#include "felt/base/printable.h"

#include <array>
#include <cstdint>
#include <cstdio>

#include "felt/base/utf8.h"

namespace felt {
namespace {

bool is_harmless(std::uint32_t code) noexcept {
  const bool is_control = code < 0x20 || (code >= 0x7f && code < 0xa0);
  const bool breaks_line = code == 0x2028 || code == 0x2029;
  const bool turns_direction =
      (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return !is_control && !breaks_line && !turns_direction;
}

std::string escape(std::uint32_t code) {
  if (code == '\n') return "\\n";
  if (code == '\r') return "\\r";
  if (code == '\t') return "\\t";
  std::array<char, 16> text{};
  static_cast<void>(std::snprintf(text.data(), text.size(), code < 0x80 ? "\\x%02x" : "\\u%04x",
                                  static_cast<unsigned>(code)));
  return text.data();
}

}  // namespace

std::string printable(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    std::string_view rest = text;
    std::uint32_t code = 0;
    if (!next_code_point(rest, code)) {
      std::array<char, 8> byte{};
      static_cast<void>(std::snprintf(byte.data(), byte.size(), "\\x%02x",
                                      static_cast<unsigned>(static_cast<unsigned char>(text[0]))));
      line += byte.data();
      text.remove_prefix(1);
      continue;
    }
    if (is_harmless(code)) {
      line += text.substr(0, text.size() - rest.size());
    } else {
      line += escape(code);
    }
    text = rest;
  }
  return line;
}

}  // namespace felt
