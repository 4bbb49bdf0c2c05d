#include "felt/formats/file_format.h"

#include <algorithm>
#include <array>

namespace felt {
namespace {

struct Ending {
  std::string_view text;
  FileFormat format;
};
constexpr std::array kEndings = {
    Ending{".felt", FileFormat::kFelt},    Ending{".ndjson", FileFormat::kNdjson},
    Ending{".jsonl", FileFormat::kNdjson}, Ending{".svg", FileFormat::kSvg},
    Ending{".inkml", FileFormat::kInkml},  Ending{".xopp", FileFormat::kXopp},
    Ending{".pdf", FileFormat::kPdf},      Ending{".png", FileFormat::kPng}};

char lower(char c) noexcept {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

Result<FileFormat> format_of_path(const std::string& path) {
  for (const Ending& ending : kEndings) {
    if (path.size() <= ending.text.size()) continue;
    const std::string_view tail = std::string_view(path).substr(path.size() - ending.text.size());
    if (std::equal(tail.begin(), tail.end(), ending.text.begin(),
                   [](char a, char b) { return lower(a) == b; })) {
      return ending.format;
    }
  }
  std::string known;
  for (const Ending& ending : kEndings) known += ' ' + std::string(ending.text);
  return fail(ErrorCode::kUnsupported, path + ": no format has this ending; there are" + known);
}

}  // namespace felt
