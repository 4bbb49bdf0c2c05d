#include "felt/io/drawing_styles.h"

#include <string>
#include <utility>

#include "felt/material/material_file.h"

namespace felt {

StrokeStyles styles_of(const Drawing& drawing) {
  if (drawing.materials.empty()) return {};
  Materials known = Materials::built_in();
  for (const std::string& text : drawing.materials) {
    if (Result<AnyMaterial> material = read_material(text)) put(known, *std::move(material));
  }
  return StrokeStyles(known);
}

}  // namespace felt
