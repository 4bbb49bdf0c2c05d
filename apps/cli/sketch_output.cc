#include "sketch_output.h"

#include <utility>

#include "drawing_output.h"
#include "felt/formats/layered_drawing.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/io/picture/png.h"
#include "felt/io/svg/svg_text.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/render/page.h"
#include "felt/render/raster.h"
#include "sketch_spool.h"

namespace felt::cli {
namespace {

/// Lines need no knowledge of the rest: they go out as they come.
class NdjsonOutput final : public SketchOutput {
 public:
  explicit NdjsonOutput(Output output) : output_(std::move(output)) {}

  Result<void> append(const SketchPiece& piece) override { return output_.write(piece.text); }
  Result<void> finish() override { return output_.commit(); }

 private:
  Output output_;
};

/// A picture of all strokes can only be begun when the last one is known: they wait in a spool.
class PngOutput final : public SketchOutput {
 public:
  PngOutput(Output output, const PictureOptions& options)
      : output_(std::move(output)), options_(options) {}

  Result<void> append(const SketchPiece& piece) override {
    bounds_.extend(piece.bounds);
    return spool_.add_lines(piece.text);
  }

  Result<void> finish() override {
    PageOptions page;
    page.dpi = options_.dpi;
    page.sheet = options_.sheet.value_or(bounds_.inflated(page.margin_mm));
    page.paper = options_.paper.value_or(page.paper);
    Result<Image> image = render_page({}, page);  // the paper
    if (!image) return tl::unexpected(image.error());
    const View view = View::at_dpi({page.sheet->x0, page.sheet->y0}, page.dpi);
    const Pixels pixels = image->pixels();
    Rasterizer rasterizer;
    Result<void> drawn = spool_.for_each([&](const SketchStroke& stroke) -> Result<void> {
      rasterizer.draw(stroke.stroke, view, pixels.rect(), options_.grain, pixels);
      return {};
    });
    if (!drawn) return drawn;
    const Result<std::string> bytes = encode_png(*image, page.dpi);
    if (!bytes) return tl::unexpected(bytes.error());
    if (Result<void> written = output_.write(*bytes); !written) return written;
    return output_.commit();
  }

 private:
  Output output_;
  PictureOptions options_;
  SketchSpool spool_;
  Rect bounds_;
};

/// Formats whose writers need all strokes: they become a drawing of one layer, which is written in
/// parts as convert writes any drawing.
class WholeOutput final : public SketchOutput {
 public:
  explicit WholeOutput(DrawingOutput output) : output_(std::move(output)) {}

  Result<void> append(const SketchPiece& piece) override { return spool_.add_lines(piece.text); }

  Result<void> finish() override {
    LayeredSketch layered;
    layered.layers.push_back({"Ink", true, false, {}});
    Result<void> read = spool_.for_each([&](const SketchStroke& stroke) -> Result<void> {
      layered.layers.front().strokes.push_back(stroke);
      return {};
    });
    if (!read) return read;
    OpenedDrawing opened;
    opened.drawing = stored_drawing(std::move(layered));
    return output_.write(std::move(opened));
  }

 private:
  DrawingOutput output_;
  SketchSpool spool_;
};

/// The SVG writer mends the head of its file at the end, so strokes go straight to it.
class SvgOutput final : public SketchOutput {
 public:
  explicit SvgOutput(SvgWriter writer) : writer_(std::move(writer)) {}

  Result<void> append(const SketchPiece& piece) override {
    return writer_.add_text(piece.text, piece.bounds);
  }
  Result<void> finish() override { return writer_.finish(); }

 private:
  SvgWriter writer_;
};

Result<std::unique_ptr<SketchOutput>> open_svg_output(const std::string& path,
                                                      const PictureOptions& picture) {
  SvgOptions options;
  options.sheet = picture.sheet;
  options.paper = picture.paper.value_or(options.paper);
  Result<SvgWriter> writer = SvgWriter::create(path, options);
  if (!writer) return tl::unexpected(writer.error());
  return std::make_unique<SvgOutput>(*std::move(writer));
}

}  // namespace

Result<void> encode(const SketchStroke& stroke, std::int64_t number, Format format,
                    SketchPiece& piece) {
  if (format == Format::kSvg) {
    const Result<void> done =
        append_svg_stroke(piece.text, stroke.id, stroke.stroke, static_cast<std::size_t>(number),
                          SvgOptions{}.tolerance_mm);
    if (!done) return done;
  } else if (Result<void> fits = check_sketch_numbers(stroke.stroke.data()); !fits) {
    return fits;
  } else {
    append_sketch_line(piece.text, stroke.id, stroke.stroke.data());
  }
  piece.bounds.extend(stroke.stroke.bounds());
  return {};
}

Result<std::unique_ptr<SketchOutput>> open_sketch_output(const std::string& path, Format format,
                                                         const PictureOptions& picture) {
  if (is_compressed_name(path)) {
    return fail(ErrorCode::kUnsupported,
                path + ": compressed SVG is written by convert and render; here it is .svg");
  }
  if (format == Format::kSvg) return open_svg_output(path, picture);
  if (format != Format::kPng && format != Format::kNdjson) {
    Result<DrawingOutput> whole = DrawingOutput::create(path, format, picture);
    if (!whole) return tl::unexpected(whole.error());
    return std::make_unique<WholeOutput>(*std::move(whole));
  }
  Result<Output> output = Output::create(path);
  if (!output) return tl::unexpected(output.error());
  if (format == Format::kPng) return std::make_unique<PngOutput>(*std::move(output), picture);
  return std::make_unique<NdjsonOutput>(*std::move(output));
}

Result<void> write_strokes(const Sketch& sketch, Format format, SketchOutput& output) {
  SketchPiece piece;
  std::int64_t number = 0;
  for (const SketchStroke& stroke : sketch) {
    if (Result<void> done = encode(stroke, ++number, format, piece); !done) {
      return tl::unexpected(with_context(done.error(), "stroke " + stroke.id + " of the sketch"));
    }
  }
  if (Result<void> done = output.append(piece); !done) return done;
  return output.finish();
}

}  // namespace felt::cli
