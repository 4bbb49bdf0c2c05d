#include "felt/base/csv_value.h"

#include <charconv>
#include <cmath>

namespace felt {

std::string spreadsheet_text(std::string_view value) {
  constexpr std::string_view kFormulaStarts = "=+-@\t\r\n";
  if (value.empty() || kFormulaStarts.find(value.front()) == std::string_view::npos) {
    return std::string(value);
  }
  double number = 0.0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  const bool is_number =
      error == std::errc() && end == value.data() + value.size() && std::isfinite(number);
  return is_number ? std::string(value) : "'" + std::string(value);
}

void append_csv_value(std::string& out, std::string_view value) {
  const std::string text = spreadsheet_text(value);
  if (text.find_first_of(",\"\r\n\t") == std::string::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  out += '"';
}

}  // namespace felt
