#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace felt {

/// The values of custom properties of CSS ("--name") by their names.
using SvgVariables = std::map<std::string, std::string, std::less<>>;

/// Returns `value` with every "var(--name)" and "var(--name, fallback)" replaced by the value of
/// the variable or by the fallback. Returns nullopt if a variable is undefined and has no fallback,
/// or if a limit is exceeded: more than 8 levels of nesting, a result longer than 4096 bytes, more
/// than 64 KiB of text read, or more text read than `bytes_left`. The text read is `value`, the
/// values of variables and the fallbacks, and 16 bytes more for each of them. Its size is
/// subtracted from `bytes_left`.
std::optional<std::string> svg_with_variables(std::string_view value, const SvgVariables& variables,
                                              std::size_t& bytes_left);

/// Evaluates "calc(...)" with + - * / and parentheses, nested at most 8 deep. `length` reads a
/// number with its unit. Returns nullopt if the text has an error.
std::optional<double> svg_calc(
    std::string_view text, const std::function<std::optional<double>(std::string_view)>& length);

}  // namespace felt
