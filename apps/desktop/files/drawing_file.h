#pragma once

#include <QString>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/formats/drawing_reader.h"
#include "felt/formats/file_format.h"

namespace felt::desktop {

/// ".felt"
QString suffix_of(FileFormat format);

/// The name with the format's ending, unless it has an ending of that format already.
QString with_suffix(const QString& path, FileFormat format);

/// Reads a drawing of any format, by its content, with what could not be taken. Error: names the
/// file, the place and the reason; no file at all, but a pipe, for which the window would wait. Any
/// thread. `salvage`: of a damaged .felt file what can be had.
Result<Imported> open_drawing(const QString& path, bool salvage = false);

/// The same without the report.
Result<Drawing> read_drawing(const QString& path);

/// Writes it whole or not at all, and durably, in the format of the name's ending. Formats without
/// layers take the strokes of visible ones. Error: names the file and the reason. Any thread.
Result<void> write_drawing(const QString& path, const Drawing& drawing);

}  // namespace felt::desktop
