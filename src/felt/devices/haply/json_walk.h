#pragma once

#include <optional>

#include "felt/devices/haply/json_scanner.h"

namespace felt::haply {

/// Calls `read(key)` for each key of an object that has been entered. `read` must read or skip the
/// value of that key, and return false if the value is bad. Returns false if the text is bad.
template <class Read>
bool walk_entered_object(JsonScanner& json, Read read) {
  for (;;) {
    const JsonToken token = json.next();
    if (token == JsonToken::kEndObject) return true;
    if (token != JsonToken::kKey || !read(json.text())) return false;
  }
}

/// Enters the next value, which must be an object, and then works like walk_entered_object().
template <class Read>
bool walk_object(JsonScanner& json, Read read) {
  return json.next() == JsonToken::kBeginObject && walk_entered_object(json, read);
}

/// Enters the next value, which must be an array of objects, and calls `read()` for each object.
/// walk_objects() enters the object before the call; `read` must walk to the end of that object.
/// Returns false if the text is bad.
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

/// Returns true if a message stores an array of grips under this key.
constexpr bool is_grip_family(std::string_view key) noexcept {
  return key == "verse_grip" || key == "wireless_verse_grip" || key == "custom_verse_grip";
}

}  // namespace felt::haply
