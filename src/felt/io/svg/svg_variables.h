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
/// them is not defined and has no fallback, if they are nested more than 8 deep, become longer than
/// 4096 bytes or need more than 64 KiB of values to be read (16 bytes of it for each replacement),
/// or if that is more than `bytes_left`, from which it is subtracted.
std::optional<std::string> svg_with_variables(std::string_view value, const SvgVariables& variables,
                                              std::size_t& bytes_left);

/// Returns the result of "calc(...)" with + - * / and parentheses, nested 8 deep at most. `length`
/// reads a number with its unit. Nullopt if it has an error.
std::optional<double> svg_calc(
    std::string_view text, const std::function<std::optional<double>(std::string_view)>& length);

}  // namespace felt
