#include "felt/base/utf8.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace felt::utf8_test {
namespace {

/// A textbook encoder, to check the decoder.
std::string encoded(std::uint32_t c) {
  const auto byte = [](std::uint32_t b) { return static_cast<char>(b); };
  if (c < 0x80) return {byte(c)};
  if (c < 0x800) return {byte(0xc0 | (c >> 6)), byte(0x80 | (c & 0x3f))};
  if (c < 0x10000) {
    return {byte(0xe0 | (c >> 12)), byte(0x80 | ((c >> 6) & 0x3f)), byte(0x80 | (c & 0x3f))};
  }
  return {byte(0xf0 | (c >> 18)), byte(0x80 | ((c >> 12) & 0x3f)), byte(0x80 | ((c >> 6) & 0x3f)),
          byte(0x80 | (c & 0x3f))};
}

TEST(Utf8, EveryCodePointReadsBack) {
  for (std::uint32_t c = 0; c <= 0x10ffff; ++c) {
    const std::string text = encoded(c);
    std::string_view rest = text;
    std::uint32_t code = 0;
    const bool is_surrogate = c >= 0xd800 && c <= 0xdfff;
    ASSERT_EQ(next_code_point(rest, code), !is_surrogate) << c;
    if (is_surrogate) continue;
    ASSERT_EQ(code, c);
    ASSERT_TRUE(rest.empty());
    ASSERT_TRUE(text.size() == 1 || !is_utf8(text.substr(0, text.size() - 1))) << c;
  }
}

TEST(Utf8, NoOtherFormIsTaken) {
  EXPECT_TRUE(is_utf8(""));
  EXPECT_TRUE(is_utf8("Entwürfe ✎"));
  EXPECT_FALSE(is_utf8("\x80"));
  EXPECT_FALSE(is_utf8("\xc0\xaf"));          // overlong
  EXPECT_FALSE(is_utf8("\xf4\x90\x80\x80"));  // beyond U+10FFFF
  EXPECT_FALSE(is_utf8("\xff"));
}

TEST(Utf8, APrefixEndsBetweenTwoCodePoints) {
  const std::string text = "a\u00fc\u270e\U0001f58b";  // 1, 2, 3 and 4 bytes
  const std::array<std::size_t, 11> sizes{0, 1, 1, 3, 3, 3, 6, 6, 6, 6, 10};
  for (std::size_t max = 0; max < sizes.size(); ++max) {
    EXPECT_EQ(utf8_prefix(text, max), text.substr(0, sizes[max])) << max;
  }
  EXPECT_EQ(utf8_prefix(text, 99), text);
  EXPECT_EQ(utf8_prefix("\x80\x80\x80", 2), "") << "malformed";
}

}  // namespace
}  // namespace felt::utf8_test
