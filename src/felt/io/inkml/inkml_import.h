#pragma once

#include <string_view>

#include "felt/base/result.h"
#include "felt/io/import.h"

namespace felt {

/// Size in mm of a unit of X and Y if the file does not specify it: a CSS pixel, 96 per inch.
inline constexpr double kInkmlMmPerUnknownUnit = 25.4 / 96.0;

/// Reads InkML: the Recommendation, the subset of Microsoft Office, the plain form of the data sets
/// CROHME and MathWriting, and the output of inkml_text(), which is read back exactly, including
/// layers. docs/formats/inkml.md describes how content is converted. `bytes` is the whole file.
/// Fails if it is not InkML or exceeds a limit.
Result<Imported> import_inkml(std::string_view bytes, const ImportOptions& options = {});

}  // namespace felt
