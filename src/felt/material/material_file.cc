#include "felt/material/material_file.h"

#include <utility>

namespace felt {

bool is_material_id(std::string_view id) noexcept {
  return !id.empty() && id.size() <= kMaxMaterialIdChars &&
         id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string_view::npos;
}

const std::string& id_of(const AnyMaterial& material) noexcept {
  const auto* surface = std::get_if<SurfaceMaterial>(&material);
  return surface ? surface->id : std::get_if<Medium>(&material)->id;
}

const std::string& label_of(const AnyMaterial& material) noexcept {
  const auto* surface = std::get_if<SurfaceMaterial>(&material);
  return surface ? surface->label : std::get_if<Medium>(&material)->label;
}

std::string_view kind_of(const AnyMaterial& material) noexcept {
  return std::holds_alternative<SurfaceMaterial>(material) ? "surface" : "medium";
}

std::string label_of_id(std::string_view id) {
  std::string label(id);
  for (char& c : label) {
    if (c == '-') c = ' ';
  }
  if (!label.empty() && label[0] >= 'a' && label[0] <= 'z') {
    label[0] = static_cast<char>(label[0] - 'a' + 'A');
  }
  return label;
}

std::string material_key(const AnyMaterial& material) {
  return std::string(kind_of(material)) + " " + id_of(material);
}

void put(Materials& materials, AnyMaterial material) {
  if (auto* surface = std::get_if<SurfaceMaterial>(&material)) materials.put(std::move(*surface));
  if (auto* medium = std::get_if<Medium>(&material)) materials.put(std::move(*medium));
}

std::vector<AnyMaterial> not_built_in(const Materials& materials) {
  const Materials& known = Materials::built_in();
  std::vector<AnyMaterial> own;
  for (const SurfaceMaterial& surface : materials.surfaces()) {
    const SurfaceMaterial* same = known.find_surface(surface.id);
    if (!same || !(*same == surface)) own.emplace_back(surface);
  }
  for (const Medium& medium : materials.media()) {
    const Medium* same = known.find_medium(medium.id);
    if (!same || !(*same == medium)) own.emplace_back(medium);
  }
  return own;
}

std::string material_error(const AnyMaterial& material) {
  const std::vector<Error> problems = material_problems(write_material(material), {});
  return problems.empty() ? "" : problems.front().message;
}

}  // namespace felt
