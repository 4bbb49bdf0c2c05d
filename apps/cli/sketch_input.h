#pragma once

#include <functional>
#include <string>

#include "console.h"
#include "felt/stroke/sketch.h"
#include "input.h"

namespace felt::cli {

/// Reads the sketch `path` ("-": stdin) stroke by stroke and gives each to `take`. Bad records are
/// reported and left out. False when the input could not be opened, or `take` returned false.
bool for_each_stroke(const std::string& path, Console& console,
                     const std::function<bool(const SketchStroke&)>& take);

}  // namespace felt::cli
