#include "felt/tools/tool_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "felt/base/check.h"
#include "felt/material/material_file.h"

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
  // This form of the comparison also rejects NaN.
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

/// A tool accepts any name, because only the session knows which materials exist.
Result<double> open_choice_of(const OptionSpec& spec, const OptionValue& value) {
  const std::string* name = std::get_if<std::string>(&value);
  if (!name || !is_material_id(*name)) return refuse(spec, value);
  return 0.0;
}

std::string one_of(std::span<const std::string> choices) {
  std::string names = "it must be one of";
  for (const std::string& choice : choices) {
    names += &choice == choices.data() ? " " : ", ";
    names += choice;
  }
  return names;
}

Result<double> stored(const OptionSpec& spec, const OptionValue& value) {
  switch (spec.kind) {
    case OptionKind::kSwitch:
      return switch_of(spec, value);
    case OptionKind::kChoice:
      return spec.open == OpenChoice::kNone ? choice_of(spec, value) : open_choice_of(spec, value);
    case OptionKind::kNumber:
      break;
  }
  return number_of(spec, value);
}

}  // namespace

std::string allowed_text(const OptionSpec& spec) {
  switch (spec.kind) {
    case OptionKind::kSwitch:
      return "it must be true or false";
    case OptionKind::kChoice:
      return one_of(std::vector<std::string>(spec.choices.begin(), spec.choices.end())) +
             (spec.open == OpenChoice::kNone ? "" : ", or a custom one");
    case OptionKind::kNumber:
      break;
  }
  return "it must be a number from " + text(spec.min) + " to " + text(spec.max) +
         (spec.unit.empty() ? "" : " " + std::string(spec.unit));
}

std::vector<std::string> choices_with(const OptionSpec& spec, const Materials& materials) {
  std::vector<std::string> choices(spec.choices.begin(), spec.choices.end());
  const auto add = [&choices](const std::string& id) {
    if (std::find(choices.begin(), choices.end(), id) == choices.end()) choices.push_back(id);
  };
  if (spec.open == OpenChoice::kSurfaces) {
    for (const SurfaceMaterial& surface : materials.surfaces()) add(surface.id);
  }
  if (spec.open == OpenChoice::kMedia) {
    for (const Medium& medium : materials.media()) {
      if (medium.draws) add(medium.id);
    }
  }
  return choices;
}

Result<void> check_choice(const OptionSpec& spec, const OptionValue& value,
                          const Materials& materials) {
  if (spec.open == OpenChoice::kNone) return {};
  const std::string* name = std::get_if<std::string>(&value);
  const std::vector<std::string> known = choices_with(spec, materials);
  if (name && std::find(known.begin(), known.end(), *name) != known.end()) return {};
  return fail(ErrorCode::kInvalidArgument, "option '" + std::string(spec.id) + "' cannot be " +
                                               text(value) + ": " + one_of(known));
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
    names_.push_back(spec.open == OpenChoice::kNone ? std::string()
                                                    : std::get<std::string>(default_value(spec)));
  }
}

Result<std::size_t> OptionValues::find(std::string_view id) const {
  const auto spec = std::find_if(table_.begin(), table_.end(), [&](const OptionSpec& s) {
    return s.id == id || (!s.former_id.empty() && s.former_id == id);
  });
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
  if (table_[*i].open != OpenChoice::kNone) names_[*i] = std::get<std::string>(value);
  return {};
}

Result<OptionValue> OptionValues::get(std::string_view id) const {
  const auto i = find(id);
  if (!i) return tl::unexpected(i.error());
  const OptionSpec& spec = table_[*i];
  OptionValue value = number(*i);
  if (spec.kind == OptionKind::kSwitch) value = is_on(*i);
  if (spec.kind == OptionKind::kChoice) {
    value = spec.open == OpenChoice::kNone ? std::string(spec.choices[choice(*i)]) : names_[*i];
  }
  return value;
}

}  // namespace felt
