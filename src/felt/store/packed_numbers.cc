#include "felt/store/packed_numbers.h"

#include <bit>

namespace felt {
namespace {

constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
/// Lengths up to 8 are of a difference; above, less 8, of leading bytes.
constexpr unsigned kMostDifferenceBytes = 8;

/// The doubles in their order as whole numbers, neighbours next to each other.
std::uint64_t rank_of(double value) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

double of_rank(std::uint64_t rank) noexcept {
  return std::bit_cast<double>((rank & kSign) != 0 ? rank ^ kSign : ~rank);
}

/// 0, -1, 1, -2, ... as 0, 1, 2, 3, ...
std::uint64_t folded(std::uint64_t difference) noexcept {
  return (difference << 1) ^ ((difference & kSign) != 0 ? ~std::uint64_t{0} : 0);
}

std::uint64_t unfolded(std::uint64_t n) noexcept {
  return (n >> 1) ^ ((n & 1) != 0 ? ~std::uint64_t{0} : 0);
}

}  // namespace

void NumberPacker::put(double value, double guess) {
  const std::uint64_t difference = folded(rank_of(value) - rank_of(guess));
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto size = static_cast<unsigned>(std::bit_width(difference) + 7) / 8;
  const auto leading = bits == 0 ? 1U : 8U - static_cast<unsigned>(std::countr_zero(bits)) / 8;
  const bool is_round = leading < size;
  const unsigned length = is_round ? kMostDifferenceBytes + leading : size;
  if (is_odd_) {
    lengths_.back() = static_cast<char>(static_cast<unsigned char>(lengths_.back()) | length << 4);
  } else {
    lengths_ += static_cast<char>(length);
  }
  is_odd_ = !is_odd_;
  const std::uint64_t n = is_round ? bits >> (64 - 8 * leading) : difference;
  for (unsigned i = 0; i < (is_round ? leading : size); ++i) {
    bytes_ += static_cast<char>((n >> (8 * i)) & 0xff);
  }
}

void NumberPacker::append_to(std::string& out) const {
  out += lengths_;
  out += bytes_;
}

NumberUnpacker::NumberUnpacker(ByteReader& in, std::size_t count)
    : lengths_(in.bytes((count + 1) / 2)), in_(in), count_(count) {}

double NumberUnpacker::take(double guess) {
  const std::size_t at = taken_++;
  if (at / 2 >= lengths_.size()) return 0.0;
  const auto pair = static_cast<unsigned char>(lengths_[at / 2]);
  const unsigned length = at % 2 == 0 ? pair & 0xfU : pair >> 4;
  if (length <= kMostDifferenceBytes) {
    return of_rank(rank_of(guess) + unfolded(in_.whole(length)));
  }
  const unsigned leading = length - kMostDifferenceBytes;
  return std::bit_cast<double>(in_.whole(leading) << (64 - 8 * leading));
}

bool NumberUnpacker::is_clean() const noexcept {
  return count_ % 2 == 0 || lengths_.empty() ||
         static_cast<unsigned char>(lengths_.back()) >> 4 == 0;
}

}  // namespace felt
