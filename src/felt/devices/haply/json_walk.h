#pragma once

#include <optional>

#include "felt/devices/haply/json_scanner.h"

namespace felt::haply {

/// Calls `read(key)` for each key of an object that has been entered. `read` must read or skip the
/// value, and return false if it is bad. Returns false if the text is bad.
template <class Read>
bool walk_entered_object(JsonScanner& json, Read read) {
  for (;;) {
    const JsonToken token = json.next();
    if (token == JsonToken::kEndObject) return true;
    if (token != JsonToken::kKey || !read(json.text())) return false;
  }
}

/// Enters the object that is the next value, then does the same as walk_entered_object().
template <class Read>
bool walk_object(JsonScanner& json, Read read) {
  return json.next() == JsonToken::kBeginObject && walk_entered_object(json, read);
}

/// Calls `read()` for each object of the array that is the next value. walk_objects() has entered
/// the object; `read` must walk it to its end. Returns false if the text is bad.
template <class Read>
bool walk_objects(JsonScanner& json, Read read) {
  if (json.next() != JsonToken::kBeginArray) return false;
  for (;;) {
    const JsonToken token = json.next();
    if (token == JsonToken::kEndArray) return true;
    if (token != JsonToken::kBeginObject || !read()) return false;
  }
}

/// Reads the next value into `flag` if it is true or false, and skips any other value. Returns
/// false if the text is bad.
inline bool read_flag(JsonScanner& json, std::optional<bool>& flag) noexcept {
  const JsonToken token = json.next();
  if (token == JsonToken::kTrue || token == JsonToken::kFalse) {
    flag = token == JsonToken::kTrue;
    return true;
  }
  if (token == JsonToken::kBeginObject || token == JsonToken::kBeginArray) {
    return json.leave(json.depth());
  }
  return token != JsonToken::kBad && token != JsonToken::kEnd;
}

/// Returns true for the names of the arrays of grips in a message.
constexpr bool is_grip_family(std::string_view key) noexcept {
  return key == "verse_grip" || key == "wireless_verse_grip" || key == "custom_verse_grip";
}

}  // namespace felt::haply
