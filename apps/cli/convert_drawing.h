#pragma once

#include <string>

#include "felt/formats/drawing_reader.h"
#include "format.h"
#include "picture.h"

namespace felt::cli {

/// Keeps the layers that `text` (of --layers) names: "visible" drops hidden ones, "all" shows them,
/// else numbers from 1, the lowest, with commas between ("1,3"), or the name of one layer; those
/// that are chosen are shown. "" changes nothing. Error: there is no such layer; it lists them.
Result<void> choose_layers(const std::string& text, StoredDrawing& drawing);

/// Writes a drawing that was read as a whole. What it holds beyond strokes comes along where the
/// format can say it: layers, hidden ones too, and its page unless `picture` asks for another.
Result<void> write_opened(const std::string& path, OpenedDrawing opened, Format format,
                          const PictureOptions& picture);

}  // namespace felt::cli
