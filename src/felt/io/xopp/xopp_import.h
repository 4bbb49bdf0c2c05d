#pragma once

#include <string_view>

#include "felt/base/result.h"
#include "felt/io/import.h"

namespace felt {

/// Length of a point in mm. Xournal++ and PostScript measure in points of 1/72 inch.
inline constexpr double kMmPerPoint = 25.4 / 72.0;

/// Gap between pages, which are placed below each other.
inline constexpr double kPageGapMm = 5.0;

/// Reads a document of Xournal++ or Xournal: gzip'ed XML, plain XML, or the zip container. Pages
/// are placed below each other in one drawing, and each layer of a page becomes a layer of the
/// drawing. docs/formats/xopp.md describes how content is converted. `bytes` is the whole file.
/// Fails if the file is not such a document or exceeds a limit.
Result<Imported> import_xopp(std::string_view bytes, const ImportOptions& options = {});

}  // namespace felt
