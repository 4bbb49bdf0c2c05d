#include "desktop/files/export_file.h"

#include <algorithm>

#include "desktop/files/clipboard.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_grain.h"
#include "felt/formats/drawing_writer.h"
#include "felt/formats/format_traits.h"

namespace felt::desktop {

Rect export_area(const Rect& ink, const Page& page, const ExportOptions& options) {
  return options.ink_only && !ink.empty() ? ink_area(ink) : page.area();
}

Result<void> export_drawing(const QString& path, const Drawing& drawing,
                            const ExportOptions& options) {
  WriteOptions how;
  how.dpi = options.dpi;
  if (options.grain && traits_of(options.format).picture) {
    Result<Grain> grain = grain_of(drawing);
    if (!grain) return tl::unexpected(grain.error());
    how.grain = *grain;
    how.grain_print =
        GrainPrint{*grain, std::clamp(options.dpi, GrainPrint::kMinDpi, GrainPrint::kMaxDpi)};
  }
  if (!options.background) how.paper = Rgba{255, 255, 255, 0};
  if (options.ink_only) {
    how.area = export_area(ink_bounds(drawing.document), drawing.page, options);
  }
  return felt::write_drawing(path.toStdString(), drawing, options.format, how);
}

}  // namespace felt::desktop
