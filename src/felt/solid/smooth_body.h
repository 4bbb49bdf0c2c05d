#pragma once

#include <span>

#include "felt/base/result.h"
#include "felt/solid/solid.h"

namespace felt {

/// Smooths the surface of a body near a stroke, which is projected on it along `view` (from the eye
/// to the body): within half of `width_mm`, less at the border. Width 0 smooths the whole body.
/// `amount`, 0..1, is how much.
///
/// The surface flows towards its mean curvature: implicit steps with cotangent weights (Desbrun,
/// Meyer, Schröder, Barr, "Implicit fairing of irregular meshes using diffusion and curvature
/// flow", 1999, <https://doi.org/10.1145/311535.311576>), where the weights stay those of the first
/// surface (Kazhdan, Solomon, Ben-Chen 2012, <https://doi.org/10.1111/j.1467-8659.2012.03179.x>).
/// Then the body is scaled, or the smoothed points move along their normals, so that the volume is
/// as before.
///
/// Positions are in the frame of the body, in mm. The result has the same triangles and is closed
/// (check_body()). Fails if the stroke does not touch the body, or if the surface would fold.
Result<SolidBody> smooth_body(const SolidBody& body, std::span<const Vec3> path, const Vec3& view,
                              double width_mm, double amount);

}  // namespace felt
