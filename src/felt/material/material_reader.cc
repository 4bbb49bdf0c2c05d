#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "felt/base/utf8.h"
#include "felt/material/custom_relief.h"
#include "felt/material/material_fields.h"
#include "felt/material/material_file.h"
#include "felt/material/number_text.h"
#include "felt/material/toml_entries.h"

namespace felt {
namespace {

constexpr std::size_t kMaxProblems = 20;

/// Keys that were renamed, with their present names. Texts with the old names are still read.
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kFormerKeys = {
    {{"line.lean_width", "line.tilt_width"}, {"line.lean_tone", "line.tilt_tone"}}};
/// The kind of surfaces in older texts, which are still read.
constexpr std::string_view kFormerSurfaceKind = "sheet";

bool is_label(std::string_view text) noexcept {
  return !text.empty() && text.size() <= kMaxMaterialLabelBytes && is_utf8(text) &&
         std::none_of(text.begin(), text.end(), [](char c) {
           return static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) == 0x7F;
         });
}

std::optional<double> color_of(const std::string& text) noexcept {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  double rgb = 0.0;
  for (const char c : std::string_view(text).substr(1)) {
    const int digit = c >= '0' && c <= '9'   ? c - '0'
                      : c >= 'a' && c <= 'f' ? c - 'a' + 10
                      : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                             : -1;
    if (digit < 0) return std::nullopt;
    rgb = 16.0 * rgb + digit;
  }
  return rgb;
}

/// Returns the value of an entry as a number, or nullopt if it has the wrong type or is out of
/// range.
template <class Field>
std::optional<double> value_for(const Field& field, const TomlEntry& entry) {
  std::optional<double> value;
  const auto* text = std::get_if<std::string>(&entry.value);
  switch (field.kind) {
    case MaterialFieldKind::kSwitch:
      if (const auto* on = std::get_if<bool>(&entry.value)) value = *on ? 1.0 : 0.0;
      break;
    case MaterialFieldKind::kColor:
      if (text) value = color_of(*text);
      break;
    case MaterialFieldKind::kChoice: {
      const auto at =
          text ? std::find(field.choices.begin(), field.choices.end(), *text) : field.choices.end();
      if (at != field.choices.end()) value = static_cast<double>(at - field.choices.begin());
      break;
    }
    case MaterialFieldKind::kWhole:
    case MaterialFieldKind::kNumber:
      if (const auto* number = std::get_if<double>(&entry.value)) value = *number;
      break;
  }
  if (value && !field.allows(*value)) value.reset();
  return value;
}

/// Reads entries into a material and collects the problems.
class TextReader {
 public:
  explicit TextReader(const MaterialSource& source) : source_(source) {}

  std::optional<AnyMaterial> material_of(const std::vector<TomlEntry>& entries) {
    const TomlEntry* kind = find(entries, "kind");
    if (!kind) {
      say(1, "kind is missing; it must be \"surface\" or \"medium\"");
      return std::nullopt;
    }
    const auto* word = std::get_if<std::string>(&kind->value);
    if (word && (*word == "surface" || *word == kFormerSurfaceKind)) return surface_of(entries);
    if (word && *word == "medium") return medium_of(entries);
    refuse(*kind, "\"surface\" or \"medium\"");
    return std::nullopt;
  }

