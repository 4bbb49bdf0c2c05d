#pragma once

#include <cstdint>
#include <vector>

#include "felt/gather/testing/labelled_drawing.h"

namespace felt::bench {

/// Returns the groups of the simple method that gather is compared with: connected components of
/// strokes of which one lies by half within 0.9 % of the drawing's diagonal of the other, at less
/// than 20 degrees.
std::vector<std::uint32_t> baseline_groups(const LabelledDrawing& drawing);

}  // namespace felt::bench
