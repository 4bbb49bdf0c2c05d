#include "commands.h"

#include <fmt/core.h>

#include <charconv>
#include <cstdint>

#include "felt/driver/device_profile.h"
#include "felt/haptics/safety/safety_limits.h"

namespace felt::cli {

CLI::Validator number_between(double low, double high) {
  const std::string range = fmt::format("{:g}..{:g}", low, high);
  const auto check = [low, high, range](const std::string& text) -> std::string {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool fine =
        error == std::errc() && end == text.data() + text.size() && number >= low && number <= high;
    return fine ? "" : "'" + text + "' is not a number in " + range;
  };
  return CLI::Validator(check, range);
}

void add_force_limit(CLI::App& command, double& limit_n) {
  command.add_option("--limit", limit_n, "Largest force, N; never more than the device's")
      ->check(number_between(kMinForceLimitN, SafetyLimits{}.peak_force_n))
      ->capture_default_str();
}

CLI::Validator not_empty() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        return text.empty() ? "must not be empty" : "";
      },
      "TEXT");
}

CLI::Validator whole_number() {
  const auto check = [](const std::string& text) -> std::string {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool fine = error == std::errc() && end == text.data() + text.size();
    return fine ? "" : "'" + text + "' is not a whole number from 0 to 2^64 - 1";
  };
  return CLI::Validator(check, "NUMBER");
}

std::string examples(const std::string& lines) {
  std::string text = "Examples:\n  ";
  for (const char c : lines) text += c == '\n' ? std::string("\n  ") : std::string(1, c);
  return text;
}

}  // namespace felt::cli