  /// Returns the problems in the order of the text.
  std::vector<Error> problems() && {
    std::stable_sort(problems_.begin(), problems_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Error> errors;
    for (auto& [line, error] : problems_) errors.push_back(std::move(error));
    return errors;
  }

 private:
  static const TomlEntry* find(const std::vector<TomlEntry>& entries, std::string_view key) {
    const auto at = std::find_if(entries.begin(), entries.end(),
                                 [&](const TomlEntry& entry) { return entry.key == key; });
    return at == entries.end() ? nullptr : &*at;
  }

  void say(int line, const std::string& what) {
    if (problems_.size() == kMaxProblems) return;
    problems_.push_back({line, {ErrorCode::kInvalidData, toml_place(source_.name, line) + what}});
  }
  void refuse(const TomlEntry& entry, const std::string& allowed) {
    say(entry.line, entry.key + " is " + toml_value_text(entry) + ", it must be " + allowed);
  }

  SurfaceMaterial surface_of(const std::vector<TomlEntry>& entries) {
    SurfaceMaterial surface;
    for (const TomlEntry& entry : entries) {
      if (take_head(entry, surface) || take_figure(entry, surface_fields(), surface)) continue;
      if (entry.key == "grain.heights") {
        take_heights(entry, surface);
      } else if (entry.key == "grain.picture") {
        take_picture(entry, surface);
      } else {
        unknown(entry, "surface", surface_fields(),
                {"kind", "id", "label", "grain.picture", "grain.heights"});
      }
    }
    finish(entries, surface);
    finish_grain(entries, surface);
    return surface;
  }

  Medium medium_of(const std::vector<TomlEntry>& entries) {
    Medium medium;
    for (const TomlEntry& entry : entries) {
      if (take_head(entry, medium) || take_figure(entry, medium_fields(), medium)) continue;
      if (entry.key.starts_with("pairs.")) {
        take_pair(entry, medium);
      } else if (entry.key == kStyleShapeKey) {
        take_shape(entry, medium);
      } else {
        unknown(entry, "medium", medium_fields(),
                {"kind", "id", "label", "pairs.SURFACE", std::string(kStyleShapeKey)});
      }
    }
    finish(entries, medium);
    if (medium.line.max_mm < medium.line.min_mm) {
      const TomlEntry* at = find(entries, "line.max_mm");
      if (!at) at = find(entries, "line.min_mm");
      say(at ? at->line : 1, "line.max_mm is " + number_text(medium.line.max_mm) +
                                 ", it must be at least line.min_mm, " +
                                 number_text(medium.line.min_mm));
    }
    return medium;
  }

  template <class Material>
  bool take_head(const TomlEntry& entry, Material& material) {
    const auto* text = std::get_if<std::string>(&entry.value);
    if (entry.key == "kind") return true;
    if (entry.key == "id") {
      if (text && is_material_id(*text)) {
        material.id = *text;
      } else {
        refuse(entry, "1 to 64 of a-z, 0-9 and -");
      }
      return true;
    }
    if (entry.key != "label") return false;
    if (text && is_label(*text)) {
      material.label = *text;
    } else {
      refuse(entry, "1 to 80 bytes of text in one line");
    }
    return true;
  }

  template <class Field, class Material>
  bool take_figure(const TomlEntry& entry, std::span<const Field> fields, Material& material) {
    const auto field = std::find_if(fields.begin(), fields.end(),
                                    [&](const Field& f) { return f.id == entry.key; });
    if (field == fields.end()) return false;
    if (const std::optional<double> value = value_for(*field, entry)) {
      field->set(material, *value);
    } else {
      refuse(entry, allowed_text(*field));
    }
    return true;
  }

  void take_pair(const TomlEntry& entry, Medium& medium) {
    const std::string surface = entry.key.substr(std::string_view("pairs.").size());
    const auto* number = std::get_if<double>(&entry.value);
    if (!is_material_id(surface)) {
      say(entry.line,
          entry.key + ": the keys of pairs must be ids of surfaces, 1 to 64 of a-z, 0-9 and -");
    } else if (!number || !(*number >= 0.0 && *number <= kMaxFriction)) {
      refuse(entry, "0 to " + number_text(kMaxFriction));
    } else if (medium.pairs.size() == kMaxPairs) {
      say(entry.line, "pairs has more than " + std::to_string(kMaxPairs) + " surfaces");
    } else {
      medium.pairs.push_back({surface, *number});
    }
  }

  void take_shape(const TomlEntry& entry, Medium& medium) {
    const auto* text = std::get_if<std::string>(&entry.value);
    if (!text) return refuse(entry, "path data as text");
    const Result<StyleShape> shape = read_style_shape(*text);
    if (!shape) return say(entry.line, entry.key + ": " + shape.error().message);
    medium.style.shape = *text;
  }

  void take_heights(const TomlEntry& entry, SurfaceMaterial& surface) {
    const auto* text = std::get_if<std::string>(&entry.value);
    if (!text) return refuse(entry, "the heights of a relief as text");
    keep(entry, custom_relief(*text), surface);
  }

  void take_picture(const TomlEntry& entry, SurfaceMaterial& surface) {
    const auto* file = std::get_if<std::string>(&entry.value);
    if (!file || file->empty()) return refuse(entry, "the name of a .png beside this file");
    // Accepts only a file name without a path, so that a text from another user cannot read
    // arbitrary files.
    if (file->find_first_of("/\\") != std::string::npos || *file == ".." || !is_label(*file)) {
      return refuse(entry, "the name of a .png beside this file, without folders");
    }
    if (!source_.load_picture) {
      return say(entry.line,
                 "grain.picture names a file, but files are not read here; use grain.heights "
                 "instead (`feltline materials show` writes them)");
    }
    const Result<HeightPicture> picture = source_.load_picture(*file);
    if (!picture) return say(entry.line, "grain.picture: " + picture.error().message);
    keep(entry, custom_relief(*picture), surface);
  }

  void keep(const TomlEntry& entry, Result<std::shared_ptr<const HeightField>> relief,
            SurfaceMaterial& surface) {
    if (!relief) return say(entry.line, entry.key + " " + relief.error().message);
    if (surface.picture) {
      return say(entry.line, "grain has both heights and a picture; only one is allowed");
    }
    surface.picture = *std::move(relief);
  }

  template <class Field>
  void unknown(const TomlEntry& entry, std::string_view kind, std::span<const Field> fields,
               std::vector<std::string> known) {
    const auto* other = std::get_if<TomlOther>(&entry.value);
    const bool is_empty_table = other && other->what == kTomlEmptyTable;
    for (const Field& field : fields) known.emplace_back(field.id);
    const std::string in = entry.key.substr(0, entry.key.find('.'));
    std::string there;
    for (const std::string& key : known) {
      if (!key.starts_with(in + ".")) continue;
      there += (there.empty() ? "" : ", ") + key.substr(in.size() + 1);
    }
    if (!there.empty() && entry.key == in && is_empty_table) return;  // an empty [feel] is fine
    if (!there.empty()) {
      return say(entry.line, entry.key + " is unknown; [" + in + "] of a " + std::string(kind) +
                                 " has " + there);
    }
    std::string tables;
    for (const std::string& key : known) {
      const std::string top = key.substr(0, key.find('.'));
      const std::string name = top == key ? top : "[" + top + "]";
      if ((tables + ", ").find(name + ", ") == std::string::npos) {
        tables += (tables.empty() ? "" : ", ") + name;
      }
    }
    say(entry.line, entry.key + " is unknown; a " + std::string(kind) + " has " + tables);
  }

  template <class Material>
  void finish(const std::vector<TomlEntry>& entries, Material& material) {
    if (!find(entries, "id")) say(1, "id is missing; it must be 1 to 64 of a-z, 0-9 and -");
    if (material.label.empty()) material.label = label_of_id(material.id);
  }

  void finish_grain(const std::vector<TomlEntry>& entries, SurfaceMaterial& surface) {
    const TomlEntry* character = find(entries, "grain.character");
    if (surface.picture && !character) surface.grain_character = HeightCharacter::kPicture;
    const bool names_one = find(entries, "grain.heights") || find(entries, "grain.picture");
    if (character && !names_one && surface.grain_character == HeightCharacter::kPicture) {
      say(character->line,
          "grain.character is \"picture\", but grain.picture and grain.heights are missing");
    }
    const TomlEntry* height = find(entries, "grain.height_um");
    if (height && surface.grain_um > 0.0 && !find(entries, "grain.wavelength_mm")) {
      say(height->line, "grain.wavelength_mm is missing; it must be " +
                            allowed_text(*find_surface_field("grain.wavelength_mm")));
    }
  }

  const MaterialSource& source_;
  std::vector<std::pair<int, Error>> problems_;
};

/// If the text has both the old and the present key, the entry keeps the old one, which is reported
/// as unknown.
void rename_former_keys(std::vector<TomlEntry>& entries) {
  for (const auto& [former, present] : kFormerKeys) {
    const auto with = [&entries](std::string_view key) {
      return std::find_if(entries.begin(), entries.end(),
                          [key](const TomlEntry& entry) { return entry.key == key; });
    };
    if (with(present) != entries.end()) continue;
    if (const auto entry = with(former); entry != entries.end()) entry->key = present;
  }
}

std::optional<AnyMaterial> read(std::string_view text, const MaterialSource& source,
                                std::vector<Error>& problems) {
  if (std::optional<Error> error = toml_too_long(text, source.name, kMaxMaterialBytes)) {
    problems.push_back(*std::move(error));
    return std::nullopt;
  }
  Result<std::vector<TomlEntry>> entries = read_toml(text, source.name);
  if (!entries) {
    problems.push_back(entries.error());
    return std::nullopt;
  }
  rename_former_keys(*entries);
  TextReader reading(source);
  std::optional<AnyMaterial> material = reading.material_of(*entries);
  problems = std::move(reading).problems();
  return material;
}

}  // namespace

Result<AnyMaterial> read_material(std::string_view text, const MaterialSource& source) {
  std::vector<Error> problems;
  std::optional<AnyMaterial> material = read(text, source, problems);
  if (!problems.empty()) return tl::unexpected(problems.front());
  return *std::move(material);
}

std::vector<Error> material_problems(std::string_view text, const MaterialSource& source) {
  std::vector<Error> problems;
  read(text, source, problems);
  return problems;
}

}  // namespace felt
