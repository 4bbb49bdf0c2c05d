/// Reads any bytes as the text of a material. The reader must not crash. The values of an accepted
/// material must be in the ranges of their fields and be unchanged after writing and reading it.

#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/check.h"
#include "felt/material/material_fields.h"
#include "felt/material/material_file.h"

namespace felt {
namespace {

template <class Material, class Field>
void check_figures(const Material& material, std::span<const Field> fields) {
  for (const Field& field : fields) {
    const double value = field.get(material);
    FELT_CHECK(field.allows(value) || value == field.fallback());
  }
}

void check(const SurfaceMaterial& surface) {
  check_figures(surface, surface_fields());
  FELT_CHECK(!(surface.grain_um > 0.0) || surface.grain_mm > 0.0);
}

void check(const Medium& medium) {
  check_figures(medium, medium_fields());
  FELT_CHECK(medium.pairs.size() <= kMaxPairs && medium.line.min_mm <= medium.line.max_mm);
  const Result<StyleShape> shape = read_style_shape(medium.style.shape);
  FELT_CHECK(shape.has_value() && !shape->contours.empty());
  for (const std::vector<Point>& contour : shape->contours) {
    FELT_CHECK(contour.size() >= 4 && contour.size() % 3 == 1 && contour.front() == contour.back());
  }
  for (const PairFriction& pair : medium.pairs) {
    FELT_CHECK(is_material_id(pair.surface));
    FELT_CHECK(pair.coefficient >= 0.0 && pair.coefficient <= kMaxFriction);
  }
}

}  // namespace
}  // namespace felt

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace felt;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Result<AnyMaterial> material = read_material(text);
  const std::vector<Error> problems = material_problems(text);
  FELT_CHECK(material.has_value() == problems.empty());
  for (const Error& error : problems) FELT_CHECK(error.message.starts_with("material:"));
  if (!material) return 0;
  FELT_CHECK(is_material_id(id_of(*material)) && !label_of(*material).empty());
  std::visit([](const auto& one) { check(one); }, *material);
  const Result<AnyMaterial> again = read_material(write_material(*material));
  FELT_CHECK(again.has_value());
  FELT_CHECK(*again == *material);
  return 0;
}
