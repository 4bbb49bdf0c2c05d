#include <array>
#include <type_traits>

#include "felt/material/custom_relief.h"
#include "felt/material/material_fields.h"
#include "felt/material/material_file.h"
#include "felt/material/number_text.h"

namespace felt {
namespace {

constexpr std::string_view kHex = "0123456789abcdef";

/// Returns the text as a basic string of TOML.
std::string toml_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20 || byte == 0x7F) {
      out += "\\u00";
      out += kHex[byte >> 4];
      out += kHex[byte & 15];
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string color_text(double rgb) {
  auto bits = static_cast<std::uint32_t>(rgb);
  std::string out = "\"#";
  for (int shift = 20; shift >= 0; shift -= 4) out += kHex[bits >> shift & 15];
  return out + '"';
}

template <class Field>
std::string value_text(const Field& field, double value) {
  switch (field.kind) {
    case MaterialFieldKind::kSwitch:
      return value != 0.0 ? "true" : "false";
    case MaterialFieldKind::kColor:
      return color_text(value);
    case MaterialFieldKind::kChoice:
      return toml_text(field.choices[static_cast<std::size_t>(value)]);
    case MaterialFieldKind::kNumber:
    case MaterialFieldKind::kWhole:
      break;
  }
  return number_text(value);
}

std::string comment(const std::string& allowed, std::string_view help) {
  return "  # " + allowed + ". " + std::string(help) + "\n";
}

constexpr std::string_view kStyleTable = "style";

/// Returns true for the fields of a style that is the default, which are left out, so that versions
/// of Feltline without styles can read the text.
template <class Material>
bool is_left_out(const Material& material, std::string_view field) {
  if constexpr (std::is_same_v<Material, Medium>) {
    return material.style == MediumStyle{} && field.starts_with("style.");
  } else {
    return false;
  }
}

/// Appends all fields in their order. `after` appends the other entries of a table.
template <class Material, class Field, class After>
void append_figures(std::string& out, const Material& material, std::span<const Field> fields,
                    const After& after) {
  std::string_view table;
  for (const Field& field : fields) {
    if (is_left_out(material, field.id)) continue;
    const std::size_t dot = field.id.find('.');
    const std::string_view in = dot == std::string_view::npos ? "" : field.id.substr(0, dot);
    if (in != table) {
      after(table);
      table = in;
      out += "\n[" + std::string(table) + "]\n";
    }
    const double value = field.get(material);
    // If a value means "none", its line is commented out.
    const bool is_none = !field.allows(value) && value == field.fallback();
    out += (is_none ? "# " : "") + std::string(field.id.substr(dot + 1)) + " = " +
           value_text(field, is_none ? field.min : value) +
           comment(allowed_text(field), field.help);
  }
  after(table);
}

std::string head(std::string_view kind, const std::string& id, const std::string& label) {
  return "# A " + std::string(kind) + " for Feltline: how it feels, looks and sounds.\nkind = \"" +
         std::string(kind) + "\"\nid = " + toml_text(id) +
         "  # its name in drawings and recordings\nlabel = " + toml_text(label) + "\n";
}

}  // namespace

std::string write_material(const SurfaceMaterial& surface) {
  std::string out = head("surface", surface.id, surface.label);
  append_figures(out, surface, surface_fields(), [&](std::string_view table) {
    if (table != "grain" || !surface.picture) return;
    out += "# A custom relief: 128 x 128 heights.\nheights = \"\"\"\n" +
           custom_relief_text(*surface.picture) + "\"\"\"\n";
  });
  return out;
}

std::string write_material(const Medium& medium) {
  std::string out = head("medium", medium.id, medium.label);
  append_figures(out, medium, medium_fields(), [&](std::string_view table) {
    if (table == kStyleTable) {
      out += "shape = " + toml_text(medium.style.shape) +
             "  # path data: x 0 to 1 along one repeat, y -0.5 to 0.5 across the line.\n";
    }
    if (table != "feel" || medium.pairs.empty()) return;
    out +=
        "\n[pairs]  # friction on a surface, by its id: 0 to " + number_text(kMaxFriction) + "\n";
    for (const PairFriction& pair : medium.pairs) {
      out += (is_material_id(pair.surface) ? pair.surface : toml_text(pair.surface)) + " = " +
             number_text(pair.coefficient) + "\n";
    }
  });
  return out;
}

std::string write_material(const AnyMaterial& material) {
  return std::visit([](const auto& one) { return write_material(one); }, material);
}

}  // namespace felt
