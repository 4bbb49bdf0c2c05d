#pragma once

/// Pieces of NdjsonParser on top of simdjson's on-demand interface. Private to this layer.
/// Each function consumes the value that it gets, and leaves the document where the next one
/// begins. After an error the document must not be used any more.

#include <simdjson.h>

#include <span>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/io/limits.h"

namespace felt::json {

using Value = simdjson::ondemand::value;

/// An error about a place in a record: a plain text, no format.
inline tl::unexpected<Error> bad(std::string message) {
  return fail(ErrorCode::kInvalidData, std::move(message));
}

/// The front of a piece of the input, made safe to show: printable ASCII only, at most 24 long.
std::string excerpt(std::string_view token);

/// Says in our words what simdjson found.
Error syntax_error(simdjson::error_code code);

/// Text of a scalar as written, and of a container its bracket. Does not consume.
inline std::string_view token_of(Value& value) {
  std::string_view token = value.raw_json_token();
  while (!token.empty() && (token.back() == ' ' || token.back() == '\t')) token.remove_suffix(1);
  return token;
}

/// Largest magnitude of a number, as value and as a person writes it.
struct NumberLimit {
  double value;
  const char* text;
};
inline constexpr NumberLimit kCoordinateLimit = {limits::kMaxCoordinate, "1e9"};
inline constexpr NumberLimit kSketchLimit = {limits::kMaxSketchNumber, "1e10"};
inline constexpr NumberLimit kTimeLimit = {limits::kMaxTimeMs, "9e12"};

/// A finite number of at most `limit` in magnitude. On failure returns false, without a text:
/// `number_error` makes it. This split keeps the path of good samples free of strings.
bool read_number(Value& value, NumberLimit limit, double& out);

/// Why `read_number` refused `token`.
Error number_error(std::string_view token, NumberLimit limit);

/// Exactly out.size() numbers of a sketch.
Result<void> read_numbers(Value& value, std::span<double> out);

/// true or false.
Result<bool> read_bool(Value& value);

/// A string of at most so many bytes.
Result<std::string> read_name(Value& value, std::size_t max_bytes = limits::kMaxNameBytes);

/// Calls `each(value)` for every element of the array `value`; the error of an element starts with
/// its place, "points[17]: ".
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

/// Walks through a value that is not ours and finds whether it is JSON at all. No recursion; nested
/// deeper than `limits::kMaxIgnoredDepth` is an error.
Result<void> check_ignored(Value& value);

}  // namespace felt::json
