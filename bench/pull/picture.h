#pragma once

#include <span>
#include <string>

#include "felt/base/result.h"
#include "methods.h"

namespace felt::bench {

/// Writes a PNG with a row for each pull and a column for each method. The stroke is grey before
/// the pull and blue after it, and the path of the pen is red. Ticks mark the ends of the intended
/// span.
Result<void> write_picture(const std::string& path, std::span<const Pull> pulls, double radius_mm);

}  // namespace felt::bench
