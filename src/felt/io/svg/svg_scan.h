#pragma once

#include <cstddef>
#include <string_view>

namespace felt {

/// Takes numbers, words and signs off the front of an attribute of SVG. Never throws, never reads
/// beyond the text; what was not taken stays.
class SvgScan {
 public:
  /// Numbers beyond `most` are not taken.
  explicit SvgScan(std::string_view text, double most = 1e9) noexcept
      : text_(text), size_(text.size()), most_(most) {}

  void skip_spaces() noexcept;
  /// Spaces, and one comma among them.
  void skip_comma() noexcept;
  /// A number of SVG: sign, digits, point, exponent; "1e" is 1 and an "e". At most 64 characters.
  bool number(double& value) noexcept;
  /// 0 or 1, the next character of whatever follows it.
  bool flag(bool& value) noexcept;
  bool take(char c) noexcept;
  /// In any case of letters.
  bool take(std::string_view word) noexcept;
  /// Letters, digits, '-', '_' and everything that is not ASCII; empty where there are none.
  std::string_view name() noexcept;
  /// ASCII letters; empty where there are none.
  std::string_view letters() noexcept;
  /// Everything before c, without it and with it gone; everything where there is none.
  std::string_view until(char c) noexcept;
  /// Whether a number may begin here.
  [[nodiscard]] bool at_number() const noexcept;
  /// The next character, or 0 at the end.
  [[nodiscard]] char peek() const noexcept { return text_.empty() ? '\0' : text_.front(); }
  [[nodiscard]] bool empty() const noexcept { return text_.empty(); }
  /// Whether only spaces are left.
  bool at_end() noexcept;
  [[nodiscard]] std::string_view rest() const noexcept { return text_; }
  /// Characters taken so far.
  [[nodiscard]] std::size_t taken() const noexcept { return size_ - text_.size(); }

 private:
  std::string_view text_;
  std::size_t size_;
  double most_;
};

/// Without spaces at both ends.
std::string_view svg_trimmed(std::string_view text) noexcept;

/// Whether two words are the same but for the case of their ASCII letters.
bool svg_same_word(std::string_view a, std::string_view b) noexcept;

constexpr bool is_svg_space(char c) noexcept {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

}  // namespace felt
