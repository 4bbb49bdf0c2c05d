#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace felt {

/// Appends the shortest text that reads back as the same finite double, in any locale.
void append_number(std::string& out, double number);
/// Appends `text` quoted and escaped as JSON.
void append_json_string(std::string& out, std::string_view text);

/// Returns what append_number() appends, or "null" if `value` is not finite.
std::string json_number(double value);
/// Returns "[a,b,c]". Requires that each value is already JSON.
std::string json_array(const std::vector<std::string>& values);
/// Returns `text` quoted and escaped as JSON.
std::string json_string(std::string_view text);

/// Builds a JSON object on one line, with its keys in the order in which they are added. Keys are
/// not escaped.
class JsonObject {
 public:
  void add_text(std::string_view key, std::string_view value);
  void add_number(std::string_view key, double value);
  void add_bool(std::string_view key, bool value) { add_raw(key, value ? "true" : "false"); }
  /// Adds a member whose value is already JSON.
  void add_raw(std::string_view key, std::string_view json);
  /// Returns the object as text.
  [[nodiscard]] std::string text() const { return members_ + "}"; }

 private:
  void add_key(std::string_view key);

  std::string members_ = "{";
};

}  // namespace felt
