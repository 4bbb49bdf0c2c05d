#include "numbers_text.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

/// Writes the digits of the shortest decimal that reads back as `number`, and returns their count;
/// `exponent` is that of the first digit. Implemented in JavaScript, which has the algorithm.
extern "C" __attribute__((import_module("env"), import_name("shortest_digits"))) int
shortest_digits(double number, char* digits, int* exponent);

namespace felt::page {
namespace {

/// Writes digits as a fixed-point number, and returns the end.
char* fixed(char* to, std::string_view digits, int exponent) {
  const int count = static_cast<int>(digits.size());
  if (exponent < 0) {
    *to++ = '0';
    *to++ = '.';
    for (int i = -1; i > exponent; --i) *to++ = '0';
  }
  for (int i = 0; i < count; ++i) {
    if (i > 0 && i == exponent + 1) *to++ = '.';
    *to++ = digits[static_cast<std::size_t>(i)];
  }
  for (int i = count; i <= exponent; ++i) *to++ = '0';
  return to;
}

char* scientific(char* to, std::string_view digits, int exponent) {
  *to++ = digits[0];
  if (digits.size() > 1) *to++ = '.';
  for (const char digit : digits.substr(1)) *to++ = digit;
  *to++ = 'e';
  *to++ = exponent < 0 ? '-' : '+';
  exponent = std::abs(exponent);
  if (exponent >= 100) *to++ = static_cast<char>('0' + exponent / 100);
  *to++ = static_cast<char>('0' + exponent / 10 % 10);
  *to++ = static_cast<char>('0' + exponent % 10);
  return to;
}

char* copied(char* first, char* last, std::string_view text) {
  if (last - first < static_cast<std::ptrdiff_t>(text.size())) return nullptr;
  std::memcpy(first, text.data(), text.size());
  return first + text.size();
}

enum class Form { kShorter, kFixed };

char* shortest(char* first, char* last, double number, Form form) noexcept {
  if (std::isnan(number)) return copied(first, last, std::signbit(number) ? "-nan" : "nan");
  if (std::isinf(number)) return copied(first, last, number < 0 ? "-inf" : "inf");
  std::array<char, 400> text;
  char* at = text.data();
  if (std::signbit(number)) *at++ = '-';
  number = std::fabs(number);
  if (number == 0.0) {
    *at++ = '0';
    return copied(first, last, {text.data(), static_cast<std::size_t>(at - text.data())});
  }
  std::array<char, 24> digits;
  int exponent = 0;
  const int count = shortest_digits(number, digits.data(), &exponent);
  const std::string_view shown(digits.data(), static_cast<std::size_t>(count));
  // The shorter of the two forms; the fixed one if they are equally long.
  const int fixed_size = exponent < 0            ? 1 - exponent + count
                         : exponent >= count - 1 ? exponent + 1
                                                 : count + 1;
  const int scientific_size = count + (count > 1) + (std::abs(exponent) >= 100 ? 5 : 4);
  at = form == Form::kFixed || fixed_size <= scientific_size ? fixed(at, shown, exponent)
                                                             : scientific(at, shown, exponent);
  return copied(first, last, {text.data(), static_cast<std::size_t>(at - text.data())});
}

}  // namespace

char* shortest_text(char* first, char* last, double number) noexcept {
  return shortest(first, last, number, Form::kShorter);
}

char* shortest_fixed_text(char* first, char* last, double number) noexcept {
  return shortest(first, last, number, Form::kFixed);
}

char* rounded_text(char* first, char* last, double number, int precision, char format) noexcept {
  std::array<char, 400> text;
  const std::array<char, 5> pattern{'%', '.', '*', format, 0};
  const int size = std::snprintf(text.data(), text.size(), pattern.data(), precision, number);
  if (size < 0 || static_cast<std::size_t>(size) >= text.size()) return nullptr;
  return copied(first, last, {text.data(), static_cast<std::size_t>(size)});
}

const char* read_number(const char* first, const char* last, double& number,
                        std::errc& error) noexcept {
  // strtod reads further forms ("0x1p3", " 1", "+1"), and needs an end.
  const char* end = first;
  bool has_digit = false;
  if (end != last && *end == '-') ++end;
  const auto digits = [&] {
    for (; end != last && *end >= '0' && *end <= '9'; ++end) has_digit = true;
  };
  digits();
  if (end != last && *end == '.') {
    ++end;
    digits();
  }
  if (!has_digit) {
    error = std::errc::invalid_argument;
    return first;
  }
  if (end != last && (*end == 'e' || *end == 'E')) {
    const char* power = end + 1;
    if (power != last && (*power == '-' || *power == '+')) ++power;
    const char* const begin = power;
    while (power != last && *power >= '0' && *power <= '9') ++power;
    if (power != begin) end = power;
  }
  constexpr std::size_t kMany = 1100;  // more digits than decide a number
  std::array<char, kMany> text;
  const std::size_t size = static_cast<std::size_t>(end - first);
  if (size >= kMany) {
    error = std::errc::result_out_of_range;
    return end;
  }
  std::memcpy(text.data(), first, size);
  text[size] = 0;
  const double read = std::strtod(text.data(), nullptr);
  if (std::isinf(read)) {
    error = std::errc::result_out_of_range;
    return end;
  }
  number = read;
  return end;
}

}  // namespace felt::page
