#include "json_text.h"

#include <cmath>

#include "felt/io/ndjson/ndjson_writer.h"

namespace felt::cli {

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

void JsonObject::add_raw(std::string_view key, std::string_view json) {
  if (!members_.empty()) members_ += ',';
  members_ += json_string(key) + ":" + std::string(json);
}

}  // namespace felt::cli
