#include "felt/formats/drawing_writer.h"

#include <functional>
#include <utility>

#include "felt/base/atomic_file.h"
#include "felt/formats/layered_drawing.h"
#include "felt/formats/line_drawing.h"
#include "felt/io/inkml/inkml_writer.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/io/picture/pdf_writer.h"
#include "felt/io/picture/png.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/io/xopp/xopp_writer.h"
#include "felt/render/page.h"
#include "felt/render/raster.h"

namespace felt {
namespace {

Result<std::string> png_bytes(const StoredDrawing& drawing, const WriteOptions& options) {
  PageOptions page;
  page.dpi = options.dpi;
  page.sheet = options.area.value_or(drawing.page.area());
  page.paper = options.paper.value_or(drawing.page.paper);
  page.grain = options.grain;
  Result<Image> image = render_page({}, page);  // the paper
  if (!image) return tl::unexpected(image.error());
  const View view = View::at_dpi({page.sheet->x0, page.sheet->y0}, page.dpi);
  const Pixels pixels = image->pixels();
  Rasterizer rasterizer;
  const DrawingView visible = view_of(drawing, LayerChoice::kVisible);
  for (const LayerView& layer : visible.layers) {
    for (std::size_t i = 0; i < layer.count; ++i) {
      rasterizer.draw(layer.stroke(i), view, pixels.rect(), options.grain, pixels);
    }
  }
  return encode_png(*image, options.dpi);
}

void leave_out_page(DrawingView& view) {
  if (view.page) view.surface = std::move(view.page->surface);
  view.page.reset();
}

/// All layers, on a sheet of the colour that was asked for.
DrawingView sheet_with(const StoredDrawing& drawing, const WriteOptions& options) {
  DrawingView view = view_of(drawing);
  view.page->paper = options.paper.value_or(drawing.page.paper);
  if (options.no_page) leave_out_page(view);
  return view;
}

/// The page says what is shown, unless another part was asked for.
Result<std::unique_ptr<DrawingParts>> parts_of_svg(const StoredDrawing& drawing,
                                                   const WriteOptions& options) {
  DrawingView view = sheet_with(drawing, options);
  const Rgba paper = options.paper.value_or(drawing.page.paper);
  if (options.area) leave_out_page(view);
  return svg_parts(std::move(view),
                   {.sheet = options.area, .paper = paper, .grain = options.grain_print});
}

/// What is made as a whole.
class WholeFile final : public DrawingParts {
 public:
  using Bytes = std::function<Result<std::string>()>;
  explicit WholeFile(Bytes bytes) : bytes_(std::move(bytes)) {}

  [[nodiscard]] std::size_t count() const override { return 1; }
  Result<void> make(std::size_t, DrawingPart& out) const override {
    out.clear();
    Result<std::string> bytes = bytes_();
    if (!bytes) return tl::unexpected(bytes.error());
    out.bytes = *std::move(bytes);
    return {};
  }

 private:
  Bytes bytes_;
};

std::unique_ptr<DrawingParts> whole(WholeFile::Bytes bytes) {
  return std::make_unique<WholeFile>(std::move(bytes));
}

}  // namespace

Result<std::unique_ptr<DrawingParts>> drawing_parts(const StoredDrawing& drawing, FileFormat format,
                                                    const WriteOptions& options) {
  const Rect area = options.area.value_or(drawing.page.area());
  const Rgba paper = options.paper.value_or(drawing.page.paper);
  switch (format) {
    case FileFormat::kFelt:
      return whole([&drawing] { return felt_bytes(drawing); });
    case FileFormat::kNdjson:
      return line_parts(view_of(drawing, LayerChoice::kVisible));
    case FileFormat::kSvg:
      return parts_of_svg(drawing, options);
    case FileFormat::kPdf:
      return pdf_parts(view_of(drawing, LayerChoice::kVisible),
                       {.sheet = area, .paper = paper, .grain = options.grain_print});
    case FileFormat::kPng:
      return whole([&drawing, options] { return png_bytes(drawing, options); });
    case FileFormat::kInkml:
      return inkml_parts(sheet_with(drawing, options));
    case FileFormat::kXopp:
      return xopp_parts(sheet_with(drawing, options));
  }
  return fail(ErrorCode::kInvalidArgument, "there is no such format");
}

Result<std::string> drawing_bytes(const StoredDrawing& drawing, FileFormat format,
                                  const WriteOptions& options) {
  const Result<std::unique_ptr<DrawingParts>> parts = drawing_parts(drawing, format, options);
  if (!parts) return tl::unexpected(parts.error());
  return bytes_of(**parts);
}

Result<void> write_drawing(const std::string& path, const StoredDrawing& drawing, FileFormat format,
                           const WriteOptions& options) {
  if (format == FileFormat::kFelt && path != "-") return write_felt(path, drawing);
  const auto about_path = [&path](const Error& error) {
    return tl::unexpected(with_context(error, path == "-" ? "stdout" : path));
  };
  Result<std::unique_ptr<DrawingParts>> parts = drawing_parts(drawing, format, options);
  if (!parts) return about_path(parts.error());
  if (is_compressed_name(path)) parts = gzip_parts(*std::move(parts));
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  bool is_disk = false;  // whose errors name the file
  const Result<void> done = write_parts(**parts, [&](std::string_view bytes) {
    Result<void> written = file->write(bytes);
    is_disk = !written;
    return written;
  });
  if (!done && !is_disk) return about_path(done.error());
  return done ? file->commit() : done;
}

}  // namespace felt
