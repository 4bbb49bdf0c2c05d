#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/formats/file_format.h"

namespace felt::cli {

using Format = FileFormat;

/// The format for an output: `name` (of --to) when given, else by the ending of `path`; "-" and
/// devices are .ndjson. Error: it says what there is.
Result<Format> output_format(const std::string& path, const std::string& name);

}  // namespace felt::cli
