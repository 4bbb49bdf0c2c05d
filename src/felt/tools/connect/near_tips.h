#pragma once

#include <cstddef>
#include <vector>

#include "felt/document/stroke_index.h"
#include "felt/tools/scene.h"

namespace felt {

/// The ends nearest to a place, within radius_mm, that may be dragged: of strokes of visible,
/// unlocked layers. The nearest first, at most `most`.
std::vector<TipHit> editable_tips_near(const Scene& scene, Point place, double radius_mm,
                                       std::size_t most);

}  // namespace felt
