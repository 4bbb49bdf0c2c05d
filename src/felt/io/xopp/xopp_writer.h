#pragma once

#include <memory>
#include <string>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/io/drawing_parts.h"

namespace felt {

/// Largest distance between a written line and the stroke. The points of the line lie on the
/// stroke.
inline constexpr double kXoppToleranceMm = 0.02;
/// Largest step in width from one piece of a line to the next.
inline constexpr double kXoppWidthStepMm = 0.1;
/// Margin around the ink of a drawing without a page.
inline constexpr double kXoppMarginMm = 5.0;

/// Returns a drawing as a document of Xournal++ with one page. Layers are kept. Strokes become
/// polylines with a width for each straight piece. docs/formats/xopp.md lists what the format
/// cannot hold. `paper` replaces the colour of the page. Equal drawings give equal bytes. Fails if
/// XML cannot hold the name of a layer, or if a coordinate is beyond 1e9 mm.
Result<std::unique_ptr<DrawingParts>> xopp_parts(const Drawing& drawing,
                                                 const std::optional<Rgba>& paper = {});

/// Returns the bytes of the same file.
Result<std::string> xopp_bytes(const Drawing& drawing);

}  // namespace felt
