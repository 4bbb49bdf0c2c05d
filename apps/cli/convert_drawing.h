#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/store/felt_file.h"

namespace felt::cli {

/// Removes all layers except those in `text`, the value of --layers. "visible" removes hidden
/// layers; "all" keeps all layers and makes them visible. Otherwise `text` is the name of one
/// layer, or a list of numbers and names separated by commas ("1,3"); layer 1 is the lowest. The
/// layers that are kept become visible. An empty text changes nothing. Fails if a layer does not
/// exist; the message lists up to 20 layers.
Result<void> choose_layers(const std::string& text, Drawing& drawing);

}  // namespace felt::cli
