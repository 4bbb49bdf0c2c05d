#include "desktop/engine/presets.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <optional>

#include "desktop/engine/settings.h"
#include "desktop/engine/text_of.h"

namespace felt::desktop {
namespace {

QJsonValue json_of(const OptionValue& value) {
  if (const auto* on = std::get_if<bool>(&value)) return *on;
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return text_of(std::get<std::string>(value));
}

std::optional<OptionValue> option_of(const QJsonValue& value) {
  if (value.isBool()) return OptionValue(value.toBool());
  if (value.isDouble()) return OptionValue(value.toDouble());
  if (value.isString()) return OptionValue(value.toString().toStdString());
  return std::nullopt;
}

void store_presets(const std::vector<Preset>& presets) {
  QJsonArray all;
  for (const Preset& preset : presets) {
    QJsonObject options;
    for (const SetOption& option : preset.options) {
      options[text_of(option.id)] = json_of(option.value);
    }
    all.append(
        QJsonObject{{QStringLiteral("name"), preset.name}, {QStringLiteral("options"), options}});
  }
  Settings::the().set(QLatin1String(kPresets),
                      QString::fromUtf8(QJsonDocument(all).toJson(QJsonDocument::Compact)));
}

/// Returns the options of the tool that draws, except those for a few gestures and those of the
/// steady hand, which belong to the user and not to a pen, and the colour.
std::vector<SetOption> present_options(const Session& session) {
  std::vector<SetOption> options;
  const auto add = [&](const std::string& id) {
    if (Result<OptionValue> value = session.option(id)) options.push_back({id, *std::move(value)});
  };
  if (const Tool* draws = session.first_tool(ToolKind::kDraws)) {
    for (const OptionSpec& row : draws->info().options) {
      if (row.id.starts_with("steady")) continue;
      if (!row.is_momentary) add(std::string(draws->info().id) + "." + std::string(row.id));
    }
  }
  add(kInkColorId);
  return options;
}

}  // namespace

std::vector<Preset> stored_presets() {
  std::vector<Preset> presets;
  const QString text = Settings::the().text(QLatin1String(kPresets));
  const QJsonArray all = QJsonDocument::fromJson(text.toUtf8()).array();
  for (const QJsonValue& entry : all) {
    Preset preset{entry[QStringLiteral("name")].toString(), {}};
    const QJsonObject options = entry[QStringLiteral("options")].toObject();
    for (auto option = options.begin(); option != options.end(); ++option) {
      if (auto value = option_of(option.value())) {
        preset.options.push_back({option.key().toStdString(), *std::move(value)});
      }
    }
    const bool is_usable = !preset.name.trimmed().isEmpty() && !preset.options.empty();
    if (is_usable && presets.size() < kMaxPresets) presets.push_back(std::move(preset));
  }
  return presets;
}

void keep_preset(const Session& session, const QString& name) {
  const QString wanted = name.simplified();
  if (wanted.isEmpty()) return;
  std::vector<Preset> presets = stored_presets();
  const auto same = std::find_if(presets.begin(), presets.end(),
                                 [&](const Preset& preset) { return preset.name == wanted; });
  if (same != presets.end()) {
    same->options = present_options(session);
  } else if (presets.size() < kMaxPresets) {
    presets.push_back({wanted, present_options(session)});
  }
  store_presets(presets);
}

void remove_preset(const QString& name) {
  std::vector<Preset> presets = stored_presets();
  std::erase_if(presets, [&](const Preset& preset) { return preset.name == name; });
  store_presets(presets);
}

void use_preset(Studio& studio, const Preset& preset) {
  const Session& session = studio.session();
  for (const SetOption& option : preset.options) {
    const Result<OptionValue> now = session.option(option.id);
    if (!now || *now != option.value) studio.apply(option);
  }
  const ToolKind kind = session.tool().info().kind;
  const Tool* draws = session.first_tool(ToolKind::kDraws);
  if (draws && kind != ToolKind::kDraws && kind != ToolKind::kShapes) {
    studio.apply(SelectTool{std::string(draws->info().id)});
  }
}

}  // namespace felt::desktop
