#include "felt/io/unpack.h"

#include <zip.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "felt/base/check.h"

namespace felt {
namespace {

constexpr std::size_t kBlock = std::size_t{64} << 10;
constexpr int kGzipWindow = 15 + 16;  // the largest window, with a gzip header

tl::unexpected<Error> too_large() {
  return fail(ErrorCode::kLimitExceeded, "is too large when unpacked");
}

bool fits(std::size_t unpacked, std::size_t packed, const UnpackLimits& limits) {
  return unpacked <= limits.bytes &&
         (unpacked <= limits.free_bytes || unpacked <= limits.ratio * packed);
}

struct EndInflate {
  void operator()(z_stream* stream) const noexcept {
    inflateEnd(stream);
    delete stream;
  }
};
struct CloseZip {
  void operator()(zip_t* zip) const noexcept { zip_discard(zip); }
};
struct CloseZipFile {
  void operator()(zip_file_t* file) const noexcept { zip_fclose(file); }
};

}  // namespace

bool is_gzip(std::string_view bytes) noexcept {
  return bytes.substr(0, 2) == "\x1F\x8B";
}

bool is_zip(std::string_view bytes) noexcept {
  return bytes.substr(0, 4) == "PK\x03\x04";
}

Result<std::string> gunzip(std::string_view bytes, const UnpackLimits& limits) {
  std::unique_ptr<z_stream, EndInflate> stream(new z_stream{});
  FELT_CHECK(inflateInit2(stream.get(), kGzipWindow) == Z_OK);
  std::string text;
  std::array<char, kBlock> block;
  // zlib uses 32-bit sizes; inputs are at most kMaxImportBytes.
  if (bytes.size() > limits::kMaxImportBytes) return too_large();
  stream->next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream->avail_in = static_cast<uInt>(bytes.size());
  for (;;) {
    stream->next_out = reinterpret_cast<Bytef*>(block.data());
    stream->avail_out = static_cast<uInt>(block.size());
    const int status = inflate(stream.get(), Z_NO_FLUSH);
    text.append(block.data(), block.size() - stream->avail_out);
    if (!fits(text.size(), bytes.size(), limits)) return too_large();
    if (status == Z_STREAM_END) {
      const std::string_view rest = bytes.substr(bytes.size() - stream->avail_in);
      if (!is_gzip(rest)) return text;
      inflateReset(stream.get());
      continue;
    }
    if (status == Z_BUF_ERROR ||
        (status == Z_OK && stream->avail_out > 0 && stream->avail_in == 0)) {
      return fail(ErrorCode::kInvalidData, "is incomplete: the packed data ends too early");
    }
    if (status != Z_OK) return fail(ErrorCode::kInvalidData, "is damaged: it cannot be unpacked");
  }
}

Result<std::string> file_in_zip(std::string_view bytes, const std::string& name,
                                const UnpackLimits& limits) {
  if (bytes.size() > limits::kMaxImportBytes) return too_large();
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  const std::unique_ptr<zip_t, CloseZip> zip(
      source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error));
  zip_error_fini(&error);
  if (!zip) {
    if (source != nullptr) zip_source_free(source);
    return fail(ErrorCode::kInvalidData, "is a damaged zip archive");
  }
  const std::unique_ptr<zip_file_t, CloseZipFile> file(zip_fopen(zip.get(), name.c_str(), 0));
  if (!file) {
    return fail(ErrorCode::kInvalidData, "is a zip archive without a readable '" + name + "'");
  }
  std::string text;
  std::array<char, kBlock> block;
  for (;;) {
    const zip_int64_t got = zip_fread(file.get(), block.data(), block.size());
    if (got < 0)
      return fail(ErrorCode::kInvalidData, "is damaged: '" + name + "' cannot be unpacked");
    if (got == 0) return text;
    text.append(block.data(), static_cast<std::size_t>(got));
    if (!fits(text.size(), bytes.size(), limits)) return too_large();
  }
}

namespace {

std::string packed_by(z_stream& stream, std::string_view text) {
  std::string packed;
  std::array<char, kBlock> block;
  int status = Z_OK;
  while (status != Z_STREAM_END) {
    if (stream.avail_in == 0 && !text.empty()) {
      const std::string_view part = text.substr(0, std::size_t{1} << 30);
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(part.data()));
      stream.avail_in = static_cast<uInt>(part.size());
      text.remove_prefix(part.size());
    }
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = static_cast<uInt>(block.size());
    status = deflate(&stream, text.empty() ? Z_FINISH : Z_NO_FLUSH);
    packed.append(block.data(), block.size() - stream.avail_out);
  }
  deflateEnd(&stream);
  return packed;
}

}  // namespace

