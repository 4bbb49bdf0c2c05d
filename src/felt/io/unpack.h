#pragma once

#include <cstddef>
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

}  // namespace felt
