#pragma once

#include "felt/geometry/height_field.h"
#include "felt/material/materials.h"

namespace felt {

/// Returns the relief of a surface, the same object for force, display and sound (R47); null if the
/// surface is smooth. The first call for a relief takes 20 to 60 ms. The relief is kept until the
/// program ends, so that a force model may point to it. Surfaces that differ only in height or
/// wavelength share a tile, so trying values is cheap. Call on any thread except the haptic one.
const HeightField* surface_grain(const SurfaceMaterial& surface);

}  // namespace felt
