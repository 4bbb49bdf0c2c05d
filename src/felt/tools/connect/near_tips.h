#pragma once

#include <cstddef>
#include <vector>

#include "felt/document/stroke_index.h"
#include "felt/tools/scene.h"

namespace felt {

/// Returns the ends that may be dragged (of strokes on visible, unlocked layers) within radius_mm
/// of a point: the nearest first, at most `most`.
std::vector<TipHit> editable_tips_near(const Scene& scene, Point place, double radius_mm,
                                       std::size_t most);

}  // namespace felt
