#include "felt/formats/line_drawing.h"

#include <utility>

#include "felt/formats/file_format.h"
#include "felt/io/ndjson_parser.h"
#include "felt/io/ndjson_writer.h"

namespace felt {
namespace {

constexpr std::size_t kBatchBytes = std::size_t{64} << 10;

class LineImport {
 public:
  explicit LineImport(const ImportOptions& options) : fitter_(options.fit) {}

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
    if (id.empty()) id = "s" + std::to_string(sketch.size() + 1);
    sketch.push_back({std::move(id), *std::move(stroke)});
    return {};
  }

  NdjsonParser parser_;
  InkFitter fitter_;
  RawStroke raw_;
};

}  // namespace

Result<ImportedDrawing> import_lines(std::string_view text, const ImportOptions& options) {
  if (ndjson_content(text.substr(0, kFormatHeadBytes)) == NdjsonContent::kEvents) {
    return fail(ErrorCode::kUnsupported,
                "holds events, not strokes; `feltline replay` draws what they say");
  }
  LineReader lines(read_text(text));
  LineBatch batch;
  LineImport import(options);
  ImportedDrawing result;
  for (;;) {
    const Result<bool> more = lines.fill(batch, kBatchBytes);
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const NdjsonLine line = batch.line(i);
      const Result<void> added = import.add(line);
      if (!added) {
        result.report.add(line.number(), {}, "was left out: " + added.error().message);
      }
    }
  }
  if (import.sketch.empty() && !result.report.empty()) {
    return fail(ErrorCode::kInvalidData, notice_text(result.report.notices().front()));
  }
  result.drawing.layers.push_back({"Ink", true, false, std::move(import.sketch)});
  return result;
}

std::string lines_of(const Sketch& sketch) {
  std::string text;
  append_header_line(text);
  for (const SketchStroke& s : sketch) append_sketch_line(text, s.id, s.stroke.data());
  return text;
}

}  // namespace felt
