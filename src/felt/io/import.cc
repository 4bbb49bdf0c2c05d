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
  std::string kind = notice_kind(what);
  if (std::count(kinds_.begin(), kinds_.end(), kind) == kMaxOfAKind) {
    const auto last = std::find(kinds_.rbegin(), kinds_.rend(), kind);
    ++notices_[static_cast<std::size_t>(kinds_.rend() - last) - 1].count;
    return;
  }
  if (notices_.size() == kMaxKinds) {
    ++notices_.back().count;
    return;
  }
  if (notices_.size() + 1 == kMaxKinds) what = "and others were changed or skipped";
  if (element.size() > kMaxElementBytes) {
    std::size_t end = kMaxElementBytes;
    while (end > 0 && (static_cast<unsigned char>(element[end]) & 0xc0) == 0x80) --end;
    element.resize(end);
    element += "...";
  }
  notices_.push_back({line, std::move(element), std::move(what), 1});
  kinds_.push_back(std::move(kind));
}

void ImportReport::add_faults(std::int64_t line, const std::string& id,
                              const SampleFaults& faults) {
  for (std::string& clause : fault_clauses(faults)) {
    add(line, name_with_faults("stroke '" + id + "'", faults), std::move(clause));
  }
}

std::string notice_kind(std::string_view text) {
  std::string kind;
  bool in_quotes = false, in_number = false;
  for (const char c : text) {
    const bool is_digit = c >= '0' && c <= '9';
    in_number = !in_quotes && (is_digit || (in_number && c == '.'));
    if (!in_quotes && !in_number) kind += c;
    if (c == '\'') in_quotes = !in_quotes;
  }
  return kind;
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
