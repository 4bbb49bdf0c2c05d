#pragma once

#include <QString>
#include <QStringList>

#include "felt/base/result.h"
#include "felt/store/felt_file.h"
#include "felt/stroke/sketch.h"

namespace felt::desktop {

/// What a file of a drawing holds: document, page, material and colour, layer in use.
using Drawing = StoredDrawing;

/// Formats by the ending of a name.
enum class DrawingFormat {
  kFelt,    ///< everything, exactly
  kSketch,  ///< .ndjson: strokes; read also where it holds raw pen samples, which become ink
  kSvg,     ///< strokes and sheet, for other programs; read where Feltline wrote it
  kPdf,     ///< written only
  kPng,     ///< written only
};

/// Of the ending, in either case. Error: another one, or none.
Result<DrawingFormat> drawing_format(const QString& path);

/// ".felt"
QString suffix_of(DrawingFormat format);

/// The name with the format's ending, unless it has an ending of that format already.
QString with_suffix(const QString& path, DrawingFormat format);

/// Reads a drawing: .felt, a sketch or raw pen strokes (.ndjson), or an SVG file that Feltline
/// wrote. All but .felt have one layer. Error: names the file, the place and the reason. Any
/// thread.
Result<Drawing> read_drawing(const QString& path);

/// Writes it whole or not at all, and durably, in the format of the name's ending. All formats but
/// .felt take the strokes of visible layers. Error: names the file and the reason. Any thread.
Result<void> write_drawing(const QString& path, const Drawing& drawing);

}  // namespace felt::desktop
