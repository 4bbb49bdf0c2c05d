#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/solid/front_paint.h"
#include "felt/solid/solid.h"

namespace felt {

/// The file formats of solids.
enum class SolidFormat : std::uint8_t {
  kStl,  ///< binary STL: triangles only
  kObj,  ///< Wavefront OBJ: a group for each body
  k3mf,  ///< 3MF: an object for each body, with its colour
  kGlb,  ///< binary glTF 2.0: a mesh for each body, with its colour, smooth normals and ink
};

/// Returns the format with this name or file extension, in any case and without a dot.
std::optional<SolidFormat> solid_format_of(std::string_view name) noexcept;

/// Returns a solid as a file. All formats store the coordinates of the solid in mm, rounded to
/// float; the scene of a .glb is scaled by 0.001, because the unit of glTF is the metre. The same
/// solid gives the same bytes. A .glb also has the ink on the fronts, as textures, unless `paint`
/// is null. Fails if there is no body, or too much for the format.
Result<std::string> encode_solid(const Solid& solid, SolidFormat format,
                                 const FrontPaint* paint = nullptr);

/// Returns true if the bodies have paint that this format cannot contain: ink on the fronts
/// (`paint` is not null), or painted lines.
bool loses_paint(const Solid& solid, SolidFormat format, const FrontPaint* paint) noexcept;

/// The encoders of the formats. Sources:
/// <https://www.loc.gov/preservation/digital/formats/fdd/fdd000505.shtml>,
/// <https://github.com/3MFConsortium/spec_core>,
/// <https://www.khronos.org/gltf/>.
Result<std::string> encode_stl(const Solid& solid);
Result<std::string> encode_obj(const Solid& solid);
Result<std::string> encode_3mf(const Solid& solid);
Result<std::string> encode_glb(const Solid& solid, const FrontPaint* paint);

}  // namespace felt
