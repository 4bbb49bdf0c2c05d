#include "felt/tools/tool_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "felt/base/check.h"

namespace felt {
namespace {

std::string text(double v) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.9g", v);
  return buffer.data();
}

std::string text(const OptionValue& value) {
  if (const double* number = std::get_if<double>(&value)) return text(*number);
  if (const bool* on = std::get_if<bool>(&value)) return *on ? "true" : "false";
  return "'" + std::get<std::string>(value) + "'";
}

tl::unexpected<Error> refuse(const OptionSpec& spec, const OptionValue& value) {
  return fail(ErrorCode::kInvalidArgument, "option '" + std::string(spec.id) + "' cannot be " +
                                               text(value) + ": " + allowed_text(spec));
}

Result<double> number_of(const OptionSpec& spec, const OptionValue& value) {
  const double* number = std::get_if<double>(&value);
  // Written so that NaN is refused.
  if (!number || !(*number >= spec.min && *number <= spec.max)) return refuse(spec, value);
  return *number;
}

Result<double> switch_of(const OptionSpec& spec, const OptionValue& value) {
  const bool* on = std::get_if<bool>(&value);
  if (!on) return refuse(spec, value);
  return *on ? 1.0 : 0.0;
}

Result<double> choice_of(const OptionSpec& spec, const OptionValue& value) {
  const std::string* name = std::get_if<std::string>(&value);
  if (!name) return refuse(spec, value);
  const auto found = std::find(spec.choices.begin(), spec.choices.end(), *name);
  if (found == spec.choices.end()) return refuse(spec, value);
  return static_cast<double>(found - spec.choices.begin());
}

Result<double> stored(const OptionSpec& spec, const OptionValue& value) {
  switch (spec.kind) {
    case OptionKind::kSwitch:
      return switch_of(spec, value);
    case OptionKind::kChoice:
      return choice_of(spec, value);
    case OptionKind::kNumber:
      break;
  }
  return number_of(spec, value);
}

}  // namespace

std::string allowed_text(const OptionSpec& spec) {
  switch (spec.kind) {
    case OptionKind::kSwitch:
      return "it is true or false";
    case OptionKind::kChoice: {
      std::string names = "it is one of";
      for (std::string_view choice : spec.choices) {
        names += choice == spec.choices.front() ? " " : ", ";
        names += choice;
      }
      return names;
    }
    case OptionKind::kNumber:
      break;
  }
  return "it is a number from " + text(spec.min) + " to " + text(spec.max) +
         (spec.unit.empty() ? "" : " " + std::string(spec.unit));
}

std::string_view decider_of(const OptionSpec& spec) noexcept {
  return spec.when.substr(0, spec.when.find('='));
}

bool matters_with(const OptionSpec& spec, std::string_view choice) noexcept {
  if (spec.when.empty()) return true;
  std::string_view words = spec.when.substr(spec.when.find('=') + 1);
  for (;;) {
    const std::size_t end = words.find('|');
    if (words.substr(0, end) == choice) return true;
    if (end == std::string_view::npos) return false;
    words.remove_prefix(end + 1);
  }
}

OptionValue default_value(const OptionSpec& spec) {
  if (spec.kind == OptionKind::kSwitch) return spec.fallback != 0.0;
  if (spec.kind == OptionKind::kChoice) {
    return std::string(spec.choices[static_cast<std::size_t>(spec.fallback)]);
  }
  return spec.fallback;
}

OptionValues::OptionValues(std::span<const OptionSpec> table) : table_(table) {
  for (const OptionSpec& spec : table_) {
    const auto value = stored(spec, default_value(spec));
    FELT_CHECK(value.has_value());
    values_.push_back(*value);
  }
}

Result<std::size_t> OptionValues::find(std::string_view id) const {
  const auto spec =
      std::find_if(table_.begin(), table_.end(), [&](const OptionSpec& s) { return s.id == id; });
  if (spec == table_.end()) {
    return fail(ErrorCode::kNotFound, "there is no option '" + std::string(id) + "'");
  }
  return static_cast<std::size_t>(spec - table_.begin());
}

Result<void> OptionValues::set(std::string_view id, const OptionValue& value) {
  const auto i = find(id);
  if (!i) return tl::unexpected(i.error());
  const auto number = stored(table_[*i], value);
  if (!number) return tl::unexpected(number.error());
  values_[*i] = *number;
  return {};
}

Result<OptionValue> OptionValues::get(std::string_view id) const {
  const auto i = find(id);
  if (!i) return tl::unexpected(i.error());
  const OptionSpec& spec = table_[*i];
  OptionValue value = number(*i);
  if (spec.kind == OptionKind::kSwitch) value = is_on(*i);
  if (spec.kind == OptionKind::kChoice) value = std::string(spec.choices[choice(*i)]);
  return value;
}

}  // namespace felt
