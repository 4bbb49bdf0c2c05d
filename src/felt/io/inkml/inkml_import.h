#pragma once

#include <string_view>

#include "felt/base/result.h"
#include "felt/io/import.h"

namespace felt {

/// Length of a unit of X and Y where a file does not say it: a pixel of CSS, 96 per inch.
inline constexpr double kInkmlMmPerUnknownUnit = 25.4 / 96.0;

/// Reads InkML: the Recommendation, the subset of Microsoft Office, the plain form of the data sets
/// CROHME and MathWriting, and what inkml_text() wrote, which comes back exactly, layers too.
/// docs/formats/inkml.md says what becomes of what. `bytes` is the whole file. Error: it is no
/// InkML, or beyond the limits.
Result<Imported> import_inkml(std::string_view bytes, const ImportOptions& options = {});

}  // namespace felt
