#pragma once

#include <cstddef>
#include <vector>

#include "felt/document/stroke_index.h"
#include "felt/tools/scene.h"

namespace felt {

/// Returns the ends of strokes within radius_mm of `place`, but only on visible, unlocked layers,
/// because only these ends may be dragged. The nearest end comes first. Returns at most `largest`
/// ends.
std::vector<TipHit> editable_tips_near(const Scene& scene, Point place, double radius_mm,
                                       std::size_t largest);

}  // namespace felt
