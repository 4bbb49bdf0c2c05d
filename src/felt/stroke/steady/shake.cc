#include "felt/stroke/steady/shake.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>

namespace felt {
namespace {

/// A value of a Shake: its name in files, its range, and its member.
struct ShakeValue {
  std::string_view name;
  double min, max;
  double Shake::*member;
};

constexpr std::array<ShakeValue, 3> kShakeValues = {{
    {"hz", Shake::kMinHz, Shake::kMaxHz, &Shake::hz},
    {"amplitude_mm", Shake::kMinAmplitudeMm, Shake::kMaxAmplitudeMm, &Shake::amplitude_mm},
    {"axis_deg", 0.0, Shake::kMaxAxisDeg, &Shake::axis_deg},
}};

std::string two_decimals(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) + 1 - first);
}

/// Returns the part of `rest` before the separator, and removes both from `rest`.
std::string_view cut_part(std::string_view& rest, char separator) {
  const std::size_t end = rest.find(separator);
  const std::string_view part = rest.substr(0, end);
  rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  return part;
}

Result<double> shake_number(const ShakeValue& value, std::string_view text) {
  const std::string_view digits = trimmed(text);
  double number = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size() || !(number >= value.min) ||
      !(number <= value.max)) {
    return fail(ErrorCode::kInvalidData, std::string(value.name) + ": \"" +
                                             std::string(digits.substr(0, 40)) +
                                             "\" is not a number from " + two_decimals(value.min) +
                                             " to " + two_decimals(value.max));
  }
  return number;
}

}  // namespace

std::string shake_to_text(const Shake& shake) {
  std::string text;
  for (const ShakeValue& value : kShakeValues) {
    text += (text.empty() ? "" : ",") + two_decimals(shake.*value.member);
  }
  return text;
}

Result<Shake> shake_from_text(std::string_view text) {
  Shake shake;
  std::string_view rest = text;
  for (std::size_t i = 0; i < kShakeValues.size(); ++i) {
    const bool is_last = i + 1 == kShakeValues.size();
    if (!is_last && rest.find(',') == std::string_view::npos) {
      return fail(ErrorCode::kInvalidData,
                  "expected HZ,MM,DEG: frequency, amplitude and axis, for example 5.2,1,30");
    }
    const Result<double> number =
        shake_number(kShakeValues[i], is_last ? rest : cut_part(rest, ','));
    if (!number) return tl::unexpected(number.error());
    shake.*kShakeValues[i].member = *number;
  }
  return shake;
}

std::string write_shake(const Shake& shake) {
  std::string text = "# Feltline: how a hand shakes (feltline steady calibrate)\n";
  for (const ShakeValue& value : kShakeValues) {
    text += std::string(value.name) + " = " + two_decimals(shake.*value.member) + "\n";
  }
  return text;
}

Result<Shake> read_shake(std::string_view text) {
  Shake shake;
  std::array<bool, kShakeValues.size()> found{};
  for (int line = 1; !text.empty(); ++line) {
    std::string_view rest = trimmed(cut_part(text, '\n'));
    if (rest.empty() || rest.front() == '#') continue;
    const std::string where = "line " + std::to_string(line);
    const std::string_view name = trimmed(cut_part(rest, '='));
    std::size_t i = 0;
    while (i < kShakeValues.size() && kShakeValues[i].name != name) ++i;
    if (i == kShakeValues.size()) {
      return fail(ErrorCode::kInvalidData,
                  where + ": expected \"hz = ...\", \"amplitude_mm = ...\" or \"axis_deg = ...\"");
    }
    const Result<double> number = shake_number(kShakeValues[i], rest);
    if (!number) return tl::unexpected(with_context(number.error(), where));
    shake.*kShakeValues[i].member = *number;
    found[i] = true;
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) {
      return fail(ErrorCode::kInvalidData,
                  "the value \"" + std::string(kShakeValues[i].name) + "\" is missing");
    }
  }
  return shake;
}

}  // namespace felt
