#pragma once

#include <string>
#include <string_view>

namespace felt {

/// Returns the value as text that a spreadsheet shows and does not compute: a text that begins with
/// =, +, -, @, a tab or an end of line, and is not a number, gets an apostrophe before it.
std::string spreadsheet_text(std::string_view value);

/// Appends the spreadsheet_text() of a value to a line of CSV (RFC 4180), in quotes if it needs
/// them.
void append_csv_value(std::string& out, std::string_view value);

}  // namespace felt
