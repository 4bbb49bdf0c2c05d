#include "desktop/materials/material_names.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "desktop/feel/material_words.h"

namespace felt::desktop {
namespace {

constexpr int kMaxIdChars = 48;  // leaves space for a number

}  // namespace

MaterialKey key_of(const AnyMaterial& material) {
  return {std::holds_alternative<SurfaceMaterial>(material), id_of(material)};
}

const SurfaceMaterial* surface_in(const Materials& materials, const MaterialKey& key) {
  return key.is_surface ? materials.find_surface(key.id) : nullptr;
}

const Medium* medium_in(const Materials& materials, const MaterialKey& key) {
  return key.is_surface ? nullptr : materials.find_medium(key.id);
}

std::optional<AnyMaterial> find_in(const Materials& materials, const MaterialKey& key) {
  if (const SurfaceMaterial* surface = surface_in(materials, key)) return *surface;
  if (const Medium* medium = medium_in(materials, key)) return *medium;
  return std::nullopt;
}

bool is_built_in(const MaterialKey& key) {
  return find_in(Materials::built_in(), key).has_value();
}

QString name_of(const AnyMaterial& material) {
  const auto* surface = std::get_if<SurfaceMaterial>(&material);
  return surface ? material_label(*surface) : medium_label(std::get<Medium>(material));
}

QString words_of(const AnyMaterial& material) {
  const auto* surface = std::get_if<SurfaceMaterial>(&material);
  return surface ? material_words(*surface) : medium_words(std::get<Medium>(material));
}

std::string id_for(const QString& name, const std::string& fallback,
                   const std::function<bool(const std::string&)>& is_taken) {
  std::string id;
  // Accents are removed: "Bütten" becomes "butten".
  for (const QChar c : name.normalized(QString::NormalizationForm_KD).toLower()) {
    if (c.unicode() < 128 && c.isLetterOrNumber()) {
      id += static_cast<char>(c.unicode());
    } else if (!c.isMark() && !id.empty() && id.back() != '-') {
      id += '-';
    }
    if (id.size() >= kMaxIdChars) break;
  }
  while (!id.empty() && id.back() == '-') id.pop_back();
  if (id.empty()) id = fallback;
  std::string free = id;
  for (int i = 2; is_taken(free); ++i) free = id + "-" + std::to_string(i);
  return free;
}

QString label_for(const QString& name) {
  // Tabs and line ends become spaces; other control characters are removed.
  QString label = name.simplified();
  label.removeIf([](QChar c) { return c.category() == QChar::Other_Control; });
  label = label.simplified();
  while (label.toUtf8().size() > qsizetype(kMaxMaterialLabelBytes)) label.chop(1);
  return label;
}

AnyMaterial renamed(AnyMaterial material, const std::string& id, const QString& name) {
  const QString label = label_for(name);
  std::visit(
      [&](auto& of) {
        of.id = id;
        of.label = label.isEmpty() ? label_of_id(id) : label.toStdString();
      },
      material);
  return material;
}

}  // namespace felt::desktop
