#pragma once

#include <optional>

#include "felt/document/document.h"
#include "felt/document/stroke_index.h"

namespace felt {

/// What tools that put ends of strokes onto each other share (paper, "Connect curves";
/// specification 5g; R43, R45). Pure.

/// The stroke of an end if that end is there (closed strokes have none), or null.
StrokePtr stroke_with_tip(const Document& document, const std::optional<TipId>& tip);

/// True when two strokes may become one: of the same material and colour. Ink of another look must
/// not change its own.
bool look_alike(const Stroke& a, const Stroke& b) noexcept;

/// True when tools may change the strokes of the layer: it is there, visible, and not locked.
bool is_editable(const Document& document, LayerId layer) noexcept;

/// One stroke of `base` and `more`, whose end `at` lies on the end `tip` of base, bit for bit. Base
/// keeps its direction; joint, colour and widths as `joined`. Error: as `joined`.
Result<Stroke> joined_at(const Stroke& base, StrokeTip tip, const Stroke& more, StrokeTip at);

}  // namespace felt
