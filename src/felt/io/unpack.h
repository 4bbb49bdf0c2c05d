#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/io/limits.h"

namespace felt {

/// How large unpacked data may become.
struct UnpackLimits {
  std::size_t bytes = limits::kMaxImportBytes;
  std::size_t free_bytes = limits::kFreeInflatedBytes;  ///< below this any ratio is fine
  std::size_t ratio = limits::kMaxInflation;            ///< to the packed size, above it
};

/// True for data that begins as gzip, or as a zip archive.
bool is_gzip(std::string_view bytes) noexcept;
bool is_zip(std::string_view bytes) noexcept;

/// The content of gzip'ed data, of all its members. Error: damaged, cut, or beyond the limits.
Result<std::string> gunzip(std::string_view bytes, const UnpackLimits& limits = {});

/// The content of one file in a zip archive in memory. Nothing is written anywhere. Error: it is
/// not there, damaged, encrypted, or beyond the limits.
Result<std::string> file_in_zip(std::string_view bytes, const std::string& name,
                                const UnpackLimits& limits = {});

/// Gzip'ed data: the same bytes for the same text, since it holds neither a time nor a name.
std::string gzip(std::string_view text);

/// Data as zlib packs it (RFC 1950), which PDF calls FlateDecode. Likewise.
std::string zlib_packed(std::string_view bytes);

// What packed data is made of, for data that comes in pieces: head, pieces, end, tail.

std::string gzip_head();
/// Appends a piece, packed without regard to what came before it.
void append_deflated(std::string& out, std::string_view bytes);
void append_deflate_end(std::string& out);
void append_gzip_tail(std::string& out, std::uint32_t crc32, std::uint64_t raw_bytes);
/// Head and tail of data as zlib packs it.
std::string zlib_head();
void append_zlib_tail(std::string& out, std::uint32_t adler32);

/// Checksums of a piece, and of two that follow each other, the second of so many bytes. That of no
/// bytes is 0 for CRC-32, 1 for Adler-32.
std::uint32_t crc32_of(std::string_view bytes);
std::uint32_t crc32_joined(std::uint32_t first, std::uint32_t second, std::uint64_t second_bytes);
std::uint32_t adler32_of(std::string_view bytes);
std::uint32_t adler32_joined(std::uint32_t first, std::uint32_t second, std::uint64_t second_bytes);

}  // namespace felt
