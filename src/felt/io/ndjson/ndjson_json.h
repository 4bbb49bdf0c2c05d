#pragma once

/// The parts of NdjsonParser that use simdjson's on-demand interface. Private to this layer. Each
/// function consumes its value and leaves the document at the start of the next value. After an
/// error, the document must not be used again.

#include <simdjson.h>

#include <span>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/io/limits.h"

namespace felt::json {

using Value = simdjson::ondemand::value;

/// Returns an error about a position in a record. The message is plain text, not a format string.
inline tl::unexpected<Error> bad(std::string message) {
  return fail(ErrorCode::kInvalidData, std::move(message));
}

/// Returns the start of a piece of the input in a form that is safe to show: printable ASCII only,
/// at most 24 characters.
std::string excerpt(std::string_view token);

/// Converts an error of simdjson to an error with our own message.
Error syntax_error(simdjson::error_code code);

/// Returns the text of a scalar as written, or the opening bracket of a container. Does not consume
/// the value.
inline std::string_view token_of(Value& value) {
  std::string_view token = value.raw_json_token();
  while (!token.empty() && (token.back() == ' ' || token.back() == '\t')) token.remove_suffix(1);
  return token;
}

/// Largest magnitude of a number, as a value and as text for messages.
struct NumberLimit {
  double value;
  const char* text;
};
inline constexpr NumberLimit kCoordinateLimit = {limits::kMaxCoordinate, "1e9"};
inline constexpr NumberLimit kSketchLimit = {limits::kMaxSketchNumber, "1e10"};
inline constexpr NumberLimit kTimeLimit = {limits::kMaxTimeMs, "9e12"};

/// Reads a finite number of at most `limit` in magnitude. Returns false on failure; number_error()
/// then makes the message. The two are separate so that reading valid numbers involves no strings.
bool read_number(Value& value, NumberLimit limit, double& out);

/// Returns the error that says why read_number() refused `token`.
Error number_error(std::string_view token, NumberLimit limit);

/// Reads exactly out.size() numbers of a sketch.
Result<void> read_numbers(Value& value, std::span<double> out);

/// Reads true or false.
Result<bool> read_bool(Value& value);

/// Reads a string of at most `max_bytes` bytes.
Result<std::string> read_name(Value& value, std::size_t max_bytes = limits::kMaxNameBytes);

/// Calls `each(value)` for every element of the array `value`. The message of an error in an
/// element starts with the position of the element, "points[17]: ".
template <class Each>
Result<void> for_each_element(Value& value, const char* key, Each&& each) {
  const std::string_view token = token_of(value);
  simdjson::ondemand::array elements;
  if (value.get_array().get(elements)) {
    return bad(std::string(key) + ": " + excerpt(token) + " is not an array");
  }
  std::size_t index = 0;
  const auto here = [&](Error error) {
    return tl::unexpected(
        with_context(std::move(error), std::string(key) + "[" + std::to_string(index) + "]"));
  };
  for (auto element : elements) {
    Value item;
    if (const auto error = element.get(item)) return here(syntax_error(error));
    if (Result<void> done = each(item); !done) return here(done.error());
    ++index;
  }
  return {};
}

/// Checks that an ignored value is valid JSON, without recursion. Fails if it is nested deeper than
/// `limits::kMaxIgnoredDepth`.
Result<void> check_ignored(Value& value);

}  // namespace felt::json
