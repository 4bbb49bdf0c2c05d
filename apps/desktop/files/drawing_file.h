#pragma once

#include <QString>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/formats/drawing_reader.h"
#include "felt/formats/file_format.h"

namespace felt::desktop {

/// Returns the file extension of a format: ".felt".
QString suffix_of(FileFormat format);

/// Returns the path with an extension of the format. If the path already has one of the format's
/// extensions, returns it unchanged.
QString with_suffix(const QString& path, FileFormat format);

/// Reads a drawing of any format and reports unsupported content. The format is detected from the
/// content. With `salvage`, reads as much as possible of a damaged .felt file. The error names the
/// file, the position and the reason. Fails if the path is not a regular file, for example a pipe,
/// because reading it might block the window. Safe to call from any thread.
Result<Imported> open_drawing(const QString& path, bool salvage = false);

/// Does the same as open_drawing(), but returns no report.
Result<Drawing> read_drawing(const QString& path);

/// Writes a drawing in the format of the path's extension, completely or not at all. When the
/// function returns, the data is on the disk. If the format has no layers, writes the strokes of
/// visible layers. The error names the file and the reason. Safe to call from any thread.
Result<void> write_drawing(const QString& path, const Drawing& drawing);

}  // namespace felt::desktop
