#include "felt/devices/haply/json_scanner.h"

#include <charconv>
#include <cmath>

namespace felt::haply {
namespace {

bool is_digit(char c) noexcept {
  return c >= '0' && c <= '9';
}

bool is_hex(char c) noexcept {
  return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

std::size_t digits(std::string_view text, std::size_t at) noexcept {
  while (at < text.size() && is_digit(text[at])) ++at;
  return at;
}

// Returns the length of the number at the beginning of `text`, or 0 if `text` does not begin with a
// number. JSON's grammar is narrower than that of from_chars: it does not allow leading zeros, and
// requires a digit on both sides of the point.
std::size_t number_end(std::string_view text) noexcept {
  std::size_t at = text.starts_with('-') ? 1 : 0;
  const std::size_t whole = digits(text, at);
  if (whole == at || (text[at] == '0' && whole > at + 1)) return 0;
  at = whole;
  if (at < text.size() && text[at] == '.') {
    const std::size_t end = digits(text, at + 1);
    if (end == at + 1) return 0;
    at = end;
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    const std::size_t end = digits(text, at);
    if (end == at) return 0;
    at = end;
  }
  return at;
}

}  // namespace

JsonToken JsonScanner::bad() noexcept {
  is_bad_ = true;
  return JsonToken::kBad;
}

void JsonScanner::skip_space() noexcept {
  const std::size_t at = rest_.find_first_not_of(" \t\r\n");
  rest_.remove_prefix(at == std::string_view::npos ? rest_.size() : at);
}

void JsonScanner::value_is_over() noexcept {
  expect_ = depth_ > 0 ? Expect::kCommaOrEnd : Expect::kNothing;
}

JsonToken JsonScanner::next() noexcept {
  if (is_bad_) return JsonToken::kBad;
  skip_space();
  if (rest_.empty()) return expect_ == Expect::kNothing ? JsonToken::kEnd : bad();
  switch (expect_) {
    case Expect::kValue:
      return value();
    case Expect::kFirstKey:
      return rest_.front() == '}' ? close() : key();
    case Expect::kKey:
      return key();
    case Expect::kFirstItem:
      return rest_.front() == ']' ? close() : value();
    case Expect::kCommaOrEnd:
      return after_value();
    case Expect::kNothing:
      break;
  }
  return bad();
}

JsonToken JsonScanner::after_value() noexcept {
  if (rest_.front() == (in_object() ? '}' : ']')) return close();
  if (rest_.front() != ',') return bad();
  rest_.remove_prefix(1);
  skip_space();
  if (rest_.empty()) return bad();
  return in_object() ? key() : value();
}

JsonToken JsonScanner::key() noexcept {
  if (rest_.front() != '"' || !read_string()) return bad();
  skip_space();
  if (!rest_.starts_with(':')) return bad();
  rest_.remove_prefix(1);
  expect_ = Expect::kValue;
  return JsonToken::kKey;
}

JsonToken JsonScanner::value() noexcept {
  if (rest_.front() == '{') return open(true);
  if (rest_.front() == '[') return open(false);
  const JsonToken token = scalar();
  if (token != JsonToken::kBad) value_is_over();
  return token;
}

JsonToken JsonScanner::scalar() noexcept {
  switch (rest_.front()) {
    case '"':
      return read_string() ? JsonToken::kString : bad();
    case 't':
      return literal("true", JsonToken::kTrue);
    case 'f':
      return literal("false", JsonToken::kFalse);
    case 'n':
      return literal("null", JsonToken::kNull);
    default:
      return read_number();
  }
}

JsonToken JsonScanner::literal(std::string_view word, JsonToken token) noexcept {
  if (!rest_.starts_with(word)) return bad();
  rest_.remove_prefix(word.size());
  return token;
}

JsonToken JsonScanner::open(bool is_object) noexcept {
  if (depth_ == kMaxDepth) return bad();
  rest_.remove_prefix(1);
  const std::uint32_t bit = std::uint32_t{1} << depth_++;
  objects_ = is_object ? objects_ | bit : objects_ & ~bit;
  expect_ = is_object ? Expect::kFirstKey : Expect::kFirstItem;
  return is_object ? JsonToken::kBeginObject : JsonToken::kBeginArray;
}

JsonToken JsonScanner::close() noexcept {
  const bool was_object = in_object();
  rest_.remove_prefix(1);
  --depth_;
  value_is_over();
  return was_object ? JsonToken::kEndObject : JsonToken::kEndArray;
}

JsonToken JsonScanner::read_number() noexcept {
  const std::size_t end = number_end(rest_);
  if (end == 0) return bad();
  const auto [stop, error] = std::from_chars(rest_.data(), rest_.data() + end, number_);
  if (error != std::errc{} || stop != rest_.data() + end || !std::isfinite(number_)) return bad();
  rest_.remove_prefix(end);
  return JsonToken::kNumber;
}

bool JsonScanner::read_string() noexcept {
  std::size_t at = 1;
  for (; at < rest_.size() && rest_[at] != '"'; ++at) {
    if (static_cast<unsigned char>(rest_[at]) < 0x20) return false;
    if (rest_[at] != '\\') continue;
    if (++at >= rest_.size()) return false;
    if (rest_[at] == 'u') {
      for (int i = 0; i < 4; ++i) {
        if (++at >= rest_.size() || !is_hex(rest_[at])) return false;
      }
    } else if (std::string_view("\"\\/bfnrt").find(rest_[at]) == std::string_view::npos) {
      return false;
    }
  }
  if (at >= rest_.size()) return false;
  text_ = rest_.substr(1, at - 1);
  rest_.remove_prefix(at + 1);
  return true;
}

bool JsonScanner::leave(int depth) noexcept {
  while (depth_ >= depth) {
    const JsonToken token = next();
    if (token == JsonToken::kBad || token == JsonToken::kEnd) return false;
  }
  return true;
}

bool JsonScanner::skip_value() noexcept {
  const JsonToken token = next();
  if (token == JsonToken::kBeginObject || token == JsonToken::kBeginArray) return leave(depth_);
  return token != JsonToken::kBad && token != JsonToken::kEnd;
}

}  // namespace felt::haply
