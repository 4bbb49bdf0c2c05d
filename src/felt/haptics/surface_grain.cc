#include <mutex>
#include <optional>
#include <vector>

#include "felt/haptics/drawing_feel.h"

namespace felt {
namespace {

/// Made when first asked for, by whichever thread comes first; others wait for it.
struct Relief {
  std::once_flag once;
  std::optional<HeightField> field;
};

}  // namespace

const HeightField* surface_grain(const SurfaceMaterial& surface) {
  static std::vector<Relief> reliefs(surface_materials().size());
  const SurfaceMaterial* known = find_surface(surface.id);
  if (known == nullptr || !(known->grain_um > 0.0)) return nullptr;
  const auto index = static_cast<std::size_t>(known - surface_materials().data());
  Relief& relief = reliefs[index];
  std::call_once(relief.once, [&] {
    relief.field.emplace(HeightFieldSpec{.wavelength_mm = known->grain_mm,
                                         .rms_um = known->grain_um,
                                         .seed = static_cast<std::uint32_t>(index + 1)});
  });
  return &*relief.field;
}

}  // namespace felt
