#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace felt {

/// Appends values as bytes: little-endian on every machine, doubles as their IEEE 754 bits.
class ByteWriter {
 public:
  explicit ByteWriter(std::string& out) noexcept : out_(out) {}

  void u8(std::uint8_t v) { out_ += static_cast<char>(v); }
  void u32(std::uint32_t v) { little_endian(v, 4); }
  void u64(std::uint64_t v) { little_endian(v, 8); }
  void f64(double v);
  /// Appends the length (u32), then the bytes. Requires less than 4 GiB.
  void text(std::string_view v);
  /// Appends a whole number in as few bytes as it needs. Each byte holds 7 bits of the number, the
  /// lowest first. The top bit is set in every byte but the last.
  void count(std::uint64_t v);

 private:
  void little_endian(std::uint64_t v, int bytes);

  std::string& out_;
};

/// Reads what ByteWriter wrote. Never reads beyond the end. After the first error every value is 0
/// or empty and ok() is false, so that the caller needs to check ok() only once, at the end.
/// Lengths are checked against the number of bytes left.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) noexcept : bytes_(bytes) {}

  std::uint8_t u8() { return static_cast<std::uint8_t>(little_endian(1)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(little_endian(4)); }
  std::uint64_t u64() { return little_endian(8); }
  double f64();
  /// Returns a view into the bytes being read. Fails if the text is longer than `max_bytes`.
  std::string_view text(std::size_t max_bytes);
  /// Reads what ByteWriter::count wrote. Fails if the number has more bytes than it needs, or more
  /// than 64 bits.
  std::uint64_t count();
  /// Returns the next `size` bytes.
  std::string_view bytes(std::size_t size);
  /// Reads a whole number of `size` bytes, at most 8.
  std::uint64_t whole(std::size_t size) { return little_endian(size); }

  [[nodiscard]] bool ok() const noexcept { return ok_; }
  [[nodiscard]] std::size_t left() const noexcept { return bytes_.size(); }
  /// Returns true if no error occurred and at least `count` x `each` bytes are left.
  [[nodiscard]] bool has(std::uint64_t count, std::size_t each) const noexcept {
    return ok_ && count <= bytes_.size() / each;
  }

 private:
  std::uint64_t little_endian(std::size_t bytes);

  std::string_view bytes_;
  bool ok_ = true;
};

}  // namespace felt
