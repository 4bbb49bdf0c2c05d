#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/geometry/affine.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Marks on the control points of a stroke: one byte for each of StrokeData::points, 1 = selected
/// (Selection::Marks). Pure functions (specification 5e; R31-R34).
///
/// A joint's *arms* are the points that give its two tangents: its handles as a rule; where a
/// handle stands on the joint, the next point that does not (the reading of I2).

/// Widths are not scaled beyond this, the broadest line of the pencil, unless they were broader.
inline constexpr double kMostScaledWidthMm = 50.0;

/// True if every point is marked.
inline bool all_marked(std::span<const std::uint8_t> marks) noexcept {
  return std::find(marks.begin(), marks.end(), 0) == marks.end();
}

/// Completes marks so that a similarity, or any invertible affine map, of the marked points can
/// keep G1 (R32). The least set with the marks given such that
///  - the two mentions of a closed stroke's seam agree;
///  - a marked smooth joint has both its handles marked, up to its arms;
///  - at an unmarked smooth joint at most one arm is marked, and the handle across is free to turn:
///    where it is not (both are marked, or it stands on the joint, or another smooth joint leans on
///    it) the joint is marked as well.
/// Corners and ends: handles as they are. Linear but for strokes made of standing handles.
void close_marks(const Stroke& stroke, std::span<std::uint8_t> marks);

/// The stroke with its marked points mapped. A marked handle at an unmarked smooth joint turns the
/// unmarked handle across, which keeps its length, so that the joint stays smooth. Unmarked joints
/// and every handle that does not turn stay bit for bit. A map and then its inverse, with the same
/// marks, restore the points within 1e-9 mm (R33).
///
/// `width_factor` multiplies the widths where the joints on both sides are marked, and fades over
/// the segments of which one joint is; widths stay within kMinWidthMm and kMostScaledWidthMm.
///
/// Requires closed marks. Error: kInvalidArgument for another number of marks than of points;
/// kInvalidData when the map makes a segment shorter than I5 allows, or is not finite.
Result<Stroke> with_marked_moved(const Stroke& stroke, std::span<const std::uint8_t> marks,
                                 const Affine& map, double width_factor = 1.0);

/// Anchors of a partly selected stroke (R34): for each maximal run of marked points, taken linearly
/// or round a closed stroke, the first unmarked *on-curve* point each way; none past an open end,
/// none when all are marked. One that is reached from two runs, or from both ends of one, is there
/// twice. Indices of points, the seam as 0, in no order that means anything.
std::vector<std::size_t> anchors(const Stroke& stroke, std::span<const std::uint8_t> marks);

}  // namespace felt
