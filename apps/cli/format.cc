#include "format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace felt::cli {
namespace {

struct Name {
  std::string_view text;
  Format format;
};
constexpr std::array kNames = {Name{"ndjson", Format::kNdjson}, Name{"jsonl", Format::kNdjson},
                               Name{"felt", Format::kFelt},     Name{"svg", Format::kSvg},
                               Name{"pdf", Format::kPdf},       Name{"png", Format::kPng}};
constexpr const char* kKnown = "ndjson, felt, svg, pdf or png";

}  // namespace

Result<Format> format_of_name(const std::string& name) {
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Name& known : kNames) {
    if (known.text == lower) return known.format;
  }
  return fail(ErrorCode::kUnsupported, "'" + name + "' is no format; there is " + kKnown);
}

Result<Format> format_of_path(const std::string& path) {
  if (path == "-" || path.rfind("/dev/", 0) == 0) return Format::kNdjson;
  const std::string name = path.substr(path.find_last_of('/') + 1);
  const std::size_t dot = name.find_last_of('.');
  if (dot == std::string::npos || dot == 0) {
    return fail(ErrorCode::kUnsupported, path + ": has no extension to tell the format by; use " +
                                             std::string("--to ") + kKnown);
  }
  Result<Format> format = format_of_name(name.substr(dot + 1));
  if (format) return format;
  return fail(ErrorCode::kUnsupported, path + ": the extension '" + name.substr(dot) +
                                           "' is not known; there is ." +
                                           "ndjson, .felt, .svg, .pdf and .png");
}

Result<Format> output_format(const std::string& path, const std::string& name) {
  return name.empty() ? format_of_path(path) : format_of_name(name);
}

}  // namespace felt::cli
