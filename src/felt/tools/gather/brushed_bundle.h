#pragma once

#include <optional>
#include <vector>

#include "felt/document/edit_builder.h"
#include "felt/gather/gathered_stroke.h"
#include "felt/tools/gather/brushed_parts.h"

namespace felt {

/// The strokes that a brush gathers into one line: for each of them its parts (brushed_parts).
struct BrushedBundle {
  LayerId layer;
  std::map<StrokeId, std::vector<StrokePart>> parts;
  std::size_t count = 0;  ///< of all parts
};

/// Returns the bundle under the brush. Brushed parts of one layer that belong to one line
/// (line_groups) form groups; the group with the longest brushed ink is the bundle. A group that
/// does not lie beside the bundle but continues it within a diameter of the brush is added.
BrushedBundle brushed_bundle(const BrushPath& brush);

/// Returns how far the lines of a bundle ahead of the brush still have to move, in mm: the root
/// mean square, over the strokes within the radius of `pen`, of their mean distance across the
/// brush from the mean of all. Ink that the brush has passed counts less, and does not count once
/// the brush has moved along it by its radius. 0 for a single line.
double spread_mm(const BrushPath& brush, const BrushedBundle& bundle, Point pen);

/// Returns the edit that replaces the bundle by one line (gathered_stroke), or nullopt if the
/// bundle has fewer than two parts or the line cannot be made. The line lies where the lowest
/// stroke that is gathered as a whole was, or on top of the layer. Ends of the remainders that were
/// cut move onto the line, so that they stay connected with it.
std::optional<Edit> gather_edit(const Document& document, const BrushedBundle& bundle,
                                const GatherOptions& options);

}  // namespace felt
