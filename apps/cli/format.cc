#include "format.h"

#include "felt/formats/format_traits.h"

namespace felt::cli {
namespace {

Result<Format> named_format(const std::string& path, const std::string& name) {
  if (!name.empty()) return format_of_name(name);
  if (path == "-" || path.rfind("/dev/", 0) == 0) return Format::kNdjson;
  const std::string file = path.substr(path.find_last_of('/') + 1);
  const std::size_t dot = file.find_last_of('.');
  if (dot == std::string::npos || dot == 0) {
    return fail(ErrorCode::kUnsupported,
                path + ": the file name has no extension, so its format is unknown; use " +
                    "--to " + writable_names());
  }
  Result<Format> format = format_of_path(path);
  if (format) return format;
  return fail(ErrorCode::kUnsupported, path + ": the extension '" + file.substr(dot) +
                                           "' is unknown; the formats are " + writable_names());
}

}  // namespace

Result<Format> output_format(const std::string& path, const std::string& name) {
  Result<Format> format = named_format(path, name);
  if (!format || traits_of(*format).writes) return format;
  return fail(ErrorCode::kUnsupported, path + ": " + std::string(traits_of(*format).title) +
                                           " cannot be written; the formats are " +
                                           writable_names());
}

}  // namespace felt::cli
