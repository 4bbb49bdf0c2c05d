#pragma once

#include <optional>

#include "felt/devices/haply/json_scanner.h"

namespace felt::haply {

/// Calls `read(key)` for each key of an object that has been entered; it reads or skips the value,
/// and says false where that is bad. False: bad.
template <class Read>
bool walk_entered_object(JsonScanner& json, Read read) {
  for (;;) {
    const JsonToken token = json.next();
    if (token == JsonToken::kEndObject) return true;
    if (token != JsonToken::kKey || !read(json.text())) return false;
  }
}

/// The same for an object that is the next value.
template <class Read>
bool walk_object(JsonScanner& json, Read read) {
  return json.next() == JsonToken::kBeginObject && walk_entered_object(json, read);
}

/// The next value is an array of objects: calls `read()` for each, entered; it must walk it to its
/// end.
template <class Read>
bool walk_objects(JsonScanner& json, Read read) {
  if (json.next() != JsonToken::kBeginArray) return false;
  for (;;) {
    const JsonToken token = json.next();
    if (token == JsonToken::kEndArray) return true;
    if (token != JsonToken::kBeginObject || !read()) return false;
  }
}

/// The next value, where it is true or false; what else it is, is passed over.
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

/// The names of the arrays of grips in a message.
constexpr bool is_grip_family(std::string_view key) noexcept {
  return key == "verse_grip" || key == "wireless_verse_grip" || key == "custom_verse_grip";
}

}  // namespace felt::haply
