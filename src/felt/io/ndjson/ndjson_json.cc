#include "felt/io/ndjson/ndjson_json.h"

#include <array>
#include <cmath>

namespace felt::json {
namespace {

using simdjson::ondemand::json_type;

/// A container that check_ignored is currently inside.
struct Level {
  bool is_array = false;
  bool started = false;
  simdjson::ondemand::array_iterator element;
  simdjson::ondemand::object_iterator field;

  simdjson::error_code enter(Value& value, json_type type) {
    is_array = type == json_type::array;
    started = false;
    if (is_array) {
      simdjson::ondemand::array array;
      if (const auto error = value.get_array().get(array)) return error;
      return array.begin().get(element);
    }
    simdjson::ondemand::object object;
    if (const auto error = value.get_object().get(object)) return error;
    return object.begin().get(field);
  }

  /// Advances to the next member. Returns false at the end.
  bool next() {
    if (started) is_array ? void(++element) : void(++field);
    started = true;
    return is_array ? element != decltype(element){} : field != decltype(field){};
  }

  simdjson::error_code get(Value& value) {
    if (is_array) return (*element).get(value);
    simdjson::ondemand::field member;
    if (const auto error = (*field).get(member)) return error;
    std::string_view key;
    if (const auto error = member.unescaped_key().get(key)) return error;
    value = member.value();
    return simdjson::SUCCESS;
  }
};

Result<void> check_scalar(Value& value, json_type type) {
  const std::string_view token = token_of(value);
  if (type == json_type::number) {
    if (token.size() > limits::kMaxNumberChars) {
      return tl::unexpected(number_error(token, kCoordinateLimit));
    }
    double number = 0.0;
    if (const auto error = value.get_double().get(number)) {
      return tl::unexpected(syntax_error(error));
    }
  } else if (type == json_type::string) {
    std::string_view text;
    if (const auto error = value.get_string().get(text)) return tl::unexpected(syntax_error(error));
  } else if (token != "true" && token != "false" && token != "null") {
    return bad(excerpt(token) + " is not a JSON value");
  }
  return {};
}

}  // namespace

std::string excerpt(std::string_view token) {
  constexpr std::size_t kShown = 24;
  std::string shown;
  for (char c : token.substr(0, kShown)) shown += c >= ' ' && c <= '~' ? c : '?';
  if (token.size() > kShown) shown += "...";
  return shown.empty() ? "nothing" : shown;
}

Error syntax_error(simdjson::error_code code) {
  switch (code) {
    case simdjson::UTF8_ERROR:
      return {ErrorCode::kInvalidData, "the text is not valid UTF-8"};
    case simdjson::UNCLOSED_STRING:
      return {ErrorCode::kInvalidData, "the line ends inside a string"};
    case simdjson::UNESCAPED_CHARS:
      return {ErrorCode::kInvalidData, "a string contains a control character"};
    case simdjson::STRING_ERROR:
      return {ErrorCode::kInvalidData, "a string contains an invalid escape"};
    case simdjson::NUMBER_ERROR:
      return {ErrorCode::kInvalidData, "a number is malformed or out of range"};
    case simdjson::INCOMPLETE_ARRAY_OR_OBJECT:
      return {ErrorCode::kInvalidData, "the record is cut off, or its brackets do not match"};
    case simdjson::EMPTY:
    case simdjson::INCORRECT_TYPE:
      return {ErrorCode::kInvalidData, "the value has the wrong type"};
    case simdjson::MEMALLOC:
    case simdjson::CAPACITY:
      return {ErrorCode::kLimitExceeded, "the record does not fit into memory"};
    default:
      return {ErrorCode::kInvalidData,
              "the text is not JSON: a comma, colon or bracket is wrong or missing"};
  }
}

bool read_number(Value& value, NumberLimit limit, double& out) {
  const std::string_view token = token_of(value);
  return token.size() <= limits::kMaxNumberChars && !value.get_double().get(out) &&
         std::fabs(out) <= limit.value;
}

Error number_error(std::string_view token, NumberLimit limit) {
  const bool looks_like_one =
      !token.empty() && (token[0] == '-' || (token[0] >= '0' && token[0] <= '9'));
  if (!looks_like_one) return {ErrorCode::kInvalidData, excerpt(token) + " is not a number"};
  if (token.size() > limits::kMaxNumberChars) {
    return {ErrorCode::kLimitExceeded, "number of " + std::to_string(token.size()) +
                                           " characters, at most " +
                                           std::to_string(limits::kMaxNumberChars) + " allowed"};
  }
  if (token.find_first_not_of("+-.0123456789eE") != std::string_view::npos) {
    return {ErrorCode::kInvalidData, excerpt(token) + " is not a number"};
  }
  return {ErrorCode::kLimitExceeded,
          excerpt(token) + " is malformed, or larger than " + limit.text};
}

Result<void> read_numbers(Value& value, std::span<double> out) {
  const std::string_view whole = token_of(value);
  simdjson::ondemand::array elements;
  if (value.get_array().get(elements)) return bad(excerpt(whole) + " is not an array");
  std::size_t count = 0;
  for (auto element : elements) {
    Value item;
    if (const auto error = element.get(item)) return tl::unexpected(syntax_error(error));
    if (count == out.size()) return bad("more than " + std::to_string(count) + " numbers");
    const std::string_view token = token_of(item);
    if (!read_number(item, kSketchLimit, out[count])) {
      return tl::unexpected(
          with_context(number_error(token, kSketchLimit), "number " + std::to_string(count)));
    }
    ++count;
  }
  if (count == out.size()) return {};
  return bad(std::to_string(count) + " numbers instead of " + std::to_string(out.size()));
}

Result<bool> read_bool(Value& value) {
  const std::string_view token = token_of(value);
  bool out = false;
  if (value.get_bool().get(out)) return bad(excerpt(token) + " is not true or false");
  return out;
}

Result<std::string> read_name(Value& value, std::size_t max_bytes) {
  const std::string_view token = token_of(value);
  std::string_view text;
  if (const auto error = value.get_string().get(text)) {
    if (error == simdjson::INCORRECT_TYPE) return bad(excerpt(token) + " is not a string");
    return tl::unexpected(syntax_error(error));
  }
  if (text.size() > max_bytes) {
    return fail(ErrorCode::kLimitExceeded, "longer than " + std::to_string(max_bytes) + " bytes");
  }
  return std::string(text);
}

Result<void> check_ignored(Value& value) {
  std::array<Level, limits::kMaxIgnoredDepth> levels;
  std::size_t depth = 0;
  for (Value current = value;;) {
    json_type type{};
    if (const auto error = current.type().get(type)) return tl::unexpected(syntax_error(error));
    if (type == json_type::array || type == json_type::object) {
      if (depth == levels.size()) {
        return fail(ErrorCode::kLimitExceeded,
                    "nested deeper than " + std::to_string(levels.size()) + " levels");
      }
      if (const auto error = levels[depth++].enter(current, type)) {
        return tl::unexpected(syntax_error(error));
      }
    } else if (Result<void> checked = check_scalar(current, type); !checked) {
      return checked;
    }
    while (depth > 0 && !levels[depth - 1].next()) --depth;
    if (depth == 0) return {};
    if (const auto error = levels[depth - 1].get(current)) {
      return tl::unexpected(syntax_error(error));
    }
  }
}

}  // namespace felt::json
