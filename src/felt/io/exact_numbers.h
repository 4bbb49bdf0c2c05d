#pragma once

#include <span>
#include <string>
#include <string_view>

namespace felt {

/// Doubles to the last bit, written beside rounded ones (docs/formats/svg.md, "Exact numbers").

/// Appends what `values` are more than their rounded `guesses`: a letter with the number of digits
/// and then as many digits for each. Requires as many guesses as values.
void append_exact(std::string& out, std::span<const double> values,
                  std::span<const double> guesses);

/// How many numbers the text holds, if it is whole.
std::size_t exact_count(std::string_view text) noexcept;

/// Fills `values` from a text for as many `guesses`. A value that is farther than `near` from its
/// guess becomes the guess: another program changed that. Returns false, and leaves `values`
/// unspecified, if the text is malformed or holds another number of values.
bool read_exact(std::string_view text, std::span<const double> guesses, double near,
                std::span<double> values);

}  // namespace felt
