#pragma once

#include <span>

#include "felt/geometry/cubic.h"
#include "felt/render/tip_strips.h"

namespace felt {

/// Returns about how many widths of the line a segment is long. `px` is the segment in pixels, and
/// the radii are those at its ends. The width includes the rim of the tip, so the result is finite
/// for hairlines. It depends only on the segment, so that TipAt::travel is the same in any tile.
double segment_travel(const Cubic& px, double radius0_px, double radius1_px) noexcept;

/// Sets TipAt::travel of the dabs of one segment, from `start` at the first dab to `start` +
/// `travel` at the last one.
void set_travel(std::span<TipAt> dabs, double start, double travel) noexcept;

}  // namespace felt
