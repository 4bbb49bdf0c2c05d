#include "felt/store/byte_writer.h"

#include <bit>
#include <cstddef>

namespace felt {

void ByteWriter::little_endian(std::uint64_t v, int bytes) {
  for (int i = 0; i < bytes; ++i) out_ += static_cast<char>((v >> (8 * i)) & 0xff);
}

void ByteWriter::f64(double v) {
  u64(std::bit_cast<std::uint64_t>(v));
}

void ByteWriter::text(std::string_view v) {
  u32(static_cast<std::uint32_t>(v.size()));
  out_ += v;
}

void ByteWriter::count(std::uint64_t v) {
  for (; v >= 0x80; v >>= 7) out_ += static_cast<char>(v | 0x80);
  out_ += static_cast<char>(v);
}

std::uint64_t ByteReader::little_endian(std::size_t bytes) {
  if (bytes_.size() < bytes) ok_ = false;
  if (!ok_) return 0;
  std::uint64_t v = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    v |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[i])) << (8 * i);
  }
  bytes_.remove_prefix(bytes);
  return v;
}

double ByteReader::f64() {
  return std::bit_cast<double>(u64());
}

std::string_view ByteReader::text(std::size_t max_bytes) {
  const std::uint32_t size = u32();
  if (size > max_bytes) ok_ = false;
  return bytes(size);
}

std::string_view ByteReader::bytes(std::size_t size) {
  if (size > bytes_.size()) ok_ = false;
  if (!ok_) return {};
  const std::string_view taken = bytes_.substr(0, size);
  bytes_.remove_prefix(size);
  return taken;
}

std::uint64_t ByteReader::count() {
  std::uint64_t v = 0;
  for (unsigned shift = 0; shift < 64; shift += 7) {
    const std::uint8_t byte = u8();
    if (!ok_) return 0;
    v |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
    if ((byte & 0x80) != 0) continue;
    if ((byte == 0 && shift > 0) || (shift == 63 && byte > 1)) break;  // padded or too large
    return v;
  }
  ok_ = false;
  return 0;
}

}  // namespace felt
