#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/formats/file_format.h"
#include "felt/io/import.h"

namespace felt {

/// Largest file of a foreign format, or of lines, that is read as a whole.
inline constexpr std::size_t kMaxDrawingBytes = std::size_t{1} << 30;

/// How a drawing is read.
struct ReadOptions {
  ImportOptions import{};
  /// Refuses pipes and devices, which may never end: where a person waits before a window.
  bool files_only = false;
  /// Of a damaged .felt file takes what can be had (felt_salvage.h); the report says what is not.
  bool salvage = false;
};

/// Reads a whole drawing of any format (docs/formats/README.md) that is read. "-" is stdin. What
/// the first bytes show is believed, not the name; a name that says otherwise becomes a notice. A
/// record of .ndjson that is no stroke becomes a notice as well and the rest is taken; raw pen
/// samples become ink.
///
/// The file is not trusted. Error: it cannot be read, is a folder, larger than the format's limit,
/// of no known format, or damaged; the message begins with the path. Any thread.
Result<Imported> read_drawing(const std::string& path, const ReadOptions& options = {});

/// The same, of bytes in memory that came by the name `path`. Messages do not begin with it.
Result<Imported> parse_drawing(std::string_view bytes, const std::string& path,
                               const ReadOptions& options = {});

/// What a file is, by its first bytes or, where they show nothing, by its name. Error: neither
/// tells, or a format that is not read; the message does not begin with the path.
Result<FileFormat> readable_format(std::string_view head, const std::string& path);

}  // namespace felt
