#pragma once

#include <cstddef>
#include <string_view>

namespace felt {

/// Reads numbers, words and signs one after the other from the start of the text of an SVG
/// attribute. Never throws and never reads beyond the end of the text. If a function cannot read
/// what it should, the text stays unread.
class SvgScan {
 public:
  /// Numbers with a magnitude beyond `max_number` are not read.
  explicit SvgScan(std::string_view text, double max_number = 1e9) noexcept
      : text_(text), size_(text.size()), max_(max_number) {}

  void skip_spaces() noexcept;
  /// Skips spaces and at most one comma.
  void skip_comma() noexcept;
  /// Reads a number of SVG: sign, digits, point, exponent. If the text is "1e", reads 1 and leaves
  /// "e" unread. Accepts at most 64 characters.
  bool number(double& value) noexcept;
  /// Reads 0 or 1. No separator needs to follow.
  bool flag(bool& value) noexcept;
  bool take(char c) noexcept;
  /// Reads this word, ignoring the case of ASCII letters. Returns false if the text does not begin
  /// with this word.
  bool take(std::string_view word) noexcept;
  /// Reads letters, digits, '-', '_' and non-ASCII characters; returns "" if the text begins with
  /// another character.
  std::string_view name() noexcept;
  /// Reads ASCII letters; returns "" if the text begins with another character.
  std::string_view letters() noexcept;
  /// Reads the text up to the next c, and returns it without c. Reads and returns all text if it
  /// does not contain c.
  std::string_view until(char c) noexcept;
  /// Returns true if a number may begin here.
  [[nodiscard]] bool at_number() const noexcept;
  /// Returns the next character, or 0 at the end.
  [[nodiscard]] char peek() const noexcept { return text_.empty() ? '\0' : text_.front(); }
  [[nodiscard]] bool empty() const noexcept { return text_.empty(); }
  /// Returns true if only spaces are left.
  bool at_end() noexcept;
  [[nodiscard]] std::string_view rest() const noexcept { return text_; }
  /// Returns the number of characters read so far.
  [[nodiscard]] std::size_t taken() const noexcept { return size_ - text_.size(); }

 private:
  std::string_view text_;
  std::size_t size_;
  double max_;
};

/// Returns `text` without spaces at both ends.
std::string_view svg_trimmed(std::string_view text) noexcept;

/// Returns true if two words are equal, ignoring the case of ASCII letters.
bool svg_same_word(std::string_view a, std::string_view b) noexcept;

constexpr bool is_svg_space(char c) noexcept {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

}  // namespace felt
