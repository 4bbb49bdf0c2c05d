#pragma once

#include <QString>

#include "desktop/files/drawing_file.h"

namespace felt::desktop {

/// The options of an export.
struct ExportOptions {
  FileFormat format = FileFormat::kSvg;
  double dpi = 300.0;      ///< resolution of a .png, and of the grain in an .svg or .pdf
  bool background = true;  ///< paint the paper's colour, if the page has one
  bool ink_only = false;   ///< export only the area of the ink with a margin; otherwise the whole
                           ///< page
  bool grain = false;      ///< show the surface's grain in dry ink, if the format supports it
};

/// Returns the area of the page that is exported. `ink` is the bounding box of the ink.
Rect export_area(const Rect& ink, const Page& page, const ExportOptions& options);

/// Writes the visible layers, and also the hidden ones if the format has layers. The error names
/// the file and the reason. Safe to call from any thread.
Result<void> export_drawing(const QString& path, const Drawing& drawing,
                            const ExportOptions& options);

}  // namespace felt::desktop
