#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/formats/file_format.h"

namespace felt::cli {

using Format = FileFormat;

/// Returns the format of an output: `name` (the value of --to) if given, otherwise the format of
/// the extension of `path`. The format of "-" and of paths below /dev/ is .ndjson. Fails if the
/// format is unknown; the message lists the formats.
Result<Format> output_format(const std::string& path, const std::string& name);

}  // namespace felt::cli
