#pragma once

#include <string>

#include "felt/document/document.h"
#include "felt/document/selection.h"
#include "felt/document/stroke_index.h"
#include "felt/haptics/capabilities.h"
#include "felt/haptics/material.h"

namespace felt {

/// What a tool sees besides the pen: the document, the sheet under the hand, the device that will
/// push back. Constant while a sample is handled.
struct Scene {
  const Document& document;
  const StrokeIndex& index;        ///< of this document, up to date
  const Selection& selection;      ///< of this document, up to date
  LayerId layer;                   ///< where new ink goes
  const SurfaceMaterial& surface;  ///< the sheet
  const Capabilities& device;
  Rgba color{};  ///< of new ink
};

}  // namespace felt
