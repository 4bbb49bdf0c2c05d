#include "felt/io/ndjson/json_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace felt {

void append_number(std::string& out, double number) {
  std::array<char, 32> text;  // the shortest form of a double has at most 24 characters
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
  out.append(text.data(), end);
}

void append_json_string(std::string& out, std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  out += '"';
  for (char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20) {
      out += "\\u00";
      out += kDigits[byte >> 4];
      out += kDigits[byte & 15];
    } else {
      out += c;
    }
  }
  out += '"';
}

std::string json_number(double value) {
  if (!std::isfinite(value)) return "null";
  std::string text;
  append_number(text, value);
  return text;
}

std::string json_array(const std::vector<std::string>& values) {
  std::string text = "[";
  for (const std::string& value : values) text += (text.size() > 1 ? "," : "") + value;
  return text + "]";
}

std::string json_string(std::string_view text) {
  std::string quoted;
  append_json_string(quoted, text);
  return quoted;
}

void JsonObject::add_key(std::string_view key) {
  members_ += members_.size() > 1 ? ",\"" : "\"";
  members_ += key;
  members_ += "\":";
}

void JsonObject::add_text(std::string_view key, std::string_view value) {
  add_key(key);
  append_json_string(members_, value);
}

void JsonObject::add_number(std::string_view key, double value) {
  add_raw(key, json_number(value));
}

void JsonObject::add_raw(std::string_view key, std::string_view json) {
  add_key(key);
  members_ += json;
}

}  // namespace felt
