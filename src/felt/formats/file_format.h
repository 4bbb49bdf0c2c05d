#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "felt/base/result.h"

namespace felt {

/// What a file holds.
enum class FileFormat {
  kFelt,    ///< everything, exactly
  kNdjson,  ///< lines of JSON: fitted strokes, raw pen samples, or drawings of Quick, Draw!
  kSvg,
  kInkml,
  kXopp,
  kPdf,  ///< written only
  kPng,  ///< written only
};

/// The format that the ending of `path` names, in either case. Error: another ending, or none; it
/// names the path and lists those there are.
Result<FileFormat> format_of_path(const std::string& path);

/// Whether a file of this name is compressed as a whole by gzip: .svgz, in either case.
bool is_compressed_name(const std::string& path);

/// How many bytes of a file format_of_bytes wants to see.
inline constexpr std::size_t kFormatHeadBytes = 4096;

/// The format that the first bytes of a file show, whatever its name says: the marks of SQLite,
/// gzip, zip, PDF and PNG; the first element of XML, in UTF-8 or UTF-16, behind comments and a
/// document type; a brace for lines of JSON. None for anything else, or nothing. Bytes are not
/// trusted.
std::optional<FileFormat> format_of_bytes(std::string_view head);

/// What lines of JSON hold, by the keys of the first record that tells.
enum class NdjsonContent {
  kStrokes,    ///< fitted strokes or raw pen samples (docs/formats/ndjson.md), or not known
  kQuickdraw,  ///< drawings of Quick, Draw!
  kEvents,     ///< an event script or a recording (docs/formats/events.md), which holds no strokes
};
NdjsonContent ndjson_content(std::string_view head) noexcept;

}  // namespace felt
