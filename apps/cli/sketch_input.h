#pragma once

#include <functional>
#include <string>

#include "console.h"
#include "format.h"
#include "sketch_output.h"

namespace felt::cli {

/// Reads the sketch `path` ("-": stdin; .ndjson, .felt, .svg), made ready for an output of that
/// format, and gives it to `take` in pieces of some strokes. Bad records, and strokes that the
/// format cannot hold, are reported and left out. False when the input could not be opened, or
/// `take` returned false.
bool for_each_piece(const std::string& path, Format format, Console& console,
                    const std::function<bool(const SketchPiece&)>& take);

}  // namespace felt::cli
