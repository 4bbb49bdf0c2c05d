#include "felt/base/numbered_names.h"

#include <algorithm>
#include <charconv>

namespace felt {

std::optional<NumberedNames> NumberedNames::parse(const std::string& text) {
  const std::size_t folder = text.find_last_of('/');  // a folder's name may contain anything
  const std::size_t start = folder == std::string::npos ? 0 : folder;
  for (std::size_t at = text.find('%', start); at != std::string::npos;
       at = text.find('%', at + 1)) {
    std::size_t end = at + 1;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    if (end == text.size() || text[end] != 'd') continue;
    std::size_t digits = 1;
    if (std::from_chars(text.data() + at + 1, text.data() + end, digits).ec != std::errc()) {
      digits = 1;
    }
    NumberedNames names;
    names.before_ = text.substr(0, at);
    names.after_ = text.substr(end + 1);
    names.digits_ = std::min<std::size_t>(digits, 20);
    return names;
  }
  return std::nullopt;
}

NumberedNames NumberedNames::before_suffix(const std::string& path) {
  const std::size_t name = path.find_last_of('/') + 1;  // 0 without a folder
  std::size_t dot = path.find_last_of('.');
  if (dot == std::string::npos || dot < name) dot = path.size();
  NumberedNames names;
  names.before_ = path.substr(0, dot) + "-";
  names.after_ = path.substr(dot);
  names.digits_ = 3;
  return names;
}

std::string NumberedNames::name(std::size_t number) const {
  std::string digits = std::to_string(number);
  if (digits.size() < digits_) digits.insert(0, digits_ - digits.size(), '0');
  return before_ + digits + after_;
}

}  // namespace felt
