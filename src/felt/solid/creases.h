#pragma once

#include "felt/solid/solid.h"

namespace felt {

/// Returns an edited body for shading: at creases, the two sides get points of their own, so that
/// point_normals() are sharp there. The first points are those of the body, and the copies follow.
/// The result is not closed. A body that has not been edited (border_count) is returned as it is,
/// because its surface is smooth.
///
/// A crease begins at edges whose triangles turn by three times as much as at 90 of 100 edges, but
/// at least by kMinCreaseDeg, and always if by more than kMaxCreaseDeg. Where it would end, it
/// continues along edges that turn by a third of that.
SolidBody split_at_creases(const SolidBody& body);
inline constexpr double kMinCreaseDeg = 25.0, kMaxCreaseDeg = 65.0;

}  // namespace felt
