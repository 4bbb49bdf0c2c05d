#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/store/felt_file.h"

namespace felt::cli {

/// Keeps the layers in `text` (of --layers): "visible" drops hidden ones, "all" shows them.
/// Otherwise it is a list of numbers from 1, the lowest, separated by commas ("1,3"), or the name
/// of one layer; selected layers become visible. "" changes nothing. Fails if there is no such
/// layer; the message lists them.
Result<void> choose_layers(const std::string& text, Drawing& drawing);

}  // namespace felt::cli
