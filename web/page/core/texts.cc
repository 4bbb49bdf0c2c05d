#include "web/page/core/texts.h"

#include <array>
#include <cmath>

#include "felt/document/fill.h"
#include "felt/document/history.h"
#include "felt/formats/format_traits.h"
#include "felt/io/ndjson/json_text.h"
#include "felt/session/session_medium.h"
#include "felt/stroke/color_text.h"

namespace felt::page {
namespace {

constexpr std::array kToolKinds = {"draws", "shapes",     "edits", "erases", "selects",
                                   "fills", "transforms", "reads", "guides"};

std::string color_of(std::uint32_t rgb) {
  return color_to_text({static_cast<std::uint8_t>(rgb >> 16U), static_cast<std::uint8_t>(rgb >> 8U),
                        static_cast<std::uint8_t>(rgb), 255});
}

std::string value_text(const OptionValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return json_number(*number);
  if (const auto* is_on = std::get_if<bool>(&value)) return *is_on ? "true" : "false";
  return json_string(std::get<std::string>(value));
}

std::string texts_of(std::span<const std::string_view> texts) {
  std::vector<std::string> quoted;
  for (const std::string_view text : texts) quoted.push_back(json_string(text));
  return json_array(quoted);
}

/// Returns the condition of a row: the id of an option, and its values.
std::string when_text(std::string_view tool, std::string_view when) {
  const std::size_t equals = when.find('=');
  if (equals == std::string_view::npos) return "null";
  std::vector<std::string> values;
  for (std::string_view rest = when.substr(equals + 1);;) {
    const std::size_t bar = rest.find('|');
    values.push_back(json_string(rest.substr(0, bar)));
    if (bar == std::string_view::npos) break;
    rest.remove_prefix(bar + 1);
  }
  JsonObject out;
  out.add_text("id", std::string(tool) + "." + std::string(when.substr(0, equals)));
  out.add_raw("values", json_array(values));
  return out.text();
}

std::string option_row(std::string_view tool, const OptionSpec& row) {
  JsonObject out;
  out.add_text("id", std::string(tool) + "." + std::string(row.id));
  out.add_text("label", row.label);
  out.add_text("unit", row.unit);
  out.add_text("kind", row.kind == OptionKind::kNumber   ? "number"
                       : row.kind == OptionKind::kSwitch ? "switch"
                                                         : "choice");
  out.add_number("min", row.min);
  out.add_number("max", row.max);
  out.add_raw("fallback", value_text(default_value(row)));
  out.add_raw("choices", texts_of(row.choices));
  out.add_text("open", row.open == OpenChoice::kSurfaces ? "surfaces"
                       : row.open == OpenChoice::kMedia  ? "media"
                                                         : "");
  out.add_text("help", row.help);
  out.add_raw("when", when_text(tool, row.when));
  out.add_bool("isSeldom", row.is_seldom);
  return out.text();
}

std::string tool_row(const ToolInfo& info) {
  JsonObject out;
  out.add_text("id", info.id);
  out.add_text("label", info.label);
  out.add_text("help", info.help);
  out.add_text("shortcut", info.shortcut ? std::string(1, info.shortcut) : std::string());
  out.add_text("kind", kToolKinds[static_cast<std::size_t>(info.kind)]);
  std::vector<std::string> rows;
  for (const OptionSpec& row : info.options) rows.push_back(option_row(info.id, row));
  out.add_raw("options", json_array(rows));
  return out.text();
}

template <class Material>
std::string material_rows(std::span<const Material> materials) {
  std::vector<std::string> rows;
  for (const Material& material : materials) {
    if constexpr (std::is_same_v<Material, Medium>) {
      if (!material.draws) continue;
    }
    JsonObject row;
    row.add_text("id", material.id);
    row.add_text("label", material.label);
    row.add_text("color", color_of(material.color_rgb));
    rows.push_back(row.text());
  }
  return json_array(rows);
}

std::string format_rows() {
  std::vector<std::string> rows;
  for (const FormatTraits& traits : format_table()) {
    const bool is_here = traits.format == FileFormat::kFelt || traits.format == FileFormat::kSvg ||
                         traits.format == FileFormat::kNdjson ||
                         traits.format == FileFormat::kInkml;
    if (!is_here && traits.format != FileFormat::kXopp) continue;
    JsonObject row;
    row.add_text("id", traits.name);
    row.add_text("extension", traits.endings.front());
    row.add_text("label", traits.title);
    row.add_bool("opens", traits.reads);
    row.add_bool("saves", is_here);
    rows.push_back(row.text());
  }
  return json_array(rows);
}

std::string layer_rows(const Session& session) {
  std::vector<std::string> rows;
  const std::span<const Layer> layers = session.document().layers();
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
    JsonObject row;
    row.add_number("id", static_cast<double>(layer->id.value));
    row.add_text("name", layer->name);
    row.add_bool("visible", layer->own_visible);
    row.add_bool("locked", layer->own_locked);
    row.add_number("opacity", layer->opacity);
    row.add_text("blend", blend_mode_name(layer->blend));
    row.add_number("group", layer->group ? static_cast<double>(layer->group->id.value) : 0.0);
    row.add_number("strokes", static_cast<double>(layer->strokes.size() + layer->fills.size()));
    row.add_bool("picture", layer->picture != nullptr);
    row.add_bool("current", layer->id == session.layer());
    rows.push_back(row.text());
  }
  return json_array(rows);
}

/// Returns the groups of layers, the highest first.
std::string group_rows(const Session& session) {
  std::vector<std::string> rows;
  const std::span<const Layer> layers = session.document().layers();
  for (std::size_t i = layers.size(); i-- > 0;) {
    const LayerGroupPtr& group = layers[i].group;
    if (!group || (i + 1 < layers.size() && same_group(group, layers[i + 1].group))) continue;
    JsonObject row;
    row.add_number("id", static_cast<double>(group->id.value));
    row.add_text("name", group->name);
    row.add_bool("visible", group->visible);
    row.add_bool("locked", group->locked);
    row.add_number("opacity", group->opacity);
    row.add_text("blend", blend_mode_name(group->blend));
    rows.push_back(row.text());
  }
  return json_array(rows);
}

std::string offer_rows(const Session& session) {
  std::vector<std::string> rows;
  const std::optional<OfferView> offer = session.offered();
  for (std::size_t i = 0; offer && i < offer->rows.size(); ++i) {
    JsonObject row;
    row.add_text("id", kOfferKinds[static_cast<std::size_t>(offer->rows[i].kind)]);
    row.add_number("count", static_cast<double>(offer->rows[i].count));
    row.add_bool("applies", i == offer->chosen);
    rows.push_back(row.text());
  }
  return json_array(rows);
}

std::string size_text(const Tool& tool) {
  const std::optional<ToolSize> size = tool.size();
  if (!size) return "null";
  JsonObject out;
  out.add_number("mm", size->mm);
  out.add_number("min", size->min_mm);
  out.add_number("max", size->max_mm);
  JsonObject options;
  const std::string prefix = std::string(tool.info().id) + ".";
  for (const auto& [id, value] : tool.options_for_size(size->mm)) {
    options.add_number(prefix + std::string(id), value);
  }
  out.add_raw("options", options.text());
  return out.text();
}

std::string use_text(const Tool& tool) {
  const ToolUse use = tool.use();
  JsonObject out;
  out.add_text("hint", use.hint);
  out.add_text("shift", use.first_modifier);
  out.add_text("ctrl", use.second_modifier);
  out.add_text("alt", use.third_modifier);
  return out.text();
}

std::string label_text(bool is_possible, std::string_view label) {
  return is_possible ? json_string(label) : "null";
}

}  // namespace

