#include "felt/io/import.h"

#include <algorithm>
#include <utility>

namespace felt {

void ImportReport::add(std::int64_t line, std::string element, std::string what) {
  const auto same = std::find_if(notices_.begin(), notices_.end(),
                                 [&](const ImportNotice& n) { return n.what == what; });
  if (same != notices_.end()) {
    ++same->count;
    return;
  }
  if (notices_.size() == kMostKinds) {
    ++notices_.back().count;
    return;
  }
  if (notices_.size() + 1 == kMostKinds) what = "and others were not taken as they are";
  if (element.size() > kMaxElementBytes) {
    std::size_t end = kMaxElementBytes;
    while (end > 0 && (static_cast<unsigned char>(element[end]) & 0xc0) == 0x80) --end;
    element.resize(end);
    element += "...";
  }
  notices_.push_back({line, std::move(element), std::move(what), 1});
}

std::string notice_text(const ImportNotice& notice) {
  std::string text;
  if (notice.line > 0) text = "line " + std::to_string(notice.line) + ": ";
  if (!notice.element.empty()) text += notice.element + " ";
  text += notice.what;
  if (notice.count > 1) text += " (and " + std::to_string(notice.count - 1) + " more like it)";
  return text;
}

}  // namespace felt
