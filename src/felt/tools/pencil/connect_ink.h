#pragma once

#include <optional>

#include "felt/document/edit.h"
#include "felt/tools/scene.h"

namespace felt {

/// What the ends of new ink were put on.
struct InkConnections {
  std::optional<TipId> start = std::nullopt;
  std::optional<TipId> end = std::nullopt;
  bool closes = false;  ///< the end was put on its own start
  /// Strokes that meet stay two, with a shared point.
  bool keep_separate = false;
};

/// The edit that adds new ink to the document, connected (specification 5g; R43, R45):
///   - an end goes exactly to the point that it was put on, the shift fading along the stroke;
///   - ink whose end meets its own start becomes a closed stroke;
///   - ink that meets another stroke's end becomes one stroke with it, which keeps its id, place
///     and direction; that of both ends of the same stroke closes it. Only where both look the same
///     (material, colour), in the layer that is drawn in, unless it is locked: ink of another
///     colour must not change its own. Else they share the point.
/// A connection that is not possible (the stroke has gone meanwhile, the ink is too short to reach)
/// is left out: ink is never lost. Pure.
Edit connect_ink(const Stroke& ink, const InkConnections& connections, const Scene& scene);

}  // namespace felt
