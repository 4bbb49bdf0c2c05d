#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "felt/store/byte_stream.h"

namespace felt {

/// Doubles in few bytes, to the last bit (docs/formats/felt.md, "Packed numbers"): each as how far
/// it is from a guess that the reader makes too, or as its leading bytes where it is a round
/// number. Good guesses cost half a byte, none cost half a byte more than the double itself.
class NumberPacker {
 public:
  void put(double value, double guess);
  void append_to(std::string& out) const;

 private:
  std::string lengths_, bytes_;
  bool is_odd_ = false;
};

/// Takes them off again. The guesses must be those of the packer.
class NumberUnpacker {
 public:
  /// Requires of the bytes nothing: of too few of them, in.ok() is false in the end.
  NumberUnpacker(ByteReader& in, std::size_t count);

  double take(double guess);
  /// That what is no number in the lengths is zero, as the packer leaves it.
  [[nodiscard]] bool is_clean() const noexcept;

 private:
  std::string_view lengths_;
  ByteReader& in_;
  std::size_t count_;
  std::size_t taken_ = 0;
};

}  // namespace felt
