#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace felt {

/// Custom properties of CSS ("--name") with their values.
using SvgVariables = std::map<std::string, std::string, std::less<>>;

/// Returns `value` with every "var(--name)" and "var(--name, fallback)" replaced. Nullopt if one of
/// them is not defined and has no fallback, or if they are nested more than 8 deep or become longer
/// than 4096 bytes.
std::optional<std::string> svg_with_variables(std::string_view value,
                                              const SvgVariables& variables);

/// Returns the result of "calc(...)" with + - * / and parentheses, nested 8 deep at most. `length`
/// reads a number with its unit. Nullopt if it has an error.
std::optional<double> svg_calc(
    std::string_view text, const std::function<std::optional<double>(std::string_view)>& length);

}  // namespace felt
