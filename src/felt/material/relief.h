#pragma once

#include "felt/geometry/height_field.h"
#include "felt/material/materials.h"

namespace felt {

/// Returns the relief of a surface, or null if the surface is smooth. Force, display and sound get
/// the same object (R47). The first call for a relief takes 20 to 60 ms. The relief is kept until
/// the program ends, so that a force model may point to it. If two reliefs differ only in height or
/// wavelength, the second one is scaled from the first, which takes little time. Call on any thread
/// except the haptic thread.
const HeightField* surface_grain(const SurfaceMaterial& surface);

}  // namespace felt
