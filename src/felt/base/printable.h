#pragma once

#include <string>
#include <string_view>

namespace felt {

/// Returns `text` as one line that is safe to print on a terminal: control characters, characters
/// that change the writing direction, and bytes that are not UTF-8 become escapes ("\n", "\x1b",
/// "\u202e"). For names and other text read from files.
std::string printable(std::string_view text);

}  // namespace felt
