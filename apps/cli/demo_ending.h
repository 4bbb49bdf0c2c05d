#pragma once

#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/drawing.h"

namespace felt::cli {

/// Writes the end of the demonstration to a folder: the drawing as a solid (solid.glb, a picture
/// solid.png that is `size_px` wide, and the film solid.webm, in which it turns), and swim.svg, a
/// fish that swims between two key drawings. Returns the names of the files. Leaves the solid out
/// in programs without the layer solid, and the film without ffmpeg.
Result<std::vector<std::string>> write_demo_ending(const Drawing& drawing,
                                                   const std::string& folder, int size_px);

}  // namespace felt::cli
