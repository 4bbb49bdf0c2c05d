#pragma once

#include <QString>

#include "desktop/files/drawing_file.h"

namespace felt::desktop {

/// What an exported file contains.
struct ExportOptions {
  FileFormat format = FileFormat::kSvg;
  double dpi = 300.0;      ///< of a .png, and of the grain in an .svg or .pdf
  bool background = true;  ///< the paper, if it has a colour
  bool ink_only = false;   ///< cropped to the ink and a margin; otherwise the page
  bool grain = false;      ///< of the surface, in dry ink; if the format can show it
};

/// Returns the part of a page with that ink that is exported.
Rect export_area(const Rect& ink, const SheetPage& page, const ExportOptions& options);

/// Writes the visible ink, and also hidden layers if the format has layers. The error names the
/// file and the reason. Safe to call from any thread.
Result<void> export_drawing(const QString& path, const Drawing& drawing,
                            const ExportOptions& options);

}  // namespace felt::desktop
