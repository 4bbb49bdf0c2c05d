#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "felt/base/result.h"

namespace felt {

/// File formats.
enum class FileFormat {
  kFelt,    ///< everything, exactly
  kNdjson,  ///< lines of JSON: fitted strokes, raw pen samples, or drawings of Quick, Draw!
  kSvg,
  kInkml,
  kXopp,
  kPdf,  ///< written only
  kPng,  ///< written only
};

/// Returns the format for the ending of `path`, in upper or lower case. Fails if the ending is
/// unknown or missing; the message names the path and lists the known endings.
Result<FileFormat> format_of_path(const std::string& path);

/// Returns true if the name says that the whole file is compressed by gzip: .svgz, in upper or
/// lower case.
bool is_compressed_name(const std::string& path);

/// Number of bytes from the start of a file that format_of_bytes() needs.
inline constexpr std::size_t kFormatHeadBytes = 4096;

/// Returns the format of a file by its first bytes, whatever its name. Recognises the signatures of
/// SQLite, gzip, zip, PDF and PNG. Recognises XML by its first element after comments and a
/// document type, in UTF-8 or UTF-16, and lines of JSON by a brace. Returns nullopt for anything
/// else. The bytes are not trusted.
std::optional<FileFormat> format_of_bytes(std::string_view head);

/// The kinds of content that lines of JSON may have. The keys of the first line that has a known
/// key determine the kind.
enum class NdjsonContent {
  kStrokes,    ///< fitted strokes or raw pen samples (docs/formats/ndjson.md); or unknown
  kQuickdraw,  ///< drawings of Quick, Draw!
  kEvents,     ///< an event script or a recording (docs/formats/events.md), which holds no strokes
};
NdjsonContent ndjson_content(std::string_view head) noexcept;

}  // namespace felt
