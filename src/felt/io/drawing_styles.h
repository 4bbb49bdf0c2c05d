#pragma once

#include "felt/document/drawing.h"
#include "felt/render/line_style.h"

namespace felt {

/// Returns the styles of the built-in media and of the media in a drawing's texts. Ignores a text
/// that is not a valid material.
StrokeStyles styles_of(const Drawing& drawing);

}  // namespace felt
