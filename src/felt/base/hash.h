#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace felt {

/// 64-bit FNV-1a: a fingerprint of bytes for determinism tests and caches; not for security.
/// Source: Fowler, Noll, Vo, "FNV hash", 64-bit offset basis and prime.
class Fnv1a {
 public:
  /// Adds bytes in order.
  constexpr void add(std::span<const std::byte> bytes) noexcept {
    for (std::byte b : bytes) {
      state_ ^= static_cast<std::uint64_t>(b);
      state_ *= 0x100000001b3ULL;
    }
  }

  /// Adds the object representation of a trivially copyable value without padding.
  template <class T>
  void add_value(const T& value) noexcept {
    add(std::as_bytes(std::span<const T, 1>(&value, 1)));
  }

  /// Returns the fingerprint of everything added so far.
  [[nodiscard]] constexpr std::uint64_t value() const noexcept { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace felt
