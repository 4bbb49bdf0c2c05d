#pragma once

#include "felt/base/result.h"
#include "felt/solid/fine_surface.h"
#include "felt/solid/plane_mesh.h"
#include "felt/solid/solid.h"

namespace felt {

/// Returns (cos, sin) of an angle, exactly 0 and 1 for multiples of a right angle.
Vec unit_at(double angle_rad) noexcept;

/// Makes a closed surface of the mesh of a sector with the given number of mirror axes (Sector):
/// divides chords, computes the heights, divides the triangles as `spec` says (its number of
/// triangles is that of all sectors), multiplies the heights by `thickness`, mirrors the sector 2
/// `axes` - 1 times and joins the copies along the axes, adds the back, and moves the result so
/// that (0, 0) becomes `centre` and the direction +x becomes `x_axis`.
Result<SolidBody> unfolded(PlaneMesh mesh, int axes, const SurfaceSpec& spec, double thickness,
                           Point centre, Vec x_axis);

}  // namespace felt
