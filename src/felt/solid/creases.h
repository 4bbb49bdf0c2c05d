#pragma once

#include "felt/solid/solid.h"

namespace felt {

/// Returns an edited body for shading: at edges whose triangles turn by more than kCreaseDeg, the
/// two sides get points of their own, so that point_normals() are sharp there. The first points are
/// those of the body, and the copies follow. The result is not closed. A body that has not been
/// edited (border_count) is returned as it is, because its surface is smooth.
SolidBody split_at_creases(const SolidBody& body);
inline constexpr double kCreaseDeg = 65.0;

}  // namespace felt
