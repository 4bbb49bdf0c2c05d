#pragma once

#include <span>
#include <string>

#include "felt/base/result.h"
#include "methods.h"

namespace felt::bench {

/// Writes a PNG with a row for each pull and a column for each method: the stroke before in grey,
/// after in blue, the way of the pen in red, the ends of the intended span as ticks.
Result<void> write_picture(const std::string& path, std::span<const Pull> pulls, double radius_mm);

}  // namespace felt::bench
