#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/store/felt_file.h"

namespace felt::cli {

/// Keeps the layers in `text` (of --layers). "visible" drops hidden ones, "all" makes all visible.
/// Otherwise `text` is the numbers of the layers, separated by commas ("1,3"), with 1 for the
/// lowest, or the name of one layer; they become visible. "" changes nothing. Fails if there is no
/// such layer; the message lists them.
Result<void> choose_layers(const std::string& text, Drawing& drawing);

}  // namespace felt::cli
