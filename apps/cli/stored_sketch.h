#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/stroke/sketch.h"

namespace felt::cli {

/// True for files that are read as a whole and not line by line: .felt, .svg.
bool is_stored_sketch(const std::string& path);

/// The strokes of such a file: of a .felt file those of visible layers in drawing order, named
/// after their ids; of an .svg file that Feltline wrote all, by the names they have. Error: names
/// the file, the place and the reason.
Result<Sketch> read_stored_sketch(const std::string& path);

}  // namespace felt::cli
