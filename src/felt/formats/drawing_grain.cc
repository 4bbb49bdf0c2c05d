#include "felt/formats/drawing_grain.h"

#include <string>

#include "felt/formats/drawing_materials.h"
#include "felt/material/relief.h"

namespace felt {

Result<Grain> grain_of(const Drawing& drawing, const Materials& here) {
  const Materials known = with_texts(drawing.materials, here);
  const std::string& id = drawing.page.surface;
  const SurfaceMaterial* surface = id.empty() ? &known.surfaces().front() : known.find_surface(id);
  if (surface) return Grain(surface_grain(*surface), known);
  return fail(ErrorCode::kNotFound, "the drawing's surface '" + id + "' is unknown");
}

}  // namespace felt
