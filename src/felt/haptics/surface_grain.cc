#include <vector>

#include "felt/haptics/drawing_feel.h"

namespace felt {
namespace {

std::vector<HeightField> make_all() {
  std::vector<HeightField> fields;
  std::uint32_t seed = 1;
  for (const SurfaceMaterial& surface : surface_materials()) {
    fields.emplace_back(HeightFieldSpec{
        .wavelength_mm = surface.grain_mm, .rms_um = surface.grain_um, .seed = seed++});
  }
  return fields;
}

}  // namespace

const HeightField* surface_grain(const SurfaceMaterial& surface) {
  static const std::vector<HeightField> fields = make_all();
  const SurfaceMaterial* known = find_surface(surface.id);
  if (known == nullptr || !(known->grain_um > 0.0)) return nullptr;
  return &fields[static_cast<std::size_t>(known - surface_materials().data())];
}

}  // namespace felt
