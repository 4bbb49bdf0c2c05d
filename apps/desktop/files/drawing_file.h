#pragma once

#include <QString>

#include "felt/base/result.h"
#include "felt/formats/drawing_reader.h"
#include "felt/formats/file_format.h"
#include "felt/store/felt_file.h"
#include "felt/stroke/sketch.h"

namespace felt::desktop {

/// What a file of a drawing holds: document, page, material and colour, layer in use.
using Drawing = StoredDrawing;

/// ".felt"
QString suffix_of(FileFormat format);

/// The name with the format's ending, unless it has an ending of that format already.
QString with_suffix(const QString& path, FileFormat format);

/// Reads a drawing of any format, by its content, with what could not be taken. Error: names the
/// file, the place and the reason; no file at all, but a pipe, for which the window would wait. Any
/// thread. `salvage`: of a damaged .felt file what can be had.
Result<OpenedDrawing> open_drawing(const QString& path, bool salvage = false);

/// The same without the report.
Result<Drawing> read_drawing(const QString& path);

/// Writes it whole or not at all, and durably, in the format of the name's ending. Formats without
/// layers take the strokes of visible ones. Error: names the file and the reason. Any thread.
Result<void> write_drawing(const QString& path, const Drawing& drawing);

}  // namespace felt::desktop
