#include "drawing_output.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "felt/base/check.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_writer.h"
#include "felt/formats/format_traits.h"
#include "felt/io/drawing_builder.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/io/picture/png.h"
#include "felt/io/svg/svg_elements.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/render/line_style.h"
#include "felt/render/page_painter.h"
#include "ordered_pipeline.h"

namespace felt::cli {
namespace {

constexpr double kMarginMm = 5.0;

/// Returns the area of all ink and a margin. If the same strokes are written one by one, the area
/// is the same.
Rect ink_area(const Rect& ink, Format format) {
  if (format == Format::kSvg) return picture_area(ink, std::nullopt, kMarginMm);
  return (ink.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : ink).inflated(kMarginMm);
}

/// Sets the drawing's page to the requested page. Returns the area that a picture shows, or nullopt
/// if it shows the page. `ink` is the box of all ink.
Result<std::optional<Rect>> shown_area(Drawing& drawing, const Rect& ink, Format format,
                                       const PictureOptions& picture) {
  const bool is_picture = traits_of(format).picture;
  if (!picture.area) {
    const bool whole_ink = is_picture && (picture.fit || !drawing.has_page);
    return whole_ink ? std::optional(ink_area(ink, format)) : std::nullopt;
  }
  Result<Page> page = page_for(*picture.area, drawing.page.paper);
  if (page) {
    page->surface = drawing.page.surface;
    drawing.page = *page;
    drawing.has_page = true;
    return std::nullopt;
  }
  if (!is_picture) return tl::unexpected(page.error());
  return picture.area;  // a picture may have any size
}

/// Sets the drawing's page to the requested page. Returns the options for writing a drawing whose
/// ink has the box `ink`.
Result<WriteOptions> write_options(Drawing& drawing, const Rect& ink, Format format,
                                   PictureOptions picture) {
  if (auto ok = use_surface_of(drawing, picture); !ok) return tl::unexpected(ok.error());
  WriteOptions options;
  if (picture.wants_grain) options.grain_print = GrainPrint{picture.grain, picture.grain_dpi};
  options.dpi = picture.dpi;
  options.grain = picture.grain;
  options.compact = picture.compact;
  options.pictures = picture.pictures;
  const bool came_with_page = drawing.has_page;
  const Result<std::optional<Rect>> area = shown_area(drawing, ink, format, picture);
  if (!area) return tl::unexpected(area.error());
  options.area = *area;
  if (picture.paper) {
    drawing.page.paper = *picture.paper;
  } else if (!came_with_page && format != Format::kPng) {
    options.paper = Rgba{255, 255, 255, 0};
  }
  return options;
}

/// A part of a file, and the result of making it.
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

Result<void> encode(const NamedStroke& stroke, std::int64_t number, Format format,
                    EncodedStrokes& out) {
  if (format == Format::kSvg) {
    const Result<void> done = append_svg_stroke(
        out.text, {stroke.id}, stroke.stroke, static_cast<std::size_t>(number),
        SvgOptions{}.tolerance_mm, nullptr, StrokeStyles().find(stroke.stroke.medium()));
    if (!done) return done;
  } else if (Result<void> fits = check_sketch_numbers(stroke.stroke.data()); !fits) {
    return fits;
  } else {
    append_sketch_line(out.text, stroke.id, stroke.stroke.data());
  }
  out.bounds.extend(stroke.stroke.bounds());
  return {};
}

Format stroke_format(const std::string& path, Format format) {
  return format == Format::kSvg && !is_compressed_name(path) ? Format::kSvg : Format::kNdjson;
}

DrawingOutput::DrawingOutput(std::string path, Format format, PictureOptions picture, Output output)
    : path_(std::move(path)),
      format_(format),
      stroke_format_(stroke_format(path_, format)),
      picture_(std::move(picture)),
      output_(std::move(output)) {}

Result<DrawingOutput> DrawingOutput::create(const std::string& path, Format format,
                                            const PictureOptions& picture, OutputUse use) {
  const bool head_comes_last =
      use == OutputUse::kStrokes && stroke_format(path, format) == Format::kSvg;
  Result<Output> output =
      head_comes_last ? Output::create_for_overwrite(path) : Output::create(path);
  if (!output) return tl::unexpected(output.error());
  return DrawingOutput(path, format, picture, *std::move(output));
}

Result<void> DrawingOutput::write(Drawing drawing) {
  const Result<WriteOptions> options =
      write_options(drawing, ink_bounds(drawing.document), format_, picture_);
  if (!options) return tl::unexpected(options.error());
  const std::string name = path_ == "-" ? "stdout" : path_;
  if (format_ == Format::kFelt) {
    const Result<std::string> bytes = drawing_bytes(drawing, format_, *options);
    if (!bytes) return tl::unexpected(with_context(bytes.error(), name));
    return output_.save(*bytes);
  }
  Result<std::unique_ptr<DrawingParts>> parts = drawing_parts(drawing, format_, *options);
  if (!parts) return tl::unexpected(with_context(parts.error(), name));
  if (format_ == Format::kSvg && is_compressed_name(path_)) parts = gzip_parts(*std::move(parts));
  if (auto ok = write_in_order(**parts, name, output_); !ok) return ok;
  return output_.commit();
}

Result<void> DrawingOutput::append(const EncodedStrokes& strokes) {
  if (format_ == Format::kNdjson) return output_.write(strokes.text);
  ink_.extend(strokes.bounds);
  if (stroke_format_ != Format::kSvg) return spool_.add_lines(strokes.text);
  return begin_svg().and_then([&] { return output_.write(strokes.text); });
}

Result<void> DrawingOutput::finish() {
  if (format_ == Format::kNdjson) return output_.commit();
  if (stroke_format_ == Format::kSvg) return finish_svg();
  return format_ == Format::kPng ? finish_png() : finish_drawing();
}

/// Reserves space for the head of the file, and begins the layer that a drawing with these strokes
/// has. The head is written last, because it contains the size of the picture.
Result<void> DrawingOutput::begin_svg() {
  if (std::exchange(has_begun_, true)) return {};
  std::string text(kSvgHeadBytes, ' ');
  return append_svg_layer_begin(text, Document().layers().front(), 1).and_then([&] {
    return output_.write(text);
  });
}

/// Writes the same file as write() does for a drawing with these strokes.
Result<void> DrawingOutput::finish_svg() {
  Drawing frame{.has_page = false};
  const Result<WriteOptions> options = write_options(frame, ink_, format_, picture_);
  if (!options) return tl::unexpected(options.error());
  const Rgba paper = options->paper.value_or(frame.page.paper);
  const Result<std::string> head = svg_head(frame, {.area = options->area, .paper = paper}, ink_);
  if (!head) return tl::unexpected(head.error());
  FELT_CHECK(head->size() == kSvgHeadBytes);
  std::string tail;
  append_svg_group_end(tail);
  append_svg_tail(tail);
  return begin_svg()
      .and_then([&] { return output_.write(tail); })
      .and_then([&] { return output_.overwrite(*head); })
      .and_then([&] { return output_.commit(); });
}

Result<void> DrawingOutput::finish_png() {
  PageOptions options;
  options.dpi = picture_.dpi;
  options.area =
      picture_.area.value_or((ink_.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : ink_).inflated(kMarginMm));
  options.paper = picture_.paper.value_or(options.paper);
  options.grain = picture_.grain;
  Result<PagePainter> page = PagePainter::create(ink_, options);
  if (!page) return tl::unexpected(page.error());
  const Result<void> drawn = spool_.for_each([&](const NamedStroke& named) -> Result<void> {
    page->draw(named.stroke);
    return {};
  });
  if (!drawn) return drawn;
  return encode_png(page->image(), options.dpi).and_then([&](const std::string& bytes) {
    return output_.write_all(bytes);
  });
}

Result<void> DrawingOutput::finish_drawing() {
  DrawingBuilder builder;
  const std::size_t layer = builder.add_layer({"Ink"});
  const Result<void> read = spool_.for_each([&](NamedStroke named) -> Result<void> {
    builder.add(layer, std::move(named.stroke), named.id);
    return {};
  });
  if (!read) return read;
  Drawing drawing = std::move(builder).build();
  lost_ = lost_objects(drawing, format_, picture_.compact);
  return write(std::move(drawing));
}

void note_losses(const std::string& output, const LostObjects& lost, Console& console,
                 const std::string& hint) {
  std::vector<std::string> texts = loss_texts(lost);
  if (lost.hidden_strokes > 0) texts.front() += hint;
  for (const std::string& text : texts) console.notice(output + ": " + text);
}

}  // namespace felt::cli
