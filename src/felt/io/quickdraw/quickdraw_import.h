#pragma once

#include <string_view>

#include "felt/base/result.h"
#include "felt/io/import.h"

namespace felt {

/// Size in mm of a unit of the simplified drawings: 255 units are 51 mm.
inline constexpr double kQuickdrawMmPerUnit = 0.2;
/// Distance in mm from one drawing on the contact sheet to the next.
inline constexpr double kQuickdrawCellMm = 60.0;
/// Largest number of drawings that are read from one file. A notice states how many more the file
/// has.
inline constexpr int kMaxQuickdrawDrawings = 1000;

/// Reads drawings of the Quick, Draw! data set, simplified or raw, as a contact sheet: a grid with
/// a layer for each drawing, named after its word. Raw drawings, in pixels of unknown screens, are
/// moved and scaled into the square of the simplified ones (docs/formats/quickdraw.md). A line that
/// is not a drawing becomes a notice. Fails if no line is a drawing.
Result<Imported> import_quickdraw(std::string_view text, const ImportOptions& options = {});

}  // namespace felt
