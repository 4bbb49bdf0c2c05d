#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/store/felt_file.h"

namespace felt::cli {

/// Keeps the layers that `text` (of --layers) names: "visible" drops hidden ones, "all" shows them,
/// else numbers from 1, the lowest, with commas between ("1,3"), or the name of one layer; those
/// that are chosen are shown. "" changes nothing. Error: there is no such layer; it lists them.
Result<void> choose_layers(const std::string& text, Drawing& drawing);

}  // namespace felt::cli
