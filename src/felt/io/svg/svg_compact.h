#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/io/svg/svg_writer.h"

namespace felt {

/// Returns a drawing as a small SVG for web pages: only the visible ink, as filled outlines rounded
/// to 0.01 mm, without layers, centre lines and Feltline's own attributes. The outlines are within
/// 0.03 mm of the exact ones. Uses the area, margin and paper of `options`; ignores its tolerance
/// and grain. The file is a picture: reading it back does not give the same strokes. Fails if a
/// coordinate is beyond 1e9 mm.
Result<std::string> svg_compact_text(const Drawing& drawing, const SvgOptions& options);

/// Appends the start of the root element of such a file, which shows `area`, and then the paper,
/// unless its alpha is 0.
void append_compact_head(std::string& out, const Rect& area, Rgba paper);

/// Appends the visible ink of a drawing as such outlines. Fails if a coordinate is beyond 1e9 mm.
Result<void> append_compact_ink(std::string& out, const Drawing& drawing);

}  // namespace felt
