#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/io/limits.h"

namespace felt {

/// Limits on the size of unpacked data.
struct UnpackLimits {
  std::size_t bytes = limits::kMaxImportBytes;
  std::size_t free_bytes =
      limits::kFreeInflatedBytes;             ///< up to this unpacked size, any ratio is allowed
  std::size_t ratio = limits::kMaxInflation;  ///< above `free_bytes`: maximum ratio of
                                              ///< unpacked to packed size
};

/// Return true if the data begins like gzip data (is_gzip) or like a zip archive (is_zip).
bool is_gzip(std::string_view bytes) noexcept;
bool is_zip(std::string_view bytes) noexcept;

/// Returns the unpacked content of all members of gzip data. Fails if the data is damaged,
/// truncated or beyond the limits.
Result<std::string> gunzip(std::string_view bytes, const UnpackLimits& limits = {});

/// Returns the unpacked content of one file of a zip archive. Works in memory and writes nothing to
/// disk. Fails if the file is missing, damaged, encrypted or beyond the limits.
Result<std::string> file_in_zip(std::string_view bytes, const std::string& name,
                                const UnpackLimits& limits = {});

/// Packs `text` with gzip. The same text always gives the same bytes, because the result contains
/// no time and no name.
std::string gzip(std::string_view text);

/// Packs `bytes` in zlib format (RFC 1950), which PDF calls FlateDecode. The same input gives the
/// same bytes.
std::string zlib_packed(std::string_view bytes);

// The following functions pack data that is produced in pieces. Write a head, then the pieces, then
// the deflate end, then a tail.

std::string gzip_head();
/// Appends a piece, compressed independently of the pieces before it.
void append_deflated(std::string& out, std::string_view bytes);
void append_deflate_end(std::string& out);
void append_gzip_tail(std::string& out, std::uint32_t crc32, std::uint64_t raw_bytes);
/// zlib_head() returns the head of data in zlib format; append_zlib_tail() appends its tail.
std::string zlib_head();
void append_zlib_tail(std::string& out, std::uint32_t adler32);

/// ..._of() returns the checksum of a piece; ..._joined() computes the checksum of two consecutive
/// pieces from their checksums and the size of the second piece. The checksum of no bytes is 0 for
/// CRC-32 and 1 for Adler-32.
std::uint32_t crc32_of(std::string_view bytes);
std::uint32_t crc32_joined(std::uint32_t first, std::uint32_t second, std::uint64_t second_bytes);
std::uint32_t adler32_of(std::string_view bytes);
std::uint32_t adler32_joined(std::uint32_t first, std::uint32_t second, std::uint64_t second_bytes);

}  // namespace felt
