#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>
#include <utility>

namespace felt::cli {

/// Writes to stdout. A failure is reported once, at the end of the program.
void print_text(std::string_view text) noexcept;
/// Writes to stderr. If a message cannot be written (a full disk, a closed pipe, a closed
/// terminal), it is dropped, and the program continues.
void say_text(std::string_view text) noexcept;

/// Formats the values and writes the text: print() to stdout, say() to stderr.
template <typename... Values>
void print(fmt::format_string<Values...> format, Values&&... values) {
  print_text(fmt::format(format, std::forward<Values>(values)...));
}
template <typename... Values>
void say(fmt::format_string<Values...> format, Values&&... values) {
  say_text(fmt::format(format, std::forward<Values>(values)...));
}

/// Flushes stdout. Returns false if any printed text did not reach it.
bool stdout_is_whole() noexcept;

/// Asks the user a question on stderr and reads the answer from stdin. Returns true only for "y" or
/// "yes". Returns false if stdin is not a terminal.
bool ask(const std::string& question);

/// Returns true if stdin is a terminal, so that the user can answer.
bool somebody_is_there();

/// Returns true if Enter was pressed at the terminal since the last call.
bool enter_pressed();

}  // namespace felt::cli
