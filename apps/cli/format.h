#pragma once

#include <string>

#include "felt/base/result.h"

namespace felt::cli {

/// What a file holds.
enum class Format { kNdjson, kFelt, kSvg, kPdf, kPng };

/// The format that the extension of `path` names; "-" and devices are .ndjson. The error lists the
/// known ones.
Result<Format> format_of_path(const std::string& path);

/// The format called `name` ("ndjson", "felt", "svg", "pdf", "png").
Result<Format> format_of_name(const std::string& name);

/// The format for an output: `name` (of --to) when given, else by the extension.
Result<Format> output_format(const std::string& path, const std::string& name);

}  // namespace felt::cli
