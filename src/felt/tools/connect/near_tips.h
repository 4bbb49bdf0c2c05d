#pragma once

#include <cstddef>
#include <vector>

#include "felt/document/stroke_index.h"
#include "felt/tools/scene.h"

namespace felt {

/// Returns the ends that are within radius_mm of `place` and on visible, unlocked layers; other
/// ends may not be dragged. The nearest end comes first. Returns at most `max_ends` ends.
std::vector<TipHit> editable_tips_near(const Scene& scene, Point place, double radius_mm,
                                       std::size_t max_ends);

}  // namespace felt
