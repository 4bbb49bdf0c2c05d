#pragma once

#include <charconv>
#include <cmath>
#include <string_view>

#include "felt/io/limits.h"

namespace felt {

/// Reads numbers separated by white space from the front of a text, in any locale.
class NumberList {
 public:
  enum class Next {
    kNumber,
    kEnd,
    kBad,  ///< not a number, not finite, longer than 64 characters, or beyond 1e9
  };

  explicit NumberList(std::string_view text) noexcept : text_(text) {}

  Next next(double& value) noexcept {
    const std::size_t begin = text_.find_first_not_of(kSpace);
    if (begin == std::string_view::npos) return Next::kEnd;
    text_.remove_prefix(begin);
    word_ = text_.substr(0, text_.find_first_of(kSpace));
    const std::string_view digits = word_.front() == '+' ? word_.substr(1) : word_;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (word_.size() > limits::kMaxNumberChars || error != std::errc() ||
        end != digits.data() + digits.size() || !(std::fabs(value) <= limits::kMaxCoordinate)) {
      return Next::kBad;
    }
    text_.remove_prefix(word_.size());
    return Next::kNumber;
  }

  /// Skips the word at which next() returned kBad.
  void skip() noexcept { text_.remove_prefix(word_.size()); }

  /// Returns the word at which next() stopped.
  [[nodiscard]] std::string_view word() const noexcept { return word_; }

 private:
  static constexpr std::string_view kSpace = " \t\r\n";
  std::string_view text_, word_;
};

/// Reads `text` as a single number. Returns false if the text has no number or more than one.
inline bool single_number(std::string_view text, double& value) noexcept {
  NumberList list(text);
  double more = 0.0;
  return list.next(value) == NumberList::Next::kNumber && list.next(more) == NumberList::Next::kEnd;
}

}  // namespace felt
