#pragma once

#include <span>
#include <string>
#include <string_view>

namespace felt {

/// Writes and reads exact doubles as small differences from rounded numbers that are in the same
/// file (docs/formats/svg.md, "Exact numbers").

/// Appends the differences between `values` and their rounded values, `guesses`. The text starts
/// with a character that gives the number of digits, followed by that many digits for each value.
/// Requires as many guesses as values.
void append_exact(std::string& out, std::span<const double> values,
                  std::span<const double> guesses);

/// Returns the number of values in the text, or 0 if it is malformed.
std::size_t exact_count(std::string_view text) noexcept;

/// Reads one value for each guess from `text` into `values`. If a value is farther than `near` from
/// its guess, stores the guess instead, because another program has changed the rounded number.
/// Returns false, and leaves `values` unspecified, if the text is malformed or has another number
/// of values.
bool read_exact(std::string_view text, std::span<const double> guesses, double near,
                std::span<double> values);

}  // namespace felt
