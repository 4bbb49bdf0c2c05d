#pragma once

#include <memory>
#include <string>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/io/drawing_parts.h"

namespace felt {

/// How far a written line may be from the stroke: its points lie on it.
inline constexpr double kXoppToleranceMm = 0.02;
/// Largest step from the width of one piece of a line to the next.
inline constexpr double kXoppWidthStepMm = 0.1;
/// Around the ink of a drawing without a sheet.
inline constexpr double kXoppMarginMm = 5.0;

/// A drawing as a document of Xournal++, of one page: layers, and strokes as lines with a width for
/// each piece. docs/formats/xopp.md says what the format cannot hold. `paper` replaces the colour
/// of the page. Equal drawings give equal bytes. Error: a layer's name that XML cannot hold, a
/// coordinate beyond 1e9 mm.
Result<std::unique_ptr<DrawingParts>> xopp_parts(const Drawing& drawing,
                                                 const std::optional<Rgba>& paper = {});

/// The same as one file.
Result<std::string> xopp_bytes(const Drawing& drawing);

}  // namespace felt
