#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/gather/gathered_stroke.h"

namespace felt::cli {

/// The group that a stroke of the input belongs to.
struct StrokeGroup {
  std::string stroke;  ///< its name in the file, such as "s12"
  std::uint32_t group = 0;
};

/// The result of gather_drawing.
struct GatheredDrawing {
  /// The groups of the strokes in drawing order, numbered from 1 over all layers; without the
  /// strokes of locked and hidden layers.
  std::vector<StrokeGroup> groups;
  std::size_t left_alone = 0;  ///< strokes of locked and hidden layers
};

/// Replaces the strokes of each group (line_groups) by one stroke. Layers are gathered one by one;
/// strokes without companions stay as they are, and a gathered stroke lies where the lowest stroke
/// of its group was. Locked and hidden layers do not change. Fails, and changes nothing, if the
/// strokes cannot be gathered.
Result<GatheredDrawing> gather_drawing(Drawing& drawing, const GatherOptions& options);

}  // namespace felt::cli
