#include "felt/io/exact_numbers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "felt/base/check.h"

namespace felt {
namespace {

constexpr std::string_view kNumberDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr unsigned kBits = 6;
/// Number of digits, of six bits each, that is enough for 64 bits.
constexpr std::size_t kMaxDigits = 11;
constexpr std::uint64_t kSign = std::uint64_t{1} << 63;

/// Returns the rank of a double in the order of all doubles: neighbours differ by 1.
std::uint64_t rank_of(double value) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

double of_rank(std::uint64_t rank) noexcept {
  return std::bit_cast<double>((rank & kSign) != 0 ? rank ^ kSign : ~rank);
}

/// Returns the difference in rank between value and guess as an unsigned number: 0, -1, 1, -2, ...
/// become 0, 1, 2, 3, ...
std::uint64_t folded_difference(double value, double guess) noexcept {
  const std::uint64_t d = rank_of(value) - rank_of(guess);
  return (d << 1) ^ ((d & kSign) != 0 ? ~std::uint64_t{0} : 0);
}

double unfolded(std::uint64_t n, double guess) noexcept {
  return of_rank(rank_of(guess) + ((n >> 1) ^ ((n & 1) != 0 ? ~std::uint64_t{0} : 0)));
}

int digit_of(char c) noexcept {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

}  // namespace

void append_exact(std::string& out, std::span<const double> values,
                  std::span<const double> guesses) {
  FELT_CHECK(values.size() == guesses.size());
  std::uint64_t all = 0;
  for (std::size_t i = 0; i < values.size(); ++i) all |= folded_difference(values[i], guesses[i]);
  const unsigned digits =
      std::max(1U, (static_cast<unsigned>(std::bit_width(all)) + kBits - 1) / kBits);
  out += kNumberDigits[digits];
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint64_t n = folded_difference(values[i], guesses[i]);
    for (unsigned k = 0; k < digits; ++k, n >>= kBits) out += kNumberDigits[n & 63U];
  }
}

std::size_t exact_count(std::string_view text) noexcept {
  const int digits = text.empty() ? 0 : digit_of(text.front());
  return digits < 1 ? 0 : (text.size() - 1) / static_cast<std::size_t>(digits);
}

bool read_exact(std::string_view text, std::span<const double> guesses, double near,
                std::span<double> values) {
  FELT_CHECK(values.size() == guesses.size());
  const int digits = text.empty() ? 0 : digit_of(text.front());
  if (digits < 1 || digits > static_cast<int>(kMaxDigits)) return false;
  const auto each = static_cast<std::size_t>(digits);
  if (text.size() != 1 + each * values.size()) return false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint64_t n = 0;
    for (std::size_t k = 0; k < each; ++k) {
      const int digit = digit_of(text[1 + i * each + k]);
      if (digit < 0) return false;
      n |= static_cast<std::uint64_t>(digit) << (kBits * k);
    }
    const double value = unfolded(n, guesses[i]);
    values[i] = std::fabs(value - guesses[i]) <= near ? value : guesses[i];
  }
  return true;
}

}  // namespace felt
