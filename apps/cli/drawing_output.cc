#include "drawing_output.h"

#include <optional>
#include <utility>

#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_writer.h"
#include "felt/formats/format_traits.h"
#include "felt/io/ndjson_writer.h"
#include "felt/io/svg_writer.h"
#include "felt/io/unpack.h"
#include "felt/render/page.h"

namespace felt::cli {
namespace {

constexpr double kMarginMm = 5.0;

/// All ink and a margin, as the streaming outputs show it.
Rect ink_area(const Document& document, Format format) {
  const Rect ink = ink_bounds(visible_strokes(document));
  if (format == Format::kSvg) return svg_area(ink, SvgOptions{.margin_mm = kMarginMm});
  return (ink.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : ink).inflated(kMarginMm);
}

/// The part that a picture shows; none: the page, which becomes the sheet that was asked for.
Result<std::optional<Rect>> shown_area(OpenedDrawing& opened, Format format,
                                       const PictureOptions& picture) {
  const bool is_picture = traits_of(format).picture;
  if (!picture.sheet) {
    const bool whole_ink = is_picture && (picture.fit || !opened.has_page);
    return whole_ink ? std::optional(ink_area(opened.drawing.document, format)) : std::nullopt;
  }
  Result<SheetPage> page = sheet_page(*picture.sheet, opened.drawing.page.paper);
  if (page) {
    page->surface = opened.drawing.page.surface;
    opened.drawing.page = *page;
    return std::nullopt;
  }
  if (!is_picture) return tl::unexpected(page.error());
  return picture.sheet;  // a picture may be of any size
}

/// How it is written; its page becomes the one that was asked for.
Result<WriteOptions> write_options(OpenedDrawing& opened, Format format, PictureOptions picture) {
  if (auto ok = use_surface_of(opened.drawing, picture); !ok) return tl::unexpected(ok.error());
  WriteOptions options;
  if (picture.wants_grain) options.grain_print = GrainPrint{picture.grain, picture.grain_dpi};
  options.dpi = picture.dpi;
  options.grain = picture.grain;
  options.no_page = !opened.has_page && !picture.sheet;
  const Result<std::optional<Rect>> area = shown_area(opened, format, picture);
  if (!area) return tl::unexpected(area.error());
  options.area = *area;
  if (picture.paper) {
    opened.drawing.page.paper = *picture.paper;
  } else if (!opened.has_page && format != Format::kPng) {
    options.paper = Rgba{255, 255, 255, 0};
  }
  return options;
}

/// As a stream of lines is written, without a header: what `convert` gives does not depend on what
/// it was given.
Result<std::string> lines(const Document& document) {
  std::string text;
  for (const SketchStroke& s : visible_strokes(document)) {
    if (Result<void> fits = check_sketch_numbers(s.stroke.data()); !fits) {
      return tl::unexpected(with_context(fits.error(), "stroke " + s.id));
    }
    append_sketch_line(text, s.id, s.stroke.data());
  }
  return text;
}

}  // namespace

DrawingOutput::DrawingOutput(std::string path, Format format, PictureOptions picture, Output output)
    : path_(std::move(path)),
      format_(format),
      picture_(std::move(picture)),
      output_(std::move(output)) {}

Result<DrawingOutput> DrawingOutput::create(const std::string& path, Format format,
                                            const PictureOptions& picture) {
  Result<Output> output = Output::create(path);
  if (!output) return tl::unexpected(output.error());
  return DrawingOutput(path, format, picture, *std::move(output));
}

Result<void> DrawingOutput::write(OpenedDrawing drawing) {
  const Result<WriteOptions> options = write_options(drawing, format_, picture_);
  if (!options) return tl::unexpected(options.error());
  Result<std::string> bytes = format_ == Format::kNdjson
                                  ? lines(drawing.drawing.document)
                                  : drawing_bytes(drawing.drawing, format_, *options);
  if (!bytes) {
    return tl::unexpected(with_context(bytes.error(), path_ == "-" ? "stdout" : path_));
  }
  if (is_compressed_name(path_)) bytes = gzip(*bytes);
  return format_ == Format::kFelt ? output_.save(*bytes) : output_.write_all(*bytes);
}

}  // namespace felt::cli
