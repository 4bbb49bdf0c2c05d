#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace felt {

/// Appends values as bytes: little-endian whatever the machine, doubles by their IEEE 754 bits.
class ByteWriter {
 public:
  explicit ByteWriter(std::string& out) noexcept : out_(out) {}

  void u8(std::uint8_t v) { out_ += static_cast<char>(v); }
  void u32(std::uint32_t v) { little_endian(v, 4); }
  void u64(std::uint64_t v) { little_endian(v, 8); }
  void f64(double v);
  /// Length (u32), then the bytes. Requires less than 4 GiB.
  void text(std::string_view v);
  /// A whole number in as few bytes as it needs: 7 bits each, the lowest first, the top bit set in
  /// all but the last.
  void count(std::uint64_t v);

 private:
  void little_endian(std::uint64_t v, int bytes);

  std::string& out_;
};

/// Takes them off again. Never reads beyond the end: once something is missing, every value is 0
/// or empty and ok() is false, so that the caller may ask once, at the end. A length is believed
/// only as far as there are bytes.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) noexcept : bytes_(bytes) {}

  std::uint8_t u8() { return static_cast<std::uint8_t>(little_endian(1)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(little_endian(4)); }
  std::uint64_t u64() { return little_endian(8); }
  double f64();
  /// Into the bytes that are read from. Not ok where it is longer than `max_bytes`.
  std::string_view text(std::size_t max_bytes);
  /// As ByteWriter::count writes it. Not ok where it has more bytes than it needs or 64 bits.
  std::uint64_t count();
  /// So many bytes as they are.
  std::string_view bytes(std::size_t size);
  /// A whole number of up to 8 bytes.
  std::uint64_t whole(std::size_t size) { return little_endian(size); }

  [[nodiscard]] bool ok() const noexcept { return ok_; }
  [[nodiscard]] std::size_t left() const noexcept { return bytes_.size(); }
  /// Whether `count` things of `each` bytes can still come.
  [[nodiscard]] bool has(std::uint64_t count, std::size_t each) const noexcept {
    return ok_ && count <= bytes_.size() / each;
  }

 private:
  std::uint64_t little_endian(std::size_t bytes);

  std::string_view bytes_;
  bool ok_ = true;
};

}  // namespace felt
