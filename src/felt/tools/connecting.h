#pragma once

#include <optional>

#include "felt/document/document.h"
#include "felt/document/stroke_index.h"

namespace felt {

/// Functions shared by the tools that connect ends of strokes (paper, "Connect curves";
/// docs/design/editing.md#joining; R43, R45). They are pure functions.

/// Returns the stroke of an end, or null if the end does not exist (closed strokes have no ends).
StrokePtr stroke_with_tip(const Document& document, const std::optional<TipId>& tip);

/// Returns true if two strokes may be joined into one: they have the same medium and colour.
/// Joining must not change how ink looks.
bool look_alike(const Stroke& a, const Stroke& b) noexcept;

/// Returns true if tools may change strokes of the layer: it exists, is visible and is not locked.
bool is_editable(const Document& document, LayerId layer) noexcept;

/// Returns `base` and `more` joined into one stroke that keeps the direction of `base`. Requires
/// the end `at` of `more` to lie exactly on the end `tip` of `base`, bit for bit. Joint, colour,
/// widths and errors are as for joined() (join.h).
Result<Stroke> joined_at(const Stroke& base, StrokeTip tip, const Stroke& more, StrokeTip at);

}  // namespace felt
