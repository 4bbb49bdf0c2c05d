#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/formats/file_format.h"
#include "felt/io/import.h"

namespace felt {

/// Maximum size in bytes of a file that is read, for formats other than .felt.
inline constexpr std::size_t kMaxDrawingBytes = std::size_t{1} << 30;
/// Maximum size in bytes of a file whose format is known only by its name, because its first bytes
/// are not recognised.
inline constexpr std::size_t kMaxUnrecognisedBytes = std::size_t{64} << 20;

/// Options for reading a drawing.
struct ReadOptions {
  ImportOptions import{};
  /// Refuses pipes and devices, because they may never end. Set it in programs with a window.
  bool files_only = false;
  /// Recovers the intact parts of a damaged .felt file (felt_salvage.h), and reports which parts
  /// are missing.
  bool salvage = false;
};

/// Reads a whole drawing of any readable format (docs/formats/README.md). "-" is stdin. The format
/// is determined by the first bytes of the file, not by its name. If the name suggests another
/// format, a notice is added to the report. A record of .ndjson that is not a stroke is skipped and
/// reported. Fits strokes to raw pen samples. The pictures of an .svg may be in files below the
/// folder of `path`.
///
/// The file is not trusted. Fails if it cannot be read, is a folder, exceeds the format's size
/// limit, has no known format, or is damaged; the message begins with the path. Safe to call from
/// any thread.
Result<Imported> read_drawing(const std::string& path, const ReadOptions& options = {});

/// Checks the first bytes of the file `path` before the rest is read (HeadCheck). Returns the
/// maximum size of a file of its format. Fails if read_drawing() would refuse any file that begins
/// so; the message does not begin with the path.
Result<std::size_t> check_drawing_head(std::string_view head, std::uint64_t size,
                                       const std::string& path, bool salvage = false);

/// Returns the folder of a file, for ImportOptions::folder; empty for stdin ("-") and for "".
std::string folder_of(const std::string& path);

/// Reads a drawing from bytes in memory that were read from `path`. Messages do not begin with the
/// path.
Result<Imported> parse_drawing(std::string_view bytes, const std::string& path,
                               const ReadOptions& options = {});

/// Returns the format of a file. It is determined by the first bytes or, if they are not
/// recognised, by the name. Fails if neither is recognised, or if the format is only written; the
/// message does not begin with the path.
Result<FileFormat> readable_format(std::string_view head, const std::string& path);

}  // namespace felt
