#pragma once

#include <memory>
#include <string>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/io/drawing_parts.h"

namespace felt {

/// How far the straight lines between the points of a written trace may be from the stroke.
inline constexpr double kTraceToleranceMm = 0.01;

/// A drawing as InkML: for every reader traces with X, Y and W in mm, brushes for the colours and a
/// traceGroup for each layer; beside them our exact model, which import_inkml() gives back. `paper`
/// replaces the colour of the page. Equal drawings give equal bytes. Error: a name that XML cannot
/// hold or of more than 4096 bytes, a coordinate beyond 1e9 mm; it names the stroke.
Result<std::unique_ptr<DrawingParts>> inkml_parts(const Drawing& drawing,
                                                  const std::optional<Rgba>& paper = {});

/// The same as one text.
Result<std::string> inkml_text(const Drawing& drawing);

}  // namespace felt
