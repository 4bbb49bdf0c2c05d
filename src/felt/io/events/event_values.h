#pragma once

/// Values of the keys of an event line. Private to this layer. Errors start with the key.

#include <array>
#include <string>
#include <string_view>

#include "felt/io/events/event_fields.h"

namespace felt::json {

/// Reads the number at `key` into `out`.
inline Result<void> parse_number(Value& value, const char* key, NumberLimit limit, double& out) {
  const std::string_view token = token_of(value);
  if (read_number(value, limit, out)) return {};
  return tl::unexpected(with_context(number_error(token, limit), key));
}

/// Reads the text at `key` into `out`. Fails if it is empty or contains a NUL.
inline Result<void> parse_text(Value& value, const char* key, std::string& out,
                               std::size_t max_bytes = limits::kMaxNameBytes) {
  Result<std::string> text = read_name(value, max_bytes);
  if (!text) return tl::unexpected(with_context(text.error(), key));
  if (text->empty()) return bad(std::string(key) + ": is empty");
  if (text->find('\0') != std::string::npos) return bad(std::string(key) + ": contains a NUL");
  out = std::move(*text);
  return {};
}

/// Reads the value of an option.
inline Result<void> parse_option_value(Value& value, EventFields& out) {
  const std::string_view token = token_of(value);
  if (!token.empty() && token[0] == '"') {
    Result<std::string> text = read_name(value);
    if (!text) return tl::unexpected(with_context(text.error(), "value"));
    out.value = std::move(*text);
    return {};
  }
  if (token == "true" || token == "false") {
    const Result<bool> is_on = read_bool(value);
    if (!is_on) return tl::unexpected(with_context(is_on.error(), "value"));
    out.value = *is_on;
    return {};
  }
  double number = 0.0;
  if (!read_number(value, kCoordinateLimit, number)) {
    const Error error = number_error(token, kCoordinateLimit);
    if (error.code == ErrorCode::kLimitExceeded)
      return tl::unexpected(with_context(error, "value"));
    return bad("value: " + excerpt(token) + " is not a number, a string, true or false");
  }
  out.value = number;
  return {};
}

/// Converts a word of a list to the enumerator at the same index.
template <class Enum, std::size_t N>
Result<void> parse_word(Value& value, const char* key, const std::array<std::string_view, N>& words,
                        Enum& out) {
  std::string text;
  if (Result<void> read = parse_text(value, key, text); !read) return read;
  std::string known;
  for (std::size_t i = 0; i < N; ++i) {
    if (words[i] == text) {
      out = static_cast<Enum>(i);
      return {};
    }
    known += (known.empty() ? "" : ", ") + std::string(words[i]);
  }
  return bad(std::string(key) + ": \"" + excerpt(text) + "\" is not one of " + known);
}

}  // namespace felt::json
