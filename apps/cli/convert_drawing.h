#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/store/felt_file.h"

namespace felt::cli {

/// Removes all layers except those in `text`, the value of --layers. "visible" removes hidden
/// layers; "all" keeps all layers and makes them visible. Otherwise `text` contains the numbers of
/// layers, separated by commas ("1,3"), with 1 for the lowest, or the name of one layer; these
/// layers become visible. An empty text changes nothing. Fails if a layer does not exist; the
/// message lists the layers.
Result<void> choose_layers(const std::string& text, Drawing& drawing);

}  // namespace felt::cli
