#pragma once

#include <optional>

#include "felt/document/edit.h"
#include "felt/document/stroke_index.h"
#include "felt/tools/scene.h"

namespace felt {

/// The targets of the ends of new ink.
struct InkConnections {
  std::optional<TipId> start = std::nullopt;
  std::optional<TipId> end = std::nullopt;
  /// Points on other strokes that the ends meet.
  std::optional<Point> start_meets = std::nullopt;
  std::optional<Point> end_meets = std::nullopt;
  bool closes = false;  ///< the end moves to the start of the same ink
  /// If true, strokes that meet stay separate, with a shared point. Exception: ink that meets both
  /// ends of one stroke still closes that stroke.
  bool keep_separate = false;
};

/// Returns the edit that adds new ink to the document, connected (R43, R45):
///   - An end moves exactly to its target. The shift fades out along the stroke over five times the
///     length of the shift, limited to 2..25 mm, so that the rest of the stroke stays as drawn.
///   - Ink whose end meets its own start becomes a closed stroke.
///   - Ink that meets the end of another stroke is joined with that stroke; the result keeps the
///     id, position and direction of that stroke. If the two ends of the ink meet different
///     strokes, all three are joined, and the result keeps the id, position and direction of the
///     stroke at the start of the ink. Ink that meets both ends of the same stroke closes that
///     stroke. Ink and stroke are joined only if they have the same medium and colour and the
///     stroke is in the current layer, which must be unlocked. Otherwise they stay separate and
///     share the point.
///   - Ink that meets a point on another stroke shares that point; the other stroke does not
///     change.
/// An impossible connection is skipped, so that ink is never lost: for example, if the other stroke
/// was removed meanwhile, or the ink is too short to reach the target. This is a pure function.
Edit connect_ink(const Stroke& ink, const InkConnections& connections, const Scene& scene);

}  // namespace felt
