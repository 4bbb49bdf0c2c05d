#include "felt/io/svg/svg_scan.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "felt/io/limits.h"

namespace felt {
namespace {

constexpr bool is_digit(char c) noexcept {
  return c >= '0' && c <= '9';
}

constexpr char lower(char c) noexcept {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Returns the number of characters of the number at the front; 0 if the text does not begin with a
/// number.
std::size_t number_size(std::string_view text) noexcept {
  std::size_t at = 0, digits = 0;
  const auto skip_digits = [&] {
    for (; at < text.size() && is_digit(text[at]); ++at) ++digits;
  };
  if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
  skip_digits();
  if (at < text.size() && text[at] == '.') {
    ++at;
    skip_digits();
  }
  if (digits == 0) return 0;
  std::size_t end = at;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    if (at < text.size() && is_digit(text[at])) {
      skip_digits();
      end = at;
    }
  }
  return end;
}

}  // namespace

void SvgScan::skip_spaces() noexcept {
  std::size_t at = 0;
  while (at < text_.size() && is_svg_space(text_[at])) ++at;
  text_.remove_prefix(at);
}

void SvgScan::skip_comma() noexcept {
  skip_spaces();
  if (take(',')) skip_spaces();
}

bool SvgScan::number(double& value) noexcept {
  const std::size_t size = number_size(text_);
  if (size == 0 || size > limits::kMaxNumberChars) return false;
  std::string_view digits = text_.substr(0, size);
  if (digits.front() == '+') digits.remove_prefix(1);
  double read = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), read);
  if (error == std::errc::result_out_of_range) {
    // The number is either so small that it is read as 0, or too large.
    const std::size_t e = digits.find_first_of("eE");
    if (e == std::string_view::npos || digits[e + 1] != '-') return false;
    read = 0.0;
  } else if (error != std::errc() || end != digits.data() + digits.size()) {
    return false;
  }
  if (!(std::fabs(read) <= max_)) return false;
  value = read;
  text_.remove_prefix(size);
  return true;
}

bool SvgScan::flag(bool& value) noexcept {
  if (peek() != '0' && peek() != '1') return false;
  value = peek() == '1';
  text_.remove_prefix(1);
  return true;
}

bool SvgScan::take(char c) noexcept {
  if (text_.empty() || text_.front() != c) return false;
  text_.remove_prefix(1);
  return true;
}

bool SvgScan::take(std::string_view word) noexcept {
  if (!svg_same_word(text_.substr(0, word.size()), word)) return false;
  text_.remove_prefix(word.size());
  return true;
}

std::string_view SvgScan::name() noexcept {
  std::size_t at = 0;
  while (at < text_.size() &&
         (is_digit(text_[at]) || (lower(text_[at]) >= 'a' && lower(text_[at]) <= 'z') ||
          text_[at] == '-' || text_[at] == '_' || (text_[at] & '\x80') != 0)) {
    ++at;
  }
  const std::string_view name = text_.substr(0, at);
  text_.remove_prefix(at);
  return name;
}

std::string_view SvgScan::letters() noexcept {
  std::size_t at = 0;
  while (at < text_.size() && lower(text_[at]) >= 'a' && lower(text_[at]) <= 'z') ++at;
  const std::string_view word = text_.substr(0, at);
  text_.remove_prefix(at);
  return word;
}

std::string_view SvgScan::until(char c) noexcept {
  const std::size_t at = std::min(text_.find(c), text_.size());
  const std::string_view part = text_.substr(0, at);
  text_.remove_prefix(std::min(at + 1, text_.size()));
  return part;
}

bool SvgScan::at_number() const noexcept {
  return is_digit(peek()) || peek() == '+' || peek() == '-' || peek() == '.';
}

bool SvgScan::at_end() noexcept {
  skip_spaces();
  return text_.empty();
}

std::string_view svg_trimmed(std::string_view text) noexcept {
  while (!text.empty() && is_svg_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_svg_space(text.back())) text.remove_suffix(1);
  return text;
}

bool svg_same_word(std::string_view a, std::string_view b) noexcept {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace felt
