#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/geometry/affine.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Marks on the control points of a stroke: one byte for each of StrokeData::points, 1 = selected
/// (Selection::Marks). All functions are pure (docs/design/editing.md#lasso; R31-R34).
///
/// The *arms* of a joint are the points that define its two tangents: usually its handles. If a
/// handle has length zero, the arm on that side is the next control point that differs from the
/// joint (I2).

/// Maximum width in mm after scaling: the width of the pencil's broadest line. Widths that were
/// already larger may stay larger.
inline constexpr double kMaxScaledWidthMm = 50.0;

/// Returns true if every point is marked.
inline bool all_marked(std::span<const std::uint8_t> marks) noexcept {
  return std::find(marks.begin(), marks.end(), 0) == marks.end();
}

/// Adds marks so that a similarity, or any invertible affine map, of the marked points can keep G1
/// (R32). The result is the smallest superset of the given marks such that
///  - both copies of a closed stroke's seam point have the same mark;
///  - if a smooth joint is marked, its two arms and all points between them are marked;
///  - if a smooth joint is not marked, at most one of its arms is marked, and the opposite handle
///    can rotate. If it cannot rotate (it has length zero, or another smooth joint depends on it),
///    or if both arms are marked, the joint is marked as well.
/// Handles at corners and ends keep their marks. Takes linear time, except for strokes with many
/// zero handles.
void close_marks(const Stroke& stroke, std::span<std::uint8_t> marks);

/// Returns the stroke with its marked points mapped. If a handle at an unmarked smooth joint is
/// marked, the unmarked opposite handle is rotated and keeps its length, so that the joint stays
/// smooth. Unmarked joints and handles that are not rotated stay the same bit for bit. Applying a
/// map and then its inverse, with the same marks, restores the points within 1e-9 mm (R33).
///
/// `width_factor` multiplies the widths of segments with both joints marked, and fades out over
/// segments with one joint marked. Widths stay within kMinWidthMm and kMaxScaledWidthMm.
///
/// Requires marks from close_marks(). Fails with kInvalidArgument if there is not one mark for each
/// point; with kInvalidData if the map makes a segment too short (I5) or is not finite.
Result<Stroke> with_marked_moved(const Stroke& stroke, std::span<const std::uint8_t> marks,
                                 const Affine& map, double width_factor = 1.0);

/// Returns the anchors of a partly selected stroke (R34): for each maximal run of marked points
/// (runs continue across the seam of a closed stroke), the first unmarked *on-curve* point in each
/// direction. A run that reaches an open end has no anchor there. The result is empty if all points
/// are marked. A point that is an anchor of two runs, or of both ends of one run, is returned
/// twice. The result contains indices of points in no particular order; the seam has index 0.
std::vector<std::size_t> anchors(const Stroke& stroke, std::span<const std::uint8_t> marks);

}  // namespace felt
