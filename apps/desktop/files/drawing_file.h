#pragma once

#include <QString>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/formats/drawing_reader.h"
#include "felt/formats/file_format.h"

namespace felt::desktop {

/// Returns the file extension of a format: ".felt".
QString suffix_of(FileFormat format);

/// Returns the path with the format's extension, unchanged if it already has one of that format.
QString with_suffix(const QString& path, FileFormat format);

/// Reads a drawing of any format, chosen by content, with a report of unsupported content. With
/// `salvage`, reads as much as possible of a damaged .felt file. The error names the file, the
/// place and the reason. Fails if the path is not a regular file, for example a pipe, on which the
/// window would wait. Safe to call from any thread.
Result<Imported> open_drawing(const QString& path, bool salvage = false);

/// Reads it without the report.
Result<Drawing> read_drawing(const QString& path);

/// Writes a drawing whole or not at all, and durably, in the format of the path's extension.
/// Formats without layers get the strokes of visible layers. The error names the file and the
/// reason. Safe to call from any thread.
Result<void> write_drawing(const QString& path, const Drawing& drawing);

}  // namespace felt::desktop
