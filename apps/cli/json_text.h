#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace felt::cli {

/// The shortest text that reads back as the same double; "null" where it is not finite.
std::string json_number(double value);
/// "[a,b,c]" of values that are JSON.
std::string json_array(const std::vector<std::string>& values);
/// Quoted and escaped.
std::string json_string(std::string_view text);

/// An object on one line, keys in the order in which they are added.
class JsonObject {
 public:
  void add_text(std::string_view key, std::string_view value) { add_raw(key, json_string(value)); }
  void add_number(std::string_view key, double value) { add_raw(key, json_number(value)); }
  /// `json` is JSON already.
  void add_raw(std::string_view key, std::string_view json);
  [[nodiscard]] std::string text() const { return "{" + members_ + "}"; }

 private:
  std::string members_;
};

}  // namespace felt::cli
