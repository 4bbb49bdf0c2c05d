#pragma once

#include <memory>
#include <string>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/io/drawing_parts.h"

namespace felt {

/// Largest distance between the stroke and the straight lines between the points of a written
/// trace.
inline constexpr double kTraceToleranceMm = 0.01;

/// Returns a drawing as InkML. Any program can read the traces with X, Y and W in mm, the brushes
/// for the colours, and a traceGroup for each layer. In addition, the file has the exact strokes in
/// Feltline's attributes, which import_inkml() reads back. `paper` replaces the colour of the page.
/// Equal drawings give equal bytes. Fails if a name is longer than 4096 bytes or has characters
/// that XML cannot hold, or if a coordinate is beyond 1e9 mm; the message names the stroke.
Result<std::unique_ptr<DrawingParts>> inkml_parts(const Drawing& drawing,
                                                  const std::optional<Rgba>& paper = {});

/// Returns the same file as one text.
Result<std::string> inkml_text(const Drawing& drawing);

}  // namespace felt