std::string catalog_text(const Session& session) {
  JsonObject out;
  std::vector<std::string> tools;
  for (const auto& tool : session.tools()) tools.push_back(tool_row(tool->info()));
  out.add_raw("tools", json_array(tools));
  out.add_raw("surfaces", material_rows(session.materials().surfaces()));
  out.add_raw("media", material_rows(session.materials().media()));
  out.add_raw("formats", format_rows());
  return out.text();
}

std::string option_text(const Session& session, const std::string& id) {
  const Result<OptionValue> value = session.option(id);
  return value ? value_text(*value) : "null";
}

std::string state_text(const Studio& studio) {
  const Session& session = studio.session();
  const Tool& tool = session.tool();
  JsonObject out;
  out.add_text("tool", tool.info().id);
  out.add_raw("use", use_text(tool));
  out.add_raw("size", size_text(tool));
  JsonObject options;
  for (const OptionSpec& row : tool.info().options) {
    const Result<OptionValue> value = tool.option(row.id);
    const std::string id = std::string(tool.info().id) + "." + std::string(row.id);
    if (value) options.add_raw(id, value_text(*value));
  }
  out.add_raw("options", options.text());
  out.add_text("surface", session.surface().id);
  out.add_text("medium", drawing_medium(session));
  out.add_text("ink", color_to_text(session.ink_color()));
  out.add_text("paper", color_to_text(studio.page().paper));
  JsonObject page;
  page.add_number("width", studio.page().width_mm);
  page.add_number("height", studio.page().height_mm);
  out.add_raw("page", page.text());
  out.add_raw("layers", layer_rows(session));
  out.add_raw("groups", group_rows(session));
  out.add_number("inkLayers", static_cast<double>(session.layers_added_for_ink()));
  const History& history = session.history();
  out.add_raw("undo", label_text(history.can_undo(), history.undo_label()));
  out.add_raw("redo", label_text(history.can_redo(), history.redo_label()));
  out.add_number("position", static_cast<double>(history.position()));
  out.add_number("strokes", static_cast<double>(session.document().stroke_count()));
  out.add_number("selected", static_cast<double>(session.selection().strokes().size()));
  out.add_raw("offers", offer_rows(session));
  out.add_bool("canShowAsDrawn", session.can_show_as_drawn());
  out.add_bool("exact", session.exact_offer() != nullptr);
  out.add_text("device", studio.device());
  out.add_bool("forces", studio.forces());
  out.add_number("strength", studio.strength());
  out.add_bool("gesture", session.gesture_in_progress());
  return out.text();
}

std::string done_text(const Result<void>& done, const std::vector<std::string>& notices) {
  JsonObject out;
  out.add_bool("ok", done.has_value());
  if (!done) {
    out.add_text("error", done.error().message);
    out.add_number("code", static_cast<double>(done.error().code));
  }
  std::vector<std::string> quoted;
  for (const std::string& notice : notices) quoted.push_back(json_string(notice));
  if (!quoted.empty()) out.add_raw("notices", json_array(quoted));
  return out.text();
}

}  // namespace felt::page
