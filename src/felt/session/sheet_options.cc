#include "felt/session/sheet_options.h"

#include <array>
#include <vector>

#include "felt/stroke/color_text.h"

namespace felt {
namespace {

std::vector<std::string_view> material_ids() {
  std::vector<std::string_view> ids;
  for (const SurfaceMaterial& material : surface_materials()) ids.push_back(material.id);
  return ids;
}

}  // namespace

std::span<const OptionSpec> SheetOptions::table() {
  static const std::vector<std::string_view> materials = material_ids();
  static const std::array<OptionSpec, 1> rows = {{{
      .id = "material",
      .label = "Surface",
      .unit = "",
      .kind = OptionKind::kChoice,
      .choices = materials,
      .help = "Surface to draw on. Sets hardness, friction and grain.",
      .open = OpenChoice::kSheets,
  }}};
  return rows;
}

Result<void> SheetOptions::set(std::string_view id, const OptionValue& value,
                               const Materials& known) {
  if (id != "color") {
    if (id == "material") {
      if (Result<void> is_one = check_choice(table()[0], value, known); !is_one) return is_one;
    }
    Result<void> set = values_.set(id, value);
    if (set) follow(known);
    return set;
  }
  const auto* text = std::get_if<std::string>(&value);
  const std::optional<Rgba> color = text ? color_from_text(*text) : std::nullopt;
  if (!color) {
    return fail(ErrorCode::kInvalidArgument,
                "color: " + (text ? "\"" + *text + "\"" : "a number or switch") +
                    " is not #rrggbb or #rrggbbaa");
  }
  color_ = *color;
  return {};
}

Result<OptionValue> SheetOptions::get(std::string_view id) const {
  if (id == "color") return OptionValue(color_to_text(color_));
  return values_.get(id);
}

void SheetOptions::follow(const Materials& known) {
  if (const SurfaceMaterial* sheet = known.find_surface(values_.open_choice(0))) material_ = *sheet;
}

}  // namespace felt
