#pragma once

#include <string_view>

#include "felt/base/result.h"
#include "felt/io/import.h"

namespace felt {

/// Points of Xournal++ and PostScript, 72 per inch.
inline constexpr double kMmPerPoint = 25.4 / 72.0;

/// Empty space between the sheets of pages that are laid out below each other.
inline constexpr double kPageGapMm = 5.0;

/// Reads a document of Xournal++ or Xournal: gzip'ed XML, XML as it is, or the zip container.
/// Pages come below each other, each layer as a layer; docs/formats/xopp.md says what becomes of
/// what. `bytes` is the whole file. Error: it is no such document, or beyond the limits.
Result<Imported> import_xopp(std::string_view bytes, const ImportOptions& options = {});

}  // namespace felt
