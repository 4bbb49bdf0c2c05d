#pragma once

#include <QString>

#include "desktop/files/drawing_file.h"

namespace felt::desktop {

/// What an exported picture shows.
struct ExportOptions {
  FileFormat format = FileFormat::kSvg;
  double dpi = 300.0;      ///< of a .png, and of the grain in an .svg or .pdf
  bool background = true;  ///< the paper, where it has a colour
  bool ink_only = false;   ///< cut to the ink and a margin; else the page
  bool grain = false;      ///< of the sheet, in dry ink; where the format is a picture
};

/// Returns the part that is shown of a page with that ink.
Rect export_area(const Rect& ink, const SheetPage& page, const ExportOptions& options);

/// Writes what is seen, and hidden layers as such where the format has layers. Error: names the
/// file and the reason. Any thread.
Result<void> export_drawing(const QString& path, const Drawing& drawing,
                            const ExportOptions& options);

}  // namespace felt::desktop