std::string gzip(std::string_view text) {
  z_stream stream{};
  FELT_CHECK(deflateInit2(&stream, 9, Z_DEFLATED, kGzipWindow, 9, Z_DEFAULT_STRATEGY) == Z_OK);
  // The header has no time and no name. 255 means an unknown system, so that all machines write the
  // same bytes.
  gz_header header{};
  header.os = 255;
  FELT_CHECK(deflateSetHeader(&stream, &header) == Z_OK);
  return packed_by(stream, text);
}

std::string zlib_packed(std::string_view bytes) {
  z_stream stream{};
  FELT_CHECK(deflateInit(&stream, Z_DEFAULT_COMPRESSION) == Z_OK);
  return packed_by(stream, bytes);
}

std::string gzip_head() {
  // A gzip header: deflate, no flags, no time, no extra flags; 255 means an unknown system.
  return std::string("\x1f\x8b\x08\0\0\0\0\0\0\xff", 10);
}

void append_deflated(std::string& out, std::string_view bytes) {
  constexpr int kRaw = -15;  // the largest window, no header
  constexpr int kMemory = 9;
  constexpr int kFast = 3;  // takes a third of the time of the default, 6; output is a tenth larger
  if (bytes.empty()) return;
  z_stream stream{};
  FELT_CHECK(deflateInit2(&stream, kFast, Z_DEFLATED, kRaw, kMemory, Z_DEFAULT_STRATEGY) == Z_OK);
  std::array<char, kBlock> block;
  for (bool more = true; more;) {
    if (stream.avail_in == 0) {
      const std::string_view part = bytes.substr(0, std::size_t{1} << 30);
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(part.data()));
      stream.avail_in = static_cast<uInt>(part.size());
      bytes.remove_prefix(part.size());
    }
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = static_cast<uInt>(block.size());
    // A full flush ends on a whole byte, and later pieces do not refer back to this one.
    deflate(&stream, bytes.empty() ? Z_FULL_FLUSH : Z_NO_FLUSH);
    out.append(block.data(), block.size() - stream.avail_out);
    more = stream.avail_out == 0 || !bytes.empty();
  }
  deflateEnd(&stream);
}

void append_deflate_end(std::string& out) {
  out += std::string("\x03\0", 2);  // an empty final block
}

namespace {

void append_little_endian(std::string& out, std::uint32_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8)
    out += static_cast<char>((value >> shift) & 255U);
}

uLong checksum_of(uLong (*sum)(uLong, const Bytef*, uInt), std::string_view bytes) {
  uLong value = sum(0, nullptr, 0);
  while (!bytes.empty()) {
    const std::string_view part = bytes.substr(0, std::size_t{1} << 30);
    value = sum(value, reinterpret_cast<const Bytef*>(part.data()), static_cast<uInt>(part.size()));
    bytes.remove_prefix(part.size());
  }
  return value;
}

}  // namespace

void append_gzip_tail(std::string& out, std::uint32_t crc32, std::uint64_t raw_bytes) {
  append_little_endian(out, crc32);
  append_little_endian(out, static_cast<std::uint32_t>(raw_bytes));
}

std::string zlib_head() {
  return "\x78\x9c";
}

void append_zlib_tail(std::string& out, std::uint32_t adler32) {
  for (unsigned shift = 32; shift > 0;) {
    out += static_cast<char>((adler32 >> (shift -= 8)) & 255U);
  }
}

std::uint32_t crc32_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(checksum_of(&crc32, bytes));
}

std::uint32_t crc32_joined(std::uint32_t first, std::uint32_t second, std::uint64_t second_bytes) {
  return static_cast<std::uint32_t>(
      crc32_combine(first, second, static_cast<z_off_t>(second_bytes)));
}

std::uint32_t adler32_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(checksum_of(&adler32, bytes));
}

std::uint32_t adler32_joined(std::uint32_t first, std::uint32_t second,
                             std::uint64_t second_bytes) {
  return static_cast<std::uint32_t>(
      adler32_combine(first, second, static_cast<z_off_t>(second_bytes)));
}

}  // namespace felt
