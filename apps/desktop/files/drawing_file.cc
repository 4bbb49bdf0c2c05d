#include "desktop/files/drawing_file.h"

#include <QFileInfo>
#include <array>
#include <string>
#include <utility>

#include "felt/base/read_file.h"
#include "felt/document/visible_strokes.h"
#include "felt/io/ndjson_parser.h"
#include "felt/io/ndjson_writer.h"
#include "felt/io/pdf_writer.h"
#include "felt/io/png.h"
#include "felt/io/svg_reader.h"
#include "felt/io/svg_writer.h"
#include "felt/render/page.h"
#include "felt/session/session.h"
#include "felt/stroke/ink_fitter.h"

namespace felt::desktop {
namespace {

struct Ending {
  const char* text;
  DrawingFormat format;
};
constexpr std::array kEndings = {
    Ending{".felt", DrawingFormat::kFelt},    Ending{".ndjson", DrawingFormat::kSketch},
    Ending{".jsonl", DrawingFormat::kSketch}, Ending{".svg", DrawingFormat::kSvg},
    Ending{".pdf", DrawingFormat::kPdf},      Ending{".png", DrawingFormat::kPng}};

constexpr std::size_t kMaxSketchBytes = std::size_t{2} << 30;
constexpr std::size_t kBatchBytes = std::size_t{64} << 10;
constexpr double kPngDpi = 300.0;

/// Reads the strokes of a .ndjson file; raw pen samples, in mm, are fitted as the pencil would.
class SketchReader {
 public:
  Result<void> add(const NdjsonLine& line) {
    const std::string_view text = line.text();
    const bool is_raw = text.find("\"points\"") != std::string_view::npos &&
                        text.find("\"segments\"") == std::string_view::npos;
    return is_raw ? add_raw(line) : add_fitted(line);
  }

  Sketch sketch;

 private:
  Result<void> add_fitted(const NdjsonLine& line) {
    SketchRecord record;
    const Result<NdjsonKind> kind = parser_.sketch_stroke(line, record);
    if (!kind) return tl::unexpected(kind.error());
    if (*kind == NdjsonKind::kHeader) return {};
    return take(std::move(record.id), Stroke::create(std::move(record.data)));
  }

  Result<void> add_raw(const NdjsonLine& line) {
    const Result<NdjsonKind> kind = parser_.raw_stroke(line, raw_);
    if (!kind) return tl::unexpected(kind.error());
    if (*kind == NdjsonKind::kHeader) return {};
    fitter_.begin();
    for (const InkSample& sample : raw_.samples) fitter_.push(sample);
    fitter_.end();
    fitter_.refine();
    return take(raw_.id, fitter_.stroke());
  }

  Result<void> take(std::string id, Result<Stroke> stroke) {
    if (!stroke) return tl::unexpected(stroke.error());
    sketch.push_back({std::move(id), *std::move(stroke)});
    return {};
  }

  NdjsonParser parser_;
  InkFitter fitter_{InkFitOptions{}};
  RawStroke raw_;
};

Result<Sketch> read_sketch(const std::string& path) {
  const Result<std::string> bytes = read_file(path, kMaxSketchBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  LineReader lines(read_text(*bytes));
  LineBatch batch;
  SketchReader reader;
  for (;;) {
    const Result<bool> more = lines.fill(batch, kBatchBytes);
    if (!more) return tl::unexpected(with_context(more.error(), path));
    if (!*more) break;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const NdjsonLine line = batch.line(i);
      if (Result<void> added = reader.add(line); !added) {
        return tl::unexpected(
            with_context(added.error(), path + ":" + std::to_string(line.number())));
      }
    }
  }
  return std::move(reader.sketch);
}

Drawing drawing_of(const Sketch& sketch) {
  Drawing drawing;
  drawing.document = document_of(sketch);
  return drawing;
}

/// A sheet that the page can be; the page stays what it is for any other.
void set_page(Drawing& drawing, const Rect& sheet, Rgba paper) {
  const auto fits = [](double mm) { return mm >= SheetPage::kLeastMm && mm <= SheetPage::kMostMm; };
  if (sheet.x0 != 0.0 || sheet.y0 != 0.0 || !fits(sheet.width()) || !fits(sheet.height())) return;
  drawing.page = {sheet.width(), sheet.height(), paper};
}

Result<void> write_sketch(const std::string& path, const Sketch& sketch) {
  std::string text;
  append_header_line(text);
  for (const SketchStroke& s : sketch) append_sketch_line(text, s.id, s.stroke.data());
  return write_file(path, text);
}

}  // namespace

Result<DrawingFormat> drawing_format(const QString& path) {
  for (const Ending& ending : kEndings) {
    if (path.endsWith(QLatin1String(ending.text), Qt::CaseInsensitive)) return ending.format;
  }
  return fail(ErrorCode::kUnsupported,
              path.toStdString() +
                  ": there is no format of this ending; there are .felt, .svg, "
                  ".pdf, .png and .ndjson");
}

QString suffix_of(DrawingFormat format) {
  for (const Ending& ending : kEndings) {
    if (ending.format == format) return QString::fromLatin1(ending.text);
  }
  return {};
}

QString with_suffix(const QString& path, DrawingFormat format) {
  const Result<DrawingFormat> present = drawing_format(path);
  return present && *present == format ? path : path + suffix_of(format);
}

Result<Drawing> read_drawing(const QString& path) {
  const Result<DrawingFormat> format = drawing_format(path);
  if (!format) return tl::unexpected(format.error());
  const std::string name = path.toStdString();
  // A pipe or a device may never end, and the window would wait for it.
  if (const QFileInfo info(path); info.exists() && !info.isFile()) {
    return fail(ErrorCode::kUnsupported, name + ": is no file, but a folder, a pipe or a device");
  }
  switch (*format) {
    case DrawingFormat::kFelt:
      return read_felt(name);
    case DrawingFormat::kSketch:
      return read_sketch(name).map([](const Sketch& sketch) { return drawing_of(sketch); });
    case DrawingFormat::kSvg:
      return read_svg(name).map([](const SvgDrawing& svg) {
        Drawing drawing = drawing_of(svg.sketch);
        set_page(drawing, svg.area, svg.paper);
        return drawing;
      });
    case DrawingFormat::kPdf:
    case DrawingFormat::kPng:
      break;
  }
  return fail(ErrorCode::kUnsupported,
              name + ": pictures are written, but not read; open the .felt file they came from");
}

Result<void> write_drawing(const QString& path, const Drawing& drawing) {
  const Result<DrawingFormat> format = drawing_format(path);
  if (!format) return tl::unexpected(format.error());
  const std::string name = path.toStdString();
  if (*format == DrawingFormat::kFelt) return write_felt(name, drawing);
  const Sketch sketch = visible_strokes(drawing.document);
  const Rect sheet = drawing.page.area();
  if (*format == DrawingFormat::kSketch) return write_sketch(name, sketch);
  if (*format == DrawingFormat::kSvg) {
    return write_svg(name, sketch, {.sheet = sheet, .paper = drawing.page.paper});
  }
  if (*format == DrawingFormat::kPdf) {
    return write_pdf(name, sketch, {.sheet = sheet, .paper = drawing.page.paper});
  }
  const Result<Image> image =
      render_page(sketch, {.dpi = kPngDpi, .sheet = sheet, .paper = drawing.page.paper});
  if (!image) return tl::unexpected(with_context(image.error(), name));
  return write_png(name, *image, kPngDpi);
}

}  // namespace felt::desktop
