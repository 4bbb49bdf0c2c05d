#include "felt/formats/drawing_materials.h"

#include <algorithm>
#include <set>
#include <utility>

#include "felt/io/xml/material_texts.h"
#include "felt/material/material_file.h"

namespace felt {

std::vector<std::string> texts_of_used(const Document& document, std::string_view surface,
                                       const Materials& known, std::span<const std::string> also) {
  const std::vector<AnyMaterial> own = not_built_in(known);
  if (own.empty()) return {};
  std::set<std::string, std::less<>> media(also.begin(), also.end());
  for (const Layer& layer : document.layers()) {
    for (const StrokeId id : layer.strokes) media.insert(document.find(id)->medium());
  }
  std::vector<std::string> texts;
  for (const AnyMaterial& material : own) {
    const bool is_surface = std::holds_alternative<SurfaceMaterial>(material);
    const std::string& id = id_of(material);
    const bool is_used = is_surface ? id == surface : media.contains(id);
    if (is_used && material_error(material).empty()) {
      add_material_text(texts, write_material(material));
    }
  }
  return texts;
}

Materials with_texts(std::span<const std::string> texts, Materials known) {
  for (const std::string& text : texts) {
    if (Result<AnyMaterial> material = read_material(text)) put(known, *std::move(material));
  }
  return known;
}

void drop_bad_texts(std::vector<std::string>& texts, ImportReport& report) {
  std::size_t number = 0;
  const auto is_bad = [&](const std::string& text) {
    const Result<AnyMaterial> material =
        read_material(text, {.name = "material " + std::to_string(++number)});
    if (material) return false;
    report.add(0, {}, material.error().message + "; it was skipped, and its ink looks like pencil");
    return true;
  };
  std::vector<std::string> good;
  for (std::string& text : texts) {
    if (!is_bad(text)) good.push_back(std::move(text));
  }
  texts = std::move(good);
}

}  // namespace felt
