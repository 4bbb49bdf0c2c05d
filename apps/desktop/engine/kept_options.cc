#include "desktop/engine/kept_options.h"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "desktop/engine/first_options.h"
#include "desktop/engine/settings.h"
#include "felt/stroke/color_text.h"
#include "felt/tools/tool.h"

namespace felt::desktop {
namespace {

constexpr auto kOptionPrefix = "options/";
constexpr auto kColor = "ink.color", kFormerColor = "sheet.color";

QString option_key(const std::string& id) {
  return QLatin1String(kOptionPrefix) + QString::fromStdString(id);
}

/// Returns nullopt if the stored value has another type or is out of range. This happens if
/// another version stored it or a user edited it.
std::optional<OptionValue> value_of(const QVariant& stored, const OptionSpec& spec,
                                    const Materials& known) {
  if (!stored.isValid()) return {};
  if (spec.kind == OptionKind::kSwitch) return OptionValue(stored.toBool());
  if (spec.kind == OptionKind::kNumber) {
    bool ok = false;
    const double number = stored.toDouble(&ok);
    if (!ok || !std::isfinite(number) || number < spec.min || number > spec.max) return {};
    return OptionValue(number);
  }
  OptionValue choice(stored.toString().toStdString());
  if (!check_choice(spec, choice, known)) return {};
  return choice;
}

QVariant stored_as(const OptionValue& value) {
  if (const auto* on = std::get_if<bool>(&value)) return *on;
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return QString::fromStdString(std::get<std::string>(value));
}

}  // namespace

KeptOptions::KeptOptions(Studio& studio, QObject* parent) : QObject(parent), studio_(studio) {
  restore();
  connect(&studio, &Studio::option_changed, this, &KeptOptions::store);
}

void KeptOptions::restore() {
  const Settings& settings = Settings::the();
  for (const auto& tool : studio_.session().tools()) {
    const std::string owner(tool->info().id);
    for (const OptionSpec& row : tool->info().options) {
      const std::string id = owner + "." + std::string(row.id);
      if (row.is_momentary) continue;
      QVariant stored = settings.value(option_key(id));
      if (!stored.isValid() && !row.former_id.empty())
        stored = settings.value(option_key(owner + "." + std::string(row.former_id)));
      const auto value = value_of(stored, row, studio_.materials());
      if (value && studio_.session().option(id) != *value) studio_.apply(SetOption{id, *value});
    }
  }
  QVariant ink = settings.value(option_key(kColor));
  if (!ink.isValid()) ink = settings.value(option_key(kFormerColor));
  const std::string color = ink.toString().toStdString();
  if (color_from_text(color)) studio_.apply(SetOption{kColor, OptionValue(color)});
}

void KeptOptions::store(const QString& id) {
  const std::string name = id.toStdString();
  const Result<OptionValue> now = studio_.session().option(name);
  if (!now) return;
  Settings& settings = Settings::the();
  if (name == kColor) return settings.set(option_key(name), stored_as(*now));
  for (const auto& tool : studio_.session().tools()) {
    const std::string owner(tool->info().id);
    for (const OptionSpec& row : tool->info().options) {
      if (owner + "." + std::string(row.id) != name) continue;
      if (row.is_momentary) return;
      if (*now == default_value(as_at_first(tool->info().kind, row)))
        return settings.reset(option_key(name));
      return settings.set(option_key(name), stored_as(*now));
    }
  }
}

}  // namespace felt::desktop
