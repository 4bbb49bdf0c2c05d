#pragma once

#include <string>
#include <string_view>

#include "felt/base/result.h"

namespace felt {

/// What a file holds.
enum class FileFormat {
  kFelt,    ///< everything, exactly
  kNdjson,  ///< lines of JSON: fitted strokes, raw pen samples, or drawings of Quick, Draw!
  kSvg,
  kInkml,
  kXopp,
  kPdf,  ///< written only
  kPng,  ///< written only
};

/// The format that the ending of `path` names, in either case. Error: another ending, or none; it
/// names the path and lists those there are.
Result<FileFormat> format_of_path(const std::string& path);

}  // namespace felt
