#pragma once

#include <cstddef>
#include <cstdint>

#include "felt/solid/cut_region.h"
#include "felt/solid/solid.h"
#include "felt/solid/view_frame.h"

namespace felt {

/// What a cut leaves of a body.
enum class CutEffect : std::uint8_t {
  kRemovesNothing,  ///< the region contains nothing of the body
  kRemovesPart,     ///< parts of the body are on both sides of the stroke
  kRemovesAll,      ///< the region contains the whole body
};

/// Returns what would be removed from a body if a region were cut off. Parts of the body that are
/// at most `tolerance_mm` beyond the stroke do not count: a cut along the face of an earlier cut
/// removes nothing.
CutEffect cut_effect(const SolidBody& body, const ViewFrame& frame, const CutRegion& region,
                     double tolerance_mm);

/// The largest number of steps by which move_off_points() moves a stroke.
inline constexpr int kMaxClearanceSteps = 8;

/// Moves the stroke of a region sideways, by at most kMaxClearanceSteps times `step_mm`, so that no
/// point of the body lies within a quarter of `step_mm` of it, if that is possible. If no point
/// does, nothing changes. So two surfaces never coincide when the region is cut off, and the set
/// operation does not need exact numbers, which are slow (docs/design/solids.md#edits-of-the-body).
/// If faces of the body lie on the stroke, it moves away from the body.
void move_off_points(const SolidBody& body, const ViewFrame& frame, double step_mm,
                     CutRegion& region);

/// Returns the number of points of a body within `reach_mm` of the stroke of a region.
std::size_t points_on_stroke(const SolidBody& body, const ViewFrame& frame, const CutRegion& region,
                             double reach_mm);

}  // namespace felt
