#include "desktop/files/export_file.h"

#include "desktop/files/clipboard.h"
#include "felt/document/visible_strokes.h"
#include "felt/io/pdf_writer.h"
#include "felt/io/png.h"
#include "felt/io/svg_writer.h"
#include "felt/render/page.h"

namespace felt::desktop {

Rect export_area(const Sketch& sketch, const SheetPage& page, const ExportOptions& options) {
  return options.ink_only && !sketch.empty() ? ink_area(sketch) : page.area();
}

Result<void> export_drawing(const QString& path, const Drawing& drawing,
                            const ExportOptions& options) {
  const std::string name = path.toStdString();
  const Sketch sketch = visible_strokes(drawing.document);
  const Rect area = export_area(sketch, drawing.page, options);
  const Rgba paper = options.background ? drawing.page.paper : Rgba{255, 255, 255, 0};
  switch (options.format) {
    case DrawingFormat::kSvg:
      return write_svg(name, sketch, {.sheet = area, .paper = paper});
    case DrawingFormat::kPdf:
      return write_pdf(name, sketch, {.sheet = area, .paper = paper});
    case DrawingFormat::kPng: {
      const Result<Image> image =
          render_page(sketch, {.dpi = options.dpi, .sheet = area, .paper = paper});
      if (!image) return tl::unexpected(with_context(image.error(), name));
      return write_png(name, *image, options.dpi);
    }
    case DrawingFormat::kSketch:
    case DrawingFormat::kFelt:
      break;
  }
  return write_drawing(path, drawing);
}

}  // namespace felt::desktop
