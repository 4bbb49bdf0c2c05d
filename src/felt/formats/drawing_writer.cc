#include "felt/formats/drawing_writer.h"

#include <utility>

#include "felt/base/atomic_file.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/layered_drawing.h"
#include "felt/formats/line_drawing.h"
#include "felt/io/inkml_writer.h"
#include "felt/io/ndjson_writer.h"
#include "felt/io/pdf_writer.h"
#include "felt/io/png.h"
#include "felt/io/svg_writer.h"
#include "felt/io/unpack.h"
#include "felt/io/xopp_writer.h"
#include "felt/render/page.h"

namespace felt {
namespace {

Result<std::string> png_bytes(const StoredDrawing& drawing, const WriteOptions& options) {
  PageOptions page;
  page.dpi = options.dpi;
  page.sheet = options.area.value_or(drawing.page.area());
  page.paper = options.paper.value_or(drawing.page.paper);
  page.grain = options.grain;
  const Result<Image> image = render_page(visible_strokes(drawing.document), page);
  if (!image) return tl::unexpected(image.error());
  return encode_png(*image, options.dpi);
}

void leave_out_page(LayeredSketch& sketch) {
  if (sketch.page) sketch.surface = std::move(sketch.page->surface);
  sketch.page.reset();
}

/// All layers, on a sheet of the colour that was asked for.
LayeredSketch sheet_with(const StoredDrawing& drawing, const WriteOptions& options) {
  LayeredSketch sketch = layered_sketch(drawing);
  sketch.page->paper = options.paper.value_or(drawing.page.paper);
  if (options.no_page) leave_out_page(sketch);
  return sketch;
}

/// The page says what is shown, unless another part was asked for.
Result<std::string> svg_bytes(const StoredDrawing& drawing, const WriteOptions& options) {
  LayeredSketch sketch = sheet_with(drawing, options);
  const Rgba paper = options.paper.value_or(drawing.page.paper);
  if (options.area) leave_out_page(sketch);
  return svg_text(sketch,
                  SvgOptions{.sheet = options.area, .paper = paper, .grain = options.grain_print});
}

}  // namespace

Result<std::string> drawing_bytes(const StoredDrawing& drawing, FileFormat format,
                                  const WriteOptions& options) {
  const Rect area = options.area.value_or(drawing.page.area());
  const Rgba paper = options.paper.value_or(drawing.page.paper);
  switch (format) {
    case FileFormat::kFelt:
      return felt_bytes(drawing);
    case FileFormat::kNdjson:
      for (const SketchStroke& s : visible_strokes(drawing.document)) {
        if (Result<void> fits = check_sketch_numbers(s.stroke.data()); !fits) {
          return tl::unexpected(with_context(fits.error(), "stroke " + s.id));
        }
      }
      return lines_of(visible_strokes(drawing.document));
    case FileFormat::kSvg:
      return svg_bytes(drawing, options);
    case FileFormat::kPdf:
      return pdf_text(visible_strokes(drawing.document),
                      {.sheet = area, .paper = paper, .grain = options.grain_print});
    case FileFormat::kPng:
      return png_bytes(drawing, options);
    case FileFormat::kInkml:
      return inkml_text(sheet_with(drawing, options));
    case FileFormat::kXopp:
      return xopp_bytes(sheet_with(drawing, options));
  }
  return fail(ErrorCode::kInvalidArgument, "there is no such format");
}

Result<void> write_drawing(const std::string& path, const StoredDrawing& drawing, FileFormat format,
                           const WriteOptions& options) {
  if (format == FileFormat::kFelt && path != "-") return write_felt(path, drawing);
  const Result<std::string> bytes = drawing_bytes(drawing, format, options);
  if (!bytes) return tl::unexpected(with_context(bytes.error(), path == "-" ? "stdout" : path));
  return write_file(path, is_compressed_name(path) ? gzip(*bytes) : *bytes);
}

}  // namespace felt
