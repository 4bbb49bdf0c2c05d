#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "felt/geometry/affine.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Marks on the control points of a stroke: one byte for each of StrokeData::points, 1 = selected
/// (Selection::Marks). Pure functions (specification 5e; R31-R34).

/// Completes marks so that a similarity of the marked points keeps G1 (R32): a selected smooth
/// joint selects both its handles; the joint of a closed stroke's seam counts once, its two
/// mentions agree. Corners and ends: handles as they are. What a marked handle at an unmarked
/// smooth joint does to the handle across is with_marked_moved's.
void close_marks(const Stroke& stroke, std::span<std::uint8_t> marks);

/// The stroke with its marked points mapped. A marked handle at an unmarked smooth joint turns the
/// unmarked handle across, which keeps its length, so that the joint stays smooth. Unmarked joints
/// stay bit for bit. `width_factor` multiplies the widths where the joints on both sides are
/// marked. Requires closed marks. Error: the map makes a segment shorter than I5, or not finite.
Result<Stroke> with_marked_moved(const Stroke& stroke, std::span<const std::uint8_t> marks,
                                 const Affine& map, double width_factor = 1.0);

/// Anchors of a partly selected stroke (R34): for each maximal run of marked points, taken linearly
/// or round a closed stroke, the first unmarked *on-curve* point each way; none past an open end,
/// none when all are marked. One that is reached from two runs is there twice. Indices of points.
std::vector<std::size_t> anchors(const Stroke& stroke, std::span<const std::uint8_t> marks);

}  // namespace felt
