#pragma once

#include <QString>

#include "desktop/files/drawing_file.h"

namespace felt::desktop {

/// What an exported file contains.
struct ExportOptions {
  FileFormat format = FileFormat::kSvg;
  double dpi = 300.0;      ///< resolution of a .png, and of the grain in an .svg or .pdf
  bool background = true;  ///< include the colour of the paper, if it has one
  bool ink_only = false;   ///< crop to the ink and a margin; otherwise the page
  bool grain = false;      ///< show the surface's grain in dry ink if the format can
};

/// Returns the area of the page that is exported. `ink` is the bounding box of the ink.
Rect export_area(const Rect& ink, const SheetPage& page, const ExportOptions& options);

/// Writes the visible ink, and also hidden layers if the format has layers. The error names the
/// file and the reason. Safe to call from any thread.
Result<void> export_drawing(const QString& path, const Drawing& drawing,
                            const ExportOptions& options);

}  // namespace felt::desktop
