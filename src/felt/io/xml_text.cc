#include "felt/io/xml_text.h"

#include <array>
#include <charconv>
#include <cstdint>

namespace felt {
namespace {

/// Reads the next code point of UTF-8 text; false when it is malformed, overlong or a surrogate.
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
  constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  code = first & kMask[length];
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) >> 6) != 0x02) return false;
    code = (code << 6) | (byte(i) & 0x3f);
  }
  text.remove_prefix(length);
  return code >= kLeast[length] && code <= 0x10ffff && !(code >= 0xd800 && code <= 0xdfff);
}

/// The production Char of XML 1.0.
bool allowed_in_xml(std::uint32_t code) noexcept {
  return code == 0x9 || code == 0xa || code == 0xd ||
         (code >= 0x20 && code != 0xfffe && code != 0xffff);
}

std::string hex(std::uint32_t code) {
  std::array<char, 8> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), code, 16).ptr;
  return "U+" + std::string(digits.data(), end);
}

}  // namespace

Result<void> append_xml_attribute(std::string& out, std::string_view text) {
  std::string escaped;
  while (!text.empty()) {
    const std::string_view rest = text;
    std::uint32_t code = 0;
    if (!next_code_point(text, code)) {
      return fail(ErrorCode::kInvalidData, "text that is not UTF-8 cannot be written as XML");
    }
    if (!allowed_in_xml(code)) {
      return fail(ErrorCode::kInvalidData, "XML cannot hold the character " + hex(code));
    }
    switch (code) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      // As themselves, parsers turn these into spaces.
      case '\t':
        escaped += "&#9;";
        break;
      case '\n':
        escaped += "&#10;";
        break;
      case '\r':
        escaped += "&#13;";
        break;
      default:
        escaped.append(rest.substr(0, rest.size() - text.size()));
    }
  }
  out += escaped;
  return {};
}

}  // namespace felt
