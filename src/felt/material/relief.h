#pragma once

#include "felt/geometry/height_field.h"
#include "felt/material/materials.h"

namespace felt {

/// The relief of a surface: one object for the hand, the eye and the ear (R47). Made when first
/// asked for, 20 to 60 ms, and kept for good, so that a force model may point at it; two surfaces
/// that differ in height or wavelength alone share its tile, so that trying values costs nothing.
/// Null for a smooth one. Any thread but the haptic one.
const HeightField* surface_grain(const SurfaceMaterial& surface);

}  // namespace felt
