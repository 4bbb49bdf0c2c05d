#pragma once

#include "felt/document/document.h"
#include "felt/stroke/sketch.h"

namespace felt {

/// The strokes of visible layers in drawing order, each named after its id: "s12".
Sketch visible_strokes(const Document& document);

}  // namespace felt
