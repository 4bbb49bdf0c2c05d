#pragma once

#include <cstddef>
#include <vector>

#include "felt/document/stroke_index.h"
#include "felt/tools/scene.h"

namespace felt {

/// Returns the ends within radius_mm of a point that may be dragged, that is, ends of strokes on
/// visible, unlocked layers. The nearest comes first; returns at most `most`.
std::vector<TipHit> editable_tips_near(const Scene& scene, Point place, double radius_mm,
                                       std::size_t largest);

}  // namespace felt
