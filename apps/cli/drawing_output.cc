#include "drawing_output.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "felt/formats/drawing_writer.h"
#include "felt/formats/format_traits.h"
#include "felt/formats/layered_drawing.h"
#include "felt/formats/line_drawing.h"
#include "felt/io/svg/svg_writer.h"
#include "ordered_pipeline.h"

namespace felt::cli {
namespace {

constexpr double kMarginMm = 5.0;

/// All ink and a margin, as the streaming outputs show it.
Rect ink_area(const StoredDrawing& drawing, Format format) {
  const Rect ink = view_of(drawing, LayerChoice::kVisible).ink();
  if (format == Format::kSvg) return picture_area(ink, std::nullopt, kMarginMm);
  return (ink.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : ink).inflated(kMarginMm);
}

/// The part that a picture shows; none: the page, which becomes the sheet that was asked for.
Result<std::optional<Rect>> shown_area(OpenedDrawing& opened, Format format,
                                       const PictureOptions& picture) {
  const bool is_picture = traits_of(format).picture;
  if (!picture.sheet) {
    const bool whole_ink = is_picture && (picture.fit || !opened.has_page);
    return whole_ink ? std::optional(ink_area(opened.drawing, format)) : std::nullopt;
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

/// One part of a file, and what became of making it.
struct PartWork {
  std::size_t number = 0;
  [[nodiscard]] static std::size_t bytes() { return 0; }
};
struct PartDone {
  DrawingPart part{};
  Result<void> made{};
};

/// Makes the parts of a file on as many threads as there are cores, and writes them in order.
Result<void> write_in_order(DrawingParts& parts, const std::string& name, Output& output) {
  constexpr unsigned kMaxThreads = 8;
  const unsigned cores = std::clamp(std::thread::hardware_concurrency(), 1U, kMaxThreads);
  const bool one_thread = !parts.any_order() || parts.count() < 4;
  OrderedPipeline<PartWork, PartDone> pipeline(one_thread ? 1 : static_cast<int>(cores));
  std::size_t next = 0;
  Result<void> done;
  pipeline.run(
      [&parts] {
        return [&parts](const PartWork& work, PartDone& out) {
          out.made = parts.make(work.number, out.part);
        };
      },
      [&](PartWork& work) {
        work.number = next;
        return next < parts.count() && ++next > 0;
      },
      [&](const PartDone& out) {
        if (!out.made) {
          done = tl::unexpected(with_context(out.made.error(), name));
        } else {
          parts.add(out.part);
          done = output.write(out.part.bytes);
        }
        return done.has_value();
      });
  if (!done) return done;
  return output.write(parts.tail());
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
  const std::string name = path_ == "-" ? "stdout" : path_;
  if (format_ == Format::kFelt) {
    const Result<std::string> bytes = drawing_bytes(drawing.drawing, format_, *options);
    if (!bytes) return tl::unexpected(with_context(bytes.error(), name));
    return output_.save(*bytes);
  }
  // Lines as a stream of them is written, without a header: what `convert` gives does not depend
  // on what it was given.
  Result<std::unique_ptr<DrawingParts>> parts =
      format_ == Format::kNdjson
          ? line_parts(view_of(drawing.drawing, LayerChoice::kVisible), LineHeader::kLeftOut)
          : drawing_parts(drawing.drawing, format_, *options);
  if (!parts) return tl::unexpected(with_context(parts.error(), name));
  if (is_compressed_name(path_)) parts = gzip_parts(*std::move(parts));
  if (auto ok = write_in_order(**parts, name, output_); !ok) return ok;
  return output_.commit();
}

}  // namespace felt::cli
