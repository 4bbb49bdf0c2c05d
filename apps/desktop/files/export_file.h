#pragma once

#include <QString>

#include "desktop/files/drawing_file.h"
#include "felt/document/selection.h"
#include "felt/tactile/swell_paper.h"

namespace felt::desktop {

/// The part of a drawing that is exported.
enum class ExportPart {
  kPage,       ///< the whole page
  kInk,        ///< the area of the ink with a margin
  kSelection,  ///< the selected lines only, and their area with a margin
};

/// The options of an export.
struct ExportOptions {
  FileFormat format = FileFormat::kSvg;
  double dpi = 300.0;      ///< resolution of a .png, and of the grain in an .svg or .pdf
  bool background = true;  ///< paint the paper's colour, if the page has one
  ExportPart part = ExportPart::kPage;  ///< see selected_only()
  bool grain = false;     ///< show the surface's grain in dry ink, if the format supports it
  bool compact = false;   ///< make an .svg small, for web pages; it then shows no grain
  bool pictures = false;  ///< show the pictures of all visible layers, if the format supports it
  bool swell = false;     ///< make an .svg or .pdf for swell paper, without grain and pictures
};

/// Returns the drawing with only those strokes that are selected wholly or in part, and the fills
/// that go with them (goes_with_strokes). Layers without any of these are left out.
Drawing selected_only(Drawing drawing, const Selection& selection);

/// Returns the area of the page that is exported. `ink` is the bounding box of the exported ink.
Rect export_area(const Rect& ink, const Page& page, const ExportOptions& options);

/// Writes the visible layers of the drawing, which the caller has reduced by selected_only() if
/// only the selection is exported, and also the hidden ones if the format has layers. The error
/// names the file and the reason. If the drawing is exported for swell paper, sets `swell`, if it
/// is not null, to what was changed. Safe to call from any thread.
Result<void> export_drawing(const QString& path, const Drawing& drawing,
                            const ExportOptions& options, SwellReport* swell = nullptr);

}  // namespace felt::desktop
