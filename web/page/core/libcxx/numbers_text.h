#pragma once

#include <system_error>

// Declares what numbers_text.cc defines: conversions of floating-point numbers that the C++ library
// of emscripten 3.1.6 lacks.
namespace felt::page {

/// Writes the shortest digits that read back as `number`, in the form that std::to_chars chooses.
/// Returns the end, or null if there is not enough space.
char* shortest_text(char* first, char* last, double number) noexcept;
/// Does the same without an exponent.
char* shortest_fixed_text(char* first, char* last, double number) noexcept;
/// Writes `number` with this number of digits after the point; with `is_general`, with so many
/// significant digits.
char* rounded_text(char* first, char* last, double number, int precision, char format) noexcept;
/// Reads a number as std::from_chars does. Returns the end of what was read; `first` if it is not a
/// number.
const char* read_number(const char* first, const char* last, double& number,
                        std::errc& error) noexcept;

}  // namespace felt::page
